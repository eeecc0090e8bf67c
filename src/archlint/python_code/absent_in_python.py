"""Names that code takes from modules of Python's library, and that no version of Python has there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.python_names import is_module, lacks
from archlint.python_code.absent_imports import Absent, KnownNames, ModulesInCode
from archlint.python_code.offered_names import starred
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_KNOWN = KnownNames(is_module, lacks)
_ASK_FOR_THE_VERSION = frozenset({"PY2", "PY3", "hexversion", "python_version", "python_version_tuple", "version_info"})
"""What code asks that is written for several versions of Python."""
_OF_MICROPYTHON = frozenset({"machine", "micropython", "pyb", "rp2", "utime"})
"""Modules of a Python for small computers, whose library has other names."""


def absent_in_python(workspace: WorkspaceIndex) -> Iterator[tuple[str, Absent]]:
    """Each such name in the files that were asked for, with its file; not in test code, nor where the workspace has
    modules of that name itself, or adds the name."""
    for file, code in workspace.code.judged():
        path = file.relative
        if workspace.roles.is_test(path):
            continue
        for absent in _absent(workspace, path) or ():
            top = absent.module.partition(".")[0]
            own = top in _stems(workspace) or workspace.code.path_of_import(path, top) is not None
            if not (own or _may_be_rebound(workspace, path, code, absent) or _is_added(workspace, absent)):
                yield path, absent


def _may_be_rebound(workspace: WorkspaceIndex, file: str, code: facts.Facts, absent: Absent) -> bool:
    """Whether a star import may bring what the file calls the module."""
    brought = starred(workspace, file, code)
    return not absent.is_import and (brought is None or brought.has(absent.written.partition(".")[0]))


def _stems(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names of all modules of the workspace, without those of the packages that they are in."""
    return workspace.code.top_modules | {module.rpartition(".")[2] for module in workspace.code.modules}


@kept_for_each_file
def _absent(file_facts: facts.Facts) -> list[Absent]:
    if not _may_lack(file_facts):
        return []
    texts = {literal.text for literal in everything_in(file_facts.body, facts.Literal)}
    return [row for row in ModulesInCode(file_facts, _KNOWN).absent() if row.name not in texts]


def _may_lack(code: facts.Facts) -> bool:
    """Whether a file seems to ask for such a name, at first sight, and is for one Python alone."""
    if not (_ASK_FOR_THE_VERSION | _OF_MICROPYTHON).isdisjoint(code.names):
        return False
    meant: dict[str, str] = {}
    for statement in everything_in(code.body, facts.Import):
        top = statement.module.partition(".")[0]
        meant[statement.alias or top] = statement.module if statement.alias else top
        if top in _OF_MICROPYTHON:
            return False
    for source in everything_in(code.body, facts.ImportFrom):
        if source.module in _OF_MICROPYTHON or any(lacks(source.module, name) for name, _ in source.names):
            return source.module not in _OF_MICROPYTHON
        meant.update((bound, f"{source.module}.{name}") for name, bound in source.names)
    for part in everything_in(code.body, facts.Attribute):
        head, dot, rest = part.value.dotted.partition(".")
        if head in meant and lacks(f"{meant[head]}{dot}{rest}", part.attr):
            return True
    return False


@kept_for_each_file
def _added(file_facts: facts.Facts) -> frozenset[tuple[str, str]]:
    """The attributes that a file assigns to what has a name, with that name."""
    assignments = everything_in(file_facts.body, facts.Assign)
    targets = [target for assignment in assignments for target in assignment.targets]
    return frozenset((t.value.last_name, t.attr) for t in targets if isinstance(t, facts.Attribute))


def _is_added(workspace: WorkspaceIndex, absent: Absent) -> bool:
    """Whether any file assigns the name to a module, or to anything that is called like it."""
    names = {absent.module.rpartition(".")[2], absent.written.rpartition(".")[2]}
    files = workspace.code.files_that_mention(absent.name)
    added = ((_added(workspace, file) or frozenset()) for file in files)
    return any((name, absent.name) in rows for rows in added for name in names)


__all__ = ["absent_in_python"]
