"""``future.result()`` read straight after ``call_async()``: before anything can have let the answer in."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import creations_of, judged_calls, same_expression
from archlint.analysis.source_code import SourceCode, source_code
from archlint.model.given import Future
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.walk import called_name, calls_in, parts_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Creation, Program
    from archlint.syntax.flow_graph import Graph
    from archlint.systems.model import System

_RESULT = "rclpy.task.Future.result"
_SENDS = frozenset({"call_async", "send_goal_async", "get_result_async", "cancel_goal_async"})
_PASTIMES = frozenset({"get_logger", "debug", "info", "warn", "warning", "error", "print", "format", "str"})
"""Calls that let no time pass."""


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
    name = future.dotted
    return name != "" and _is_sent_just_before(graph_of(code.body(call)), name, result)


def _is_sent_just_before(graph: Graph, name: str, result: facts.Call) -> bool:
    """Whether every way to a result has sent the request, and nothing since that lets time pass."""
    reads = graph.evaluating(result.span)
    tests = {id(block.fact) for block in graph.blocks if isinstance(block.statement, facts.If)}

    def step(sent: bool, fact: facts.Base) -> bool:
        match fact:
            case facts.Assign(value=value) if _binds(fact, name):
                return _sends(value)
            case facts.Assign() | facts.Expression():
                # Whatever is awaited, the executor goes on meanwhile.
                return sent and _idle(list(calls_in(fact))) and not any(parts_of(fact, facts.Await))
        # A condition that asks the future, or anything by a call, may well have waited for it.
        return sent and id(fact) in tests and not any(calls_in(fact)) and not _mentions(fact, name)

    states = graph.states(False, step)
    return bool(reads) and all(
        states.get(block) == frozenset({True}) and not _awaits_beside(block.fact, result) for block in reads
    )


def _awaits_beside(statement: facts.Base | None, result: facts.Call) -> bool:
    """Whether a statement awaits something else than what it reads: ``await future.result().get_result_async()`` has
    read the result by then."""
    awaits = parts_of(statement, facts.Await)
    return any(not any(same_expression(inner, result) for inner in calls_in(awaited)) for awaited in awaits)


def _sends(value: facts.Expr) -> bool:
    return isinstance(value, facts.Call) and value.func.attribute in _SENDS


def _binds(statement: facts.Assign, name: str) -> bool:
    return any(target.dotted == name for target in statement.targets)


def _mentions(fact: facts.Base, name: str) -> bool:
    return any(part.dotted == name for part in parts_of(fact))


def _idle(calls: Sequence[facts.Call]) -> bool:
    return all(called_name(call) in _PASTIMES for call in calls)
