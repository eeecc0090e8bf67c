"""``future.result()`` read straight after ``call_async()``: before anything can have let the answer in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import creations_of, judged_calls, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.straight_after import LOGS, follows_at_once
from archlint.analysis.unused_results import stands_alone, stands_alone_at
from archlint.execution import blocking
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.model import ExecutorKind, Role
from archlint.model.given import Future
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import called_name, calls_in, parts_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Creation, Frame, Program
    from archlint.systems.model import System

_RESULT = "rclpy.task.Future.result"
_SENDS = frozenset({"call_async", "send_goal_async", "get_result_async", "cancel_goal_async"})

_SLEEPS = LOGS | {"sleep"}


@dataclass(frozen=True)
class EarlyResult:
    """A result that is read before the answer can be there."""

    call: ApiCall
    client: Creation
    program: Program
    slept: bool = False
    """Whether the code sleeps before, on the only thread that could take the answer."""


@once
def early_results(system: System) -> list[EarlyResult]:
    """The results that are read straight after the request is sent."""
    results, code = [], source_code(system)
    for program, call in judged_calls(system):
        if call.api != _RESULT or not isinstance(call.receiver, Future):
            continue
        clients = creations_of(call.receiver)
        if clients and _straight_after(code, call, LOGS):
            results.append(EarlyResult(call, clients[0], program))
        elif clients and _only_sleeps(code, call) and _takes_nothing(program, call, clients[0].node):
            results.append(EarlyResult(call, clients[0], program, slept=True))
    return results


def _only_sleeps(code: SourceCode, call: ApiCall) -> bool:
    """Whether nothing but Python's own sleep is between the request and its result."""
    sleeps = [inner for inner in calls_in(code.body(call)) if called_name(inner) in _SLEEPS - LOGS]
    return all(inner.func.dotted == "time.sleep" for inner in sleeps) and _straight_after(code, call, _SLEEPS)


def _takes_nothing(program: Program, call: ApiCall, node: Blueprint) -> bool:
    """Whether the thread that reads the result is the only one that could take the answer."""
    if node.caller_unknown or node.escapes or program.exhausted:
        return False
    if runs_in_executor(call.context):
        return call.context.node is node and threads_of(node, program) == blocking.ONE
    alone = not any(use.in_thread for use in program.executors_of(node)) and node.executor is not ExecutorKind.UNKNOWN
    return alone and program.executable and call.context.role in (Role.INIT, Role.MAIN, Role.MODULE)


def _straight_after(code: SourceCode, call: ApiCall, pastimes: frozenset[str]) -> bool:
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
        and follows_at_once(graph, reads, future.dotted, _sends, pastimes)
        and not any(_awaits_beside(block.fact, result) for block in reads)
    )


def _awaits_beside(statement: facts.Base | None, result: facts.Call) -> bool:
    """Whether a statement awaits something else than what it reads: ``await future.result().get_result_async()`` has
    read the result by then."""
    awaits = parts_of(statement, facts.Await)
    return any(not any(same_expression(inner, result) for inner in calls_in(awaited)) for awaited in awaits)


def _sends(value: facts.Expr) -> bool:
    return isinstance(value, facts.Call) and value.func.attribute in _SENDS


def is_discarded(code: SourceCode, early: EarlyResult) -> bool:
    """Whether nobody uses what is read: the line does no more, or its function returns it to callers that do not."""
    call = early.call
    if stands_alone(code, call):
        return True
    chains = (call.chain, *(chain for chain, _, _ in call.call_chains))
    return _returns(code.statement(call), code.expression(call)) and all(_is_dropped(code, way) for way in chains)


def _is_dropped(code: SourceCode, chain: Sequence[Frame]) -> bool:
    """Whether one of the callers on the way does not use what the function that it calls returns."""
    for frame in reversed(chain):
        if stands_alone_at(code, frame.place):
            return True
        if not _returns(code.statement_at(frame.place), code.call_at(frame.place)):
            return False
    return False


def _returns(statement: facts.Stmt | None, call: facts.Call | None) -> bool:
    return isinstance(statement, facts.Return) and same_expression(statement.value, call)
