"""Code that no line leads to, since it stands behind a ``return`` or the like: often the rest of a method whose ``def``
is commented out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.source_code import code_of
from archlint.syntax.flow_facts import is_unreachable

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


def is_behind_an_end(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place in a function of Python comes after the end of its block."""
    return workspace is not None and is_unreachable(code_of(workspace).body_at(place), place.span)


__all__ = ["is_behind_an_end"]
