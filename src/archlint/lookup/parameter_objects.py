"""Parameters that are named where nobody calls a method of the node for them: ``Parameter('rate', …)`` in what the node
sets, ``parameter.name == 'rate'`` in the callback that is told of a change."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.lookup.mentions import Mention, Subject
from archlint.model import Role
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback
    from archlint.systems.model import System

SETTING = frozenset({"rclpy.node.Node.set_parameters", "rclpy.node.Node.set_parameters_atomically"})


def set_by(system: System, call: ApiCall, owner: str, rank: int) -> Iterator[Mention]:
    """The parameters of the list that a node gives itself."""
    for given in source_code(system).arguments(call)[:1]:
        for parameter in everything_in(given.value, facts.Call):
            named = [arg.value for arg in parameter.args if arg.keyword in (None, "name")][:1]
            for name in named if parameter.func.last_name == "Parameter" else ():
                yield from _mention(name, call.place.file, owner, rank)


def compared_in(system: System, callback: Callback, owner: str, rank: int) -> Iterator[Mention]:
    """The parameters whose names a callback for changes asks for."""
    function = source_code(system).function(callback) if callback.role == Role.PARAMETER else None
    for test in everything_in(function, facts.Compare):
        sides = [test.left, *test.comparators]
        if any(side.last_name == "name" and not side.variable for side in sides):
            texts = [item for side in sides for item in everything_in(side, facts.Literal)]
            for text in texts:
                yield from _mention(text, callback.place.file, owner, rank)


def _mention(name: facts.Expr, file: str, owner: str, rank: int) -> Iterator[Mention]:
    if isinstance(name, facts.Literal) and name.text is not None:
        yield Mention(Place.of(file, name.span), Subject("parameter", name.text, owner), "get", rank, name.text)


__all__ = ["SETTING", "compared_in", "set_by"]
