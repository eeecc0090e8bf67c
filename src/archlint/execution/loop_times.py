"""How long sleeps take with the loops around them, and whether these watch a clock."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from archlint.execution.collection_sizes import most_items
from archlint.syntax import facts
from archlint.syntax.comparisons import COMPARISONS
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in, names_in
from archlint.syntax.tree import span_of
from archlint.syntax.walk import called_name, parts_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.finding import Place
    from archlint.model import ApiCall

TINY = 0.02
"""Seconds of a pause between the items of something."""

_RUNS_EMPTY = frozenset({"in_waiting", "inWaiting", "out_waiting", "empty", "qsize"})
"""What a loop asks that takes out what is there already: the bytes of a serial port, the items of a queue."""
CLOCKS = frozenset({"time", "monotonic", "perf_counter", "now", "time_ns"})
"""Functions that say what time it is."""


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
        if limit is not None:
            seconds = max(seconds, limit)
            continue
        rounds = _rounds_that_come_to(code, call, loop)
        seconds *= _times(code, call.file, loop, unknown) if rounds is None else rounds
    for place in call.enclosing_loops[: max(0, len(call.enclosing_loops) - len(call.loops))]:
        seconds *= _iterations_at(code, place, unknown) if with_callers else math.inf
    seconds = seconds if stay.seconds > 0 else 0.0
    open_ended = any(loop.tests and not _counts_rounds(loop, stay.seconds) for loop in loops if loop is not None)
    if math.isinf(seconds) and stay.seconds <= TINY and not open_ended:
        return stay.seconds  # a pause between the bytes or lines of something: it takes many to make it long
    return seconds


def _counts_rounds(loop: Loop, pause: float) -> bool:
    """Whether a loop gives up after a number of rounds that it counts one by one, and whose pauses, where the number
    stands there, are less than a second in all."""
    counters = {
        name
        for change in loop.body
        if isinstance(change, facts.Augmented)
        if isinstance(change.value, facts.Literal) and change.value.value == 1
        for name in names_in(change.target)
    }
    checks = [check for check in loop.body if isinstance(check, facts.If) and any(map(_leaves, check.body))]
    tests = [*loop.tests, *(check.test for check in checks)]
    compares = [test for test in tests if isinstance(test, facts.Compare)]
    bounds = [test for test in compares if not counters.isdisjoint(names_in(test))]
    numbers = [part.value for test in bounds for part in parts_of(test, facts.Literal)]
    return bool(bounds) and all(isinstance(number, (int, float)) and number * pause < 1.0 for number in numbers)


def _leaves(statement: facts.Stmt) -> bool:
    is_break = isinstance(statement, facts.Jump) and statement.kind == "break"
    return is_break or isinstance(statement, (facts.Return, facts.Raise))


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
    if isinstance(loop.head, facts.Call) and loop.head.args and called_name(loop.head) == "range":
        numbers = _range_of(loop.head)
        return unknown if numbers is None else len(numbers)
    items = most_items(loop.head, file_facts)
    return unknown if items is None else items


def loops_of_first_way(code: SourceCode, call: ApiCall) -> tuple[Place, ...]:
    """The loops on the way that a call was first met on: where that has none, the call has those of another way."""
    way = [*(frame.place for frame in call.chain), call.place]
    return tuple(
        loop
        for loop in call.enclosing_loops
        for fact in [code.loop_at(loop)]
        if any(place.file == loop.file and covers(fact, place.span) for place in way if fact is not None)
    )


def literal_rounds(loop: Loop | None) -> int | None:
    """How many rounds a loop over numbers takes whose bounds stand there: ``for _ in range(3):``."""
    numbers = None if loop is None else _range_of(loop.head)
    return None if numbers is None else len(numbers)


def _range_of(head: facts.Expr | None) -> range | None:
    """The numbers of ``range(3)``, where they stand there."""
    match head:
        case facts.Call(args=given) as call if given and called_name(call) == "range":
            bounds = [argument.value.value for argument in given if isinstance(argument.value, facts.Literal)]
            numbers = [bound for bound in bounds if isinstance(bound, int)]
            return range(*numbers) if len(numbers) == len(given) else None
    return None


def _rounds_that_come_to(code: SourceCode, call: ApiCall, loop: Loop | None) -> int | None:
    """How many rounds of a ``for`` over numbers come to a call that a test of the number is before: ``if attempt < 2``.
    None where no test says that."""
    numbers = None if loop is None else _range_of(loop.head)
    if loop is None or numbers is None:
        return None
    left = [*numbers]
    for statement in everything_in(code.body(call), facts.For):
        if span_of(statement.iterable) != span_of(loop.head):
            continue
        for branch in everything_in(statement.body, facts.If):
            match branch.test:
                case facts.Compare(
                    left=facts.Name(id=name), ops=[op], comparators=[facts.Literal(value=int(bound))]
                ) if op in COMPARISONS and name == statement.target.variable:
                    inside = any(covers(each, call.place.span) for each in branch.body)
                    other = any(covers(each, call.place.span) for each in branch.orelse)
                    if inside or other:
                        left = [number for number in left if COMPARISONS[op](number, bound) == inside]
    return None if len(left) == len(numbers) else len(left)


def watches_the_clock(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop around a call compares the time with something: ``while time.time() < deadline``."""
    return any(clock_tests(loop) for loop in code.loops(call))


def clock_tests(loop: Loop) -> list[facts.Compare]:
    """The conditions without which a loop ends that compare the time with something."""
    compares = [test for test in loop.tests if isinstance(test, facts.Compare)]
    return [test for test in compares if not CLOCKS.isdisjoint(names_in(test))]


def varies_by_iteration(code: SourceCode, call: ApiCall) -> bool:
    """Whether what a call is given depends on the round of a ``for``: ``sleep(PAUSE * (attempt + 1))``."""
    used = names_in(code.expression(call))
    return any(not used.isdisjoint(names_in(to)) for loop in code.loops(call) for to in loop.assigned)
