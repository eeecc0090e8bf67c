"""``future.result()`` read straight after ``call_async()``: before anything can have let the answer in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import creations_of, judged_calls, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.straight_after import LOGS, follows_at_once
from archlint.model.given import Future
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import calls_in, parts_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.systems.model import System

_RESULT = "rclpy.task.Future.result"
_SENDS = frozenset({"call_async", "send_goal_async", "get_result_async", "cancel_goal_async"})


@dataclass(frozen=True)
class EarlyResult:
    """A result that is read before the answer can be there."""

    call: ApiCall
    client: Creation
    program: Program


@once
def early_results(system: System) -> list[EarlyResult]:
    """The results that are read straight after the request is sent."""
    results, code = [], source_code(system)
    for program, call in judged_calls(system):
        if call.api != _RESULT or not isinstance(call.receiver, Future):
            continue
        clients = creations_of(call.receiver)
        if clients and _straight_after(code, call):
            results.append(EarlyResult(call, clients[0], program))
    return results


def _straight_after(code: SourceCode, call: ApiCall) -> bool:
    result = code.expression(call)
    if result is None or not isinstance(result.func, facts.Attribute):
        return False
    future = result.func.value
    if _sends(future):
        return True  # call_async(...).result()
    graph = graph_of(code.body(call))
    reads = graph.evaluating(result.span)
    return (
        future.dotted != ""
        and follows_at_once(graph, reads, future.dotted, _sends, LOGS)
        and not any(_awaits_beside(block.fact, result) for block in reads)
    )


def _awaits_beside(statement: facts.Base | None, result: facts.Call) -> bool:
    """Whether a statement awaits something else than what it reads: ``await future.result().get_result_async()`` has
    read the result by then."""
    awaits = parts_of(statement, facts.Await)
    return any(not any(same_expression(inner, result) for inner in calls_in(awaited)) for awaited in awaits)


def _sends(value: facts.Expr) -> bool:
    return isinstance(value, facts.Call) and value.func.attribute in _SENDS
