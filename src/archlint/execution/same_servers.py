"""Waits for a server whose node has just answered under another name: MoveIt's ``move_group`` has many."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import dominates, paths_to
from archlint.analysis.reach import creations_of, judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.ros.move_group import namespace_of_move_group
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in, names_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall
    from archlint.systems.model import System

_FINDS_IT = frozenset(
    {
        "rclpy.client.Client.call",
        "rclpy.client.Client.service_is_ready",
        "rclpy.client.Client.wait_for_service",
        "rclpy.action.client.ActionClient.server_is_ready",
        "rclpy.action.client.ActionClient.wait_for_server",
    }
)
"""Calls that say whether a server is there."""


def has_answered_elsewhere(system: System, call: ApiCall) -> bool:
    """Whether a wait is for a server of ``move_group``, and the code comes to it only where what it has asked of
    another name of the same node came out well: ``if not self.guard.check_state(): return``."""
    namespaces = _namespaces(call)
    if len(namespaces) != 1:
        return False
    code = source_code(system)
    others = [
        other
        for other in _asks_move_group(system).get(id(call.context), ())
        if other.place != call.place and _namespaces(other) == namespaces
    ]
    return bool(others) and all(
        any(_depends_on(code, path, way) for other in others for way in paths_to(other)) for path in paths_to(call)
    )


def _namespaces(call: ApiCall) -> set[str | None]:
    """The namespaces of the ``move_group`` that a call asks; with None where it may ask another node."""
    names = [client.name.text for client in creations_of(call.receiver)]
    return {None if name is None else namespace_of_move_group(name) for name in names}


@once
def _asks_move_group(system: System) -> dict[int, list[ApiCall]]:
    """The calls that find ``move_group``, by the callback (``id``) that comes to them."""
    calls: dict[int, list[ApiCall]] = {}
    for _, call in judged_calls(system):
        if call.api in _FINDS_IT:
            namespaces = _namespaces(call)
            if namespaces and None not in namespaces:
                calls.setdefault(id(call.context), []).append(call)
    return calls


def _depends_on(code: SourceCode, path: Sequence[Place], earlier: Sequence[Place]) -> bool:
    """Whether a way to a call goes on only where a condition has come out so that tests what an earlier one led to."""
    steps = enumerate(zip(path, earlier, strict=False))
    shared = next((number for number, (here, there) in steps if here != there), None)
    if shared is None or not dominates(code, earlier[shared], path[shared]):
        return False
    asked, place = earlier[shared], path[shared]
    graph = graph_of(code.body_at(place))
    results = frozenset(_results(code, asked))
    return any(
        edge.test is not None and _came_out_well(edge.test, edge.holds, asked, results)
        for edge in graph.outcomes(graph.evaluating(place.span))
    )


def _came_out_well(test: facts.Expr, holds: bool, asked: Place, results: frozenset[str]) -> bool:
    """Whether a condition that came out in one way has found what a call returned true, or not None."""
    match test:
        case facts.Unary(op="not"):
            return _came_out_well(test.operand, not holds, asked, results)
        case facts.Boolean() if (test.op == "and") is holds:
            return any(_came_out_well(value, holds, asked, results) for value in test.values)
        case facts.Compare(ops=["is" | "is not" | "==" | "!=" as op], comparators=[facts.Literal(value=None)]):
            return holds is (op in ("is not", "!=")) and _is_result(test.left, asked, results)
        case facts.Name() | facts.Attribute() | facts.Call() | facts.Subscript():
            return holds and _is_result(test, asked, results)
    return False


def _is_result(value: facts.Expr, asked: Place, results: frozenset[str]) -> bool:
    return covers(value, asked.span) or not results.isdisjoint(names_in(value))


def _results(code: SourceCode, asked: Place) -> Iterator[str]:
    """The variables that hold what a call has returned."""
    for statement in everything_in(code.body_at(asked), facts.Assign):
        if covers(statement, asked.span):
            yield from (name for target in statement.targets for name in names_in(target))


__all__ = ["has_answered_elsewhere"]
