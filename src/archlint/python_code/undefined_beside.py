"""The names that nothing defines in the very statement at which a launch stops for one of them."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import code_of
from archlint.python_code.undefined_names import Undefined, undefined_names

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.syntax import facts
    from archlint.systems.model import WorkspaceIndex


def undefined_beside(workspace: WorkspaceIndex, place: Place) -> list[Undefined]:
    """The other undefined names of the statement that holds a place, in the order of the source."""
    statement = _statement_at(workspace, place)
    return [] if statement is None else _by_statement(workspace)[place.file, statement]


def stops_a_launch(workspace: WorkspaceIndex, read: Undefined) -> bool:
    """Whether a launch stops at the statement of a name, for a name of it."""
    return (read.place.file, _statement_at(workspace, read.place)) in _stopping(workspace)


def _statement_at(workspace: WorkspaceIndex, place: Place) -> facts.Span | None:
    """The span of the statement that holds a place; None for one that has others in it."""
    statement = code_of(workspace).statement_at(place)
    return None if hasattr(statement, "body") else getattr(statement, "span", None)


@once
def _by_statement(workspace: WorkspaceIndex) -> defaultdict[tuple[str, facts.Span], list[Undefined]]:
    rows: defaultdict[tuple[str, facts.Span], list[Undefined]] = defaultdict(list)
    for read in undefined_names(workspace):
        statement = _statement_at(workspace, read.place)
        if statement is not None:
            rows[read.place.file, statement].append(read)
    return rows


@once
def _stopping(workspace: WorkspaceIndex) -> frozenset[tuple[str, facts.Span]]:
    places = (place for launched in workspace.launched for place in launched.undefined)
    rows = ((place.file, _statement_at(workspace, place)) for place in places)
    return frozenset((file, statement) for file, statement in rows if statement is not None)


__all__ = ["stops_a_launch", "undefined_beside"]
