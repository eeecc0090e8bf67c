"""Scripts that no package installs: a file's name makes no executable."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.model import Program
    from archlint.workspace.installed import Installs


def forget_names(
    programs: Iterable[Program],
    started: Iterable[Program],
    installs: Mapping[str, Installs],
    own: Callable[[Sequence[Program]], Sequence[Program]],
) -> list[Program]:
    """The programs, where nodes of scripts that their package does not install have no executable, only the file that
    starts them.

    ``started`` are the programs of entry points; ``own`` gives programs that may be changed.  Where not all is known
    that a package installs, a script keeps the name of its file.
    """
    installed = {id(program) for program in started}
    programs = list(programs)
    nameless = [p for p in programs if id(p) not in installed and _has_no_name(p, installs)]
    changed = {id(program): mine for program, mine in zip(nameless, own(nameless), strict=True)}
    for program in changed.values():
        for node in program.nodes:
            if node.executables:
                node.executables, node.scripts = (), (program.file,)
    return [changed.get(id(program), program) for program in programs]


def _has_no_name(program: Program, installs: Mapping[str, Installs]) -> bool:
    known = installs.get(program.package or "")
    if not program.executable or known is None or not known.build_files:
        return False
    return not known.open_executables and program.name not in known.mentioned
