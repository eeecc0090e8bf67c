"""How long sleeps take with the loops around them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from archlint.execution.collection_sizes import most_items
from archlint.execution.future_loops import ends_with_a_future
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of, loop_of
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import names_in
from archlint.syntax.walk import called_name, calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.finding import Place
    from archlint.model import ApiCall

TINY = 0.01
"""Seconds of a pause between the items of something."""

_RUNS_EMPTY = frozenset({"in_waiting", "inWaiting", "out_waiting", "empty", "qsize"})
"""What a loop asks that takes out what is there already: the bytes of a serial port, the items of a queue."""
_CLOCKS = frozenset({"time", "monotonic", "perf_counter", "now", "time_ns"})


def in_loops(
    code: SourceCode, call: ApiCall, stay: Stay, unknown: float = math.inf, *, with_callers: bool = False
) -> float:
    """How many seconds a sleep takes with the loops around it; what nobody knows has no end.

    The loops of callers have no known end, unless they are looked at, too (``with_callers``).  ``unknown`` is how
    often a ``for`` over what is not known is taken to iterate: it has an end, other than a ``while``.
    """
    if stay.seconds is None:
        return math.inf
    seconds = stay.seconds
    loops = [code.loop_at(place) for place in call.loops]
    for loop, limit in reversed(tuple(zip(loops, call.limits, strict=True))):
        seconds = seconds * _times(code, call.file, loop, unknown) if limit is None else max(seconds, limit)
    for place in call.enclosing_loops[: max(0, len(call.enclosing_loops) - len(call.loops))]:
        seconds *= _iterations_at(code, place, unknown) if with_callers else math.inf
    seconds = seconds if stay.seconds > 0 else 0.0
    if math.isinf(seconds) and stay.seconds <= TINY and not any(loop.tests for loop in loops if loop is not None):
        return stay.seconds  # a pause between the bytes or lines of something: it takes many to make it long
    return seconds


def _iterations_at(code: SourceCode, place: Place, unknown: float) -> float:
    """How often the ``for`` of a caller repeats; a ``while`` has no known end."""
    loop = code.loop_at(place)
    return math.inf if loop is None or loop.tests else _times(code, place.file, loop, unknown)


def _times(code: SourceCode, file: str, loop: Loop | None, unknown: float) -> float:
    """How often a loop of a file repeats at most."""
    file_facts = code.facts_at(file)
    if loop is None or file_facts is None:
        return math.inf
    if loop.tests:
        return 1.0 if not _RUNS_EMPTY.isdisjoint(names_in(loop.tests)) else math.inf
    match loop.head:
        case facts.Call(args=given) as call if given and called_name(call) == "range":
            bounds = [argument.value.value for argument in given if isinstance(argument.value, facts.Literal)]
            numbers = [bound for bound in bounds if isinstance(bound, int)]
            return len(range(*numbers)) if len(numbers) == len(given) else unknown
    items = most_items(loop.head, file_facts)
    return unknown if items is None else items


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
    read = {
        name
        for assignment in statements_of(loop.body, facts.Assign)
        if any(True for _ in calls_in(assignment.value))
        for target in assignment.targets
        if isinstance(target, (facts.Name, facts.Sequence))
        for name in names_in(target)
    }
    graph = graph_of(loop.body)
    return any(
        not read.isdisjoint(names_in(statement.value))
        and any(not read.isdisjoint(names_in(edge.test)) for edge in graph.outcomes(graph.of(statement)))
        for statement, _ in graph.returns
    )


def watches_the_clock(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop around a call compares the time with something: ``while time.time() < deadline``."""
    return any(clock_tests(loop) for loop in code.loops(call))


def clock_tests(loop: Loop) -> list[facts.Compare]:
    """The conditions without which a loop ends that compare the time with something."""
    compares = [test for test in loop.tests if isinstance(test, facts.Compare)]
    return [test for test in compares if not _CLOCKS.isdisjoint(names_in(test))]


def around_future(code: SourceCode, call: ApiCall) -> bool:
    """A loop around a future: that wait is what is wrong, not its pace."""
    return any("done" in names_in(loop.tests) or ends_with_a_future(loop) for loop in code.loops(call))


def is_retried(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop repeats one wait: ``while not future.done()``."""
    tests = (part for loop in code.loops(call) for part in parts_of(loop.tests, facts.Attribute))
    return any(part.attr == "done" for part in tests)


def varies_by_iteration(code: SourceCode, call: ApiCall) -> bool:
    """Whether what a call is given depends on the round of a ``for``: ``sleep(PAUSE * (attempt + 1))``."""
    used = names_in(code.expression(call))
    return any(not used.isdisjoint(names_in(to)) for loop in code.loops(call) for to in loop.assigned)
