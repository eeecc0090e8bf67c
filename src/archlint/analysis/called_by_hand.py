"""Callbacks that the program calls itself, on the node that it has just made, and leaves to no executor."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import Blueprint, Creation


def left_to_executor(code: SourceCode, node: Blueprint, served: Sequence[Creation]) -> list[Creation]:
    """What of a node needs an executor, without that of which the function that makes the node calls each callback::

    node = Monitor()
    for _ in range(100):
        node.on_timer()
    """
    called = _called(code, node)
    return [creation for creation in served if not _callbacks(creation) <= called]


def _callbacks(creation: Creation) -> set[str]:
    return {callback.name.rpartition(".")[2] for callback in creation.callbacks.values()}


def _called(code: SourceCode, node: Blueprint) -> set[str]:
    """The methods that the function which makes a node calls on the variable it assigns the node to."""
    place = node.made_at or node.place
    body = list(code.body_at(place))
    variables = {
        target.variable
        for assignment in statements_of(body, facts.Assign)
        if isinstance(assignment.value, facts.Call) and assignment.value.span == place.span
        for target in assignment.targets
        if target.variable
    }
    functions = [call.func for call in calls_in(body)]
    return {f.attr for f in functions if isinstance(f, facts.Attribute) and f.value.variable in variables}


__all__ = ["left_to_executor"]
