"""Whether all that a node creates can be seen: only then is the absence of something worth a word."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import Blueprint
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.nodes import Node


def is_complete(node: Node) -> bool:
    """True where nothing outside of this workspace gets the node or is its base class, and each of its
    endpoints has a known name."""
    if node.blueprint is None or node.program is None or node.doubt is not None:
        return False
    if node.program.exhausted or any(b.caller_unknown or not in_sight(b) for b in node.blueprints):
        return False
    if any(endpoint.name is None or endpoint.resolution in ("partial", "unknown") for endpoint in node.endpoints):
        return False
    return node.blueprint.just_rclpy


def in_sight(blueprint: Blueprint) -> bool:
    """Whether all that is done with a node was followed: no code from elsewhere has it, and nothing was cut short."""
    return blueprint.complete and not blueprint.gaps and not blueprint.escapes


@once_for_each_file
def called_names(file_facts: facts.Facts) -> frozenset[str]:
    """The last names of all that a file calls."""
    return frozenset(call.func.last_name for call in everything_in(file_facts.body, facts.Call)) - {""}


def enclosing_function(workspace: WorkspaceIndex, place: Place) -> facts.Function | None:
    """The innermost function that a place is in."""
    functions = _every_function(workspace, place.file) or ()
    around = [function for function in functions if function.span[0] <= place.line <= function.span[2]]
    return max(around, key=lambda function: function.span[0], default=None)


def enclosing_class(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """The name of the innermost class that a place is in."""
    classes = None if workspace is None else _every_class(workspace, place.file)
    around = [cls for cls in classes or () if cls.span[0] <= place.line <= cls.span[2]]
    return max(around, key=lambda cls: cls.span[0]).name if around else None


@once_for_each_file
def _every_class(file_facts: facts.Facts) -> tuple[facts.Class, ...]:
    return tuple(everything_in(file_facts.body, facts.Class))


@once_for_each_file
def _every_function(file_facts: facts.Facts) -> tuple[facts.Function, ...]:
    return tuple(everything_in(file_facts.body, facts.Function))


__all__ = [
    "called_names",
    "enclosing_class",
    "enclosing_function",
    "in_sight",
    "is_complete",
]
