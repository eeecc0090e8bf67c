"""What callbacks await that rclpy's executors cannot wait for: asyncio's awaitables, which need its event loop."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument, judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.finding import Place
from archlint.libraries.tables.event_loops import NEED_A_LOOP, SLEEP, STARTS
from archlint.model import ExecutorKind, Role
from archlint.model.given import Constant
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_RUN_COROUTINES = frozenset(
    {Role.SUBSCRIPTION, Role.TIMER, Role.SERVICE, Role.EXECUTE, Role.GOAL, Role.CANCEL, Role.TASK, Role.GUARD}
)
"""Callbacks that executors run to their end where they are coroutines."""
_RUN_A_LOOP = frozenset(
    {"run", "run_app", "run_until_complete", "run_forever", "run_coroutine_threadsafe", "Runner", "AsyncNode"}
)
"""Calls in whose files somebody may run asyncio's loop around the executor, or a callback in it."""
_NO_LOOP = frozenset({"subprocess.run"})


def foreign_awaits(system: System) -> Iterator[tuple[Program, ApiCall]]:
    """The calls of what needs a loop of asyncio that an executor of rclpy comes to, where no such loop runs."""
    code = source_code(system)
    for program, call in judged_calls(system):
        if call.api in NEED_A_LOOP and _runs_in_executor(call) and _needs_a_loop(code, call):
            files = {program.file, call.place.file, *(frame.place.file for frame in call.chain)}
            if not any(_may_run_a_loop(code, file) for file in files) and not _is_expected(code, call):
                yield program, call


def _runs_in_executor(call: ApiCall) -> bool:
    """Whether an executor of rclpy's own runs what comes to a call."""
    callback = call.context
    return callback.role in _RUN_COROUTINES and (
        callback.node is None or callback.node.executor is not ExecutorKind.UNKNOWN
    )


def _needs_a_loop(code: SourceCode, call: ApiCall) -> bool:
    """Whether it asks for the loop.  ``asyncio.sleep(0)`` only lets others run, in rclpy's executors, too."""
    delay = argument(call, "delay")
    if call.api == SLEEP and not (isinstance(delay, Constant) and delay.seconds != 0 and not delay.parameters):
        return False
    places = [*(frame.place for frame in call.chain), call.place]
    return (call.api == STARTS or _is_awaited(code, call.place)) and all(
        _runs_to(code, hop, inner) for hop, inner in pairwise(places)
    )


def _runs_to(code: SourceCode, hop: Place, inner: Place) -> bool:
    """Whether a call runs the function that holds a place: a coroutine only where it is awaited."""
    function = code.function_at(inner)
    return function is not None and (not function.is_async or _is_awaited(code, hop))


def _is_awaited(code: SourceCode, place: Place) -> bool:
    statement, call = code.statement_at(place), code.call_at(place)
    return call is not None and any(
        isinstance(awaited.value, facts.Call) and awaited.value.span == call.span
        for awaited in parts_of(statement, facts.Await)
    )


def _may_run_a_loop(code: SourceCode, file: str) -> bool:
    read = code.facts_at(file)
    return read is None or any(
        called_name(call) in _RUN_A_LOOP and call.func.dotted not in _NO_LOOP
        for call in everything_in(read.body, facts.Call)
    )


def _is_expected(code: SourceCode, call: ApiCall) -> bool:
    """Whether a ``try`` around it is there for the exception."""
    return any(
        any(Place.of(call.place.file, inner.span) == call.place for inner in calls_in(attempt.body))
        and any("RuntimeError" in handler.caught for handler in attempt.handlers)
        for attempt in statements_of(code.body(call), facts.Try)
    )


def waits_for_an_answer(code: SourceCode, call: ApiCall) -> bool:
    """Whether the first thing that is awaited is a Future of rclpy's: what a client returns for a request, itself or
    by a variable.  asyncio refuses it in a loop of its own, too."""
    values = [argument.value for argument in code.arguments(call)[:1]]
    names = {value.dotted for value in values if isinstance(value, facts.Name)}
    for row in parts_of(code.body(call), facts.Assign) if names else ():
        values += [row.value for target in row.targets if target.dotted in names]
    return any(isinstance(value, facts.Call) and value.func.attribute in _REQUESTS for value in values)


_REQUESTS = frozenset({"call_async", "send_goal_async", "get_result_async", "cancel_goal_async"})


__all__ = ["foreign_awaits", "waits_for_an_answer"]
