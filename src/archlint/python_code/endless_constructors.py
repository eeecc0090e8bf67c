"""Classes whose constructor never returns: it goes round in a ``while True:`` that nothing leaves, be it in a method
that it calls.  Ctrl-C ends the program there, and not in what stands behind ``robot = Robot()``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from archlint.analysis.closed_guards import constants_of
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_blocks import Edge, Kind, reach
from archlint.syntax.flow_facts import outcome
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in


def endless_classes(code: facts.Facts) -> frozenset[str]:
    """The classes of a file whose constructor never returns."""
    constants = constants_of(code)
    return frozenset(
        cls.name for cls in everything_in(code.body, facts.Class) if CONSTRUCTOR in _endless_methods(cls, constants)
    )


def comes_back(statements: Sequence[facts.Stmt], endless: Set[str]) -> bool:
    """Whether the code goes on behind some statements: they make no object of such a class."""
    return not endless or endless.isdisjoint(
        call.func.variable for statement in statements for call in calls_in(statement)
    )


def _endless_methods(cls: facts.Class, constants: dict[str, bool]) -> frozenset[str]:
    methods = [member for member in cls.body if isinstance(member, facts.Function) and not member.decorators]
    endless: frozenset[str] = frozenset()
    while True:
        more = frozenset(each.name for each in methods if not _returns(each, endless, constants))
        if more == endless:
            return endless
        endless = more


def _returns(function: facts.Function, endless: Set[str], constants: dict[str, bool]) -> bool:
    """Whether any way through a function comes to its end, an exception left out."""

    def goes_on(edge: Edge) -> bool:
        if edge.kind is Kind.RAISE:
            return True
        if edge.test is not None and outcome(edge.test, lambda part: constants.get(part.variable)) is (not edge.holds):
            return False
        return endless.isdisjoint(_own_calls(edge.source.fact))

    if function.is_async or function.is_generator:
        return True
    graph = graph_of(function.body)
    ends = [block for block in graph.exits if block is not graph.raised]
    return not reach([graph.entry], goes_on).isdisjoint(ends)


def _own_calls(fact: facts.Base | None) -> Iterator[str]:
    """The methods of the object that a line calls: ``self.listen()``."""
    for call in calls_in(fact):
        if isinstance(call.func, facts.Attribute) and call.func.value.variable == "self":
            yield call.func.attr


__all__ = ["comes_back", "endless_classes"]
