"""Loops that try something again: how they end, and for what their pauses are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.execution.future_loops import ends_with_a_future
from archlint.execution.loop_times import CLOCKS, TINY
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of, loop_of
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import names_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.model import ApiCall


def is_retry(code: SourceCode, call: ApiCall) -> bool:
    """Whether a ``for`` that ends as soon as something has worked is around a call: the pause is the exception."""
    loop = code.loop(call)
    return loop is not None and not loop.tests and loop_of(loop).is_left_by_jump


def retries_after_errors(code: SourceCode, call: ApiCall) -> bool:
    """Whether a call is in the ``except`` of a loop that makes some attempts, and that ends as soon as one has worked:
    the pause is for what rarely fails, and has an end."""
    loop = code.loop(call)
    if loop is None or not loop_of(loop).is_left_by_jump or not (not loop.tests or _counts(loop)):
        return False
    handlers = [handler for attempt in statements_of(loop.body, facts.Try) for handler in attempt.handlers]
    return any(covers(handler, call.place.span) for handler in handlers)


def is_step_of_a_retry(code: SourceCode, call: ApiCall) -> bool:
    """Whether an endless loop around a call, or around the call of its function, sleeps after each error, and ends as
    soon as there is none: what keeps its thread is the loop, whatever one of its steps takes."""
    return any(
        _sleeps_after_errors(loop) for place in call.enclosing_loops if (loop := code.loop_at(place)) is not None
    )


def _sleeps_after_errors(loop: Loop) -> bool:
    handlers = [handler for attempt in statements_of(loop.body, facts.Try) for handler in attempt.handlers]
    pauses = [pause for pause in calls_in(loop.body) if called_name(pause) == "sleep"]
    after = any(covers(handler, pause.span) for handler in handlers for pause in pauses)
    return loop.is_endless and loop_of(loop).is_left_by_jump and after


def gives_up_loudly(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a loop looks for something after tiny pauses, and raises once a time has passed: that is rare, and as a
    rule what a device says is there at once."""
    loop = code.loop(call)
    if loop is None or not loop.tests or stay.seconds is None or stay.seconds > TINY:
        return False
    return any(
        not CLOCKS.isdisjoint(names_in(check.test)) and any(True for _ in statements_of(check.body, facts.Raise))
        for check in statements_of(loop.body, facts.If)
    )


def _counts(loop: Loop) -> bool:
    """Whether a ``while`` compares a variable that each of its rounds changes by a number: ``attempts < 10``."""
    changes = statements_of(loop.body, facts.Augmented)
    counters = {
        name for change in changes if isinstance(change.value, facts.Literal) for name in names_in(change.target)
    }
    return any(isinstance(test, facts.Compare) and not counters.isdisjoint(names_in(test)) for test in loop.tests)


def reads_until_it_has(code: SourceCode, call: ApiCall) -> bool:
    """Whether the loop around a call is left with what it has just read: ``frame = camera.read()``, and then
    ``if frame is not None: return frame``.  Then the pauses are for the rare case that nothing comes."""
    loop = code.loop(call)
    if loop is None:
        return False
    read = _made_by_calls(loop)
    graph = graph_of(loop.body)
    return any(
        not read.isdisjoint(names_in(statement.value))
        and any(not read.isdisjoint(names_in(edge.test)) for edge in graph.outcomes(graph.of(statement)))
        for statement, _ in graph.returns
    )


def tries_until_it_works(code: SourceCode, call: ApiCall) -> bool:
    """Whether a ``for`` around a call makes some attempts, and ends as soon as what it has just made is as it should
    be: ``camera = open_camera()``, and then ``if camera.isOpened(): break``."""
    loop = code.loop(call)
    if loop is None or loop.tests:
        return False
    results = _made_by_calls(loop)
    return any(
        not results.isdisjoint(names_in(check.test)) and any(map(_leaves, [*check.body, *check.orelse]))
        for check in statements_of(loop.body, facts.If)
    )


def _made_by_calls(loop: Loop) -> set[str]:
    """The variables that a loop sets to what a call returns."""
    return {
        name
        for assignment in statements_of(loop.body, facts.Assign)
        if any(True for _ in calls_in(assignment.value))
        for target in assignment.targets
        if isinstance(target, (facts.Name, facts.Sequence))
        for name in names_in(target)
    }


def _leaves(statement: facts.Stmt) -> bool:
    is_break = isinstance(statement, facts.Jump) and statement.kind == "break"
    return is_break or isinstance(statement, facts.Return)


def gives_up(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop around a call ends by itself, after some attempts or a time, although nobody knows after how long:
    a ``for`` that is left once something has worked, or ``if elapsed > limit: break`` behind ``elapsed = time.time() -
    start``."""
    return is_retry(code, call) or any(map(_is_timed, code.loops(call)))


def _is_timed(loop: Loop) -> bool:
    times = set(CLOCKS)
    for assignment in statements_of(loop.body, facts.Assign):
        if not times.isdisjoint(names_in(assignment.value)):
            times |= names_in(assignment.targets)
    return any(
        isinstance(check.test, facts.Compare)
        and not times.isdisjoint(names_in(check.test))
        and any(map(_ends_loop, check.body))
        for check in statements_of(loop.body, facts.If)
    )


def _ends_loop(statement: facts.Stmt) -> bool:
    return _leaves(statement) or isinstance(statement, facts.Raise)


def around_future(code: SourceCode, call: ApiCall) -> bool:
    """A loop around a future: that wait is what is wrong, not its pace."""
    return any("done" in names_in(loop.tests) or ends_with_a_future(loop) for loop in code.loops(call))


def is_retried(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop repeats one wait: ``while not future.done()``."""
    tests = (part for loop in code.loops(call) for part in parts_of(loop.tests, facts.Attribute))
    return any(part.attr == "done" for part in tests)
