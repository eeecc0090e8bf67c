"""Code that no line leads to, since it stands behind a ``return`` or the like: often the rest of a method whose ``def``
is commented out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import is_unreachable
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


def is_behind_an_end(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place in a function of Python comes after the end of its block."""
    code = None if workspace is None else workspace.facts_at(place.file)
    span = place.line, place.column, place.end_line, place.end_column
    functions = everything_in(code.body, facts.Function) if code is not None else ()
    return any(is_unreachable(function.body, span) for function in functions)


__all__ = ["is_behind_an_end"]
