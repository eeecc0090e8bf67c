"""Scripts that no package installs: a file's name makes no executable."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.model import Program
    from archlint.workspace.installed import Installs


def forget_names(programs: Iterable[Program], started: Iterable[Program], installs: Mapping[str, Installs]) -> None:
    """Nodes of scripts that their package does not install have no executable, only the file that starts them.

    ``started`` are the programs of entry points.  Where not all is known that a package installs, a script keeps the
    name of its file.
    """
    installed = {id(program) for program in started}
    for program in programs:
        known = installs.get(program.package or "")
        if id(program) in installed or not program.executable or known is None or not known.build_files:
            continue
        if not known.open_executables and program.name not in known.mentioned:
            for node in program.nodes:
                if node.executables:
                    node.executables, node.scripts = (), (program.file,)
