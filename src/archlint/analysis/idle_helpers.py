"""What of helper modules no node comes to: functions and classes that nothing names but each other."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.syntax import facts
from archlint.syntax.parts import names_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex


def is_idle_helper(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place is in a function or a class at the top of a module that names nothing of ROS, where neither the
    code of the module nor any other file comes to its name; or in what the module does only as a program."""
    if workspace is None or place.file not in workspace.code.helpers:
        return False
    rows = _definitions(workspace, place.file) or []
    holding = [row for row in rows if row[0] and row[1] <= place.line <= row[2]]
    if not holding:
        return False
    return holding[0][0] == _AS_PROGRAM or holding[0][0] not in _live(workspace, place.file, rows)


_AS_PROGRAM = "__main__"
_Definition = tuple[str, int, int, list[str]]
"""The name of a function or class, empty for all code beside these, its first and last line, and the names in it."""


@kept_for_each_file
def _definitions(code: facts.Facts) -> list[_Definition]:
    rows: list[_Definition] = []
    guard = main_guard(code)
    for statement in code.body:
        names = sorted(names_in([statement]))
        match statement:
            case facts.Function(name=name, span=span) | facts.Class(name=name, span=span):
                rows.append((name, span[0], span[2], names))
            case facts.If(span=span) if statement is guard:
                rows.append((_AS_PROGRAM, span[0], span[2], names))
            case _:
                rows.append(("", 0, 0, names))
    return rows


def _live(workspace: WorkspaceIndex, file: str, rows: Collection[_Definition]) -> set[str]:
    """The names to which code comes."""
    waiting = [*_named_by_others(workspace, file, rows)]
    waiting += [name for own, _, _, names in rows if not own for name in names]
    live: set[str] = set()
    while waiting:
        name = waiting.pop()
        if name not in live:
            live.add(name)
            waiting += [used for own, _, _, names in rows if own == name for used in names]
    return live


def _named_by_others(workspace: WorkspaceIndex, file: str, rows: Collection[_Definition]) -> Iterator[str]:
    """The names of a module for which other files have a word."""
    for name, _, _, _ in rows:
        if name not in ("", _AS_PROGRAM) and any(other != file for other in workspace.code.files_that_mention(name)):
            yield name


__all__ = ["is_idle_helper"]
