"""Loops of a callback that go round until a known time has passed: ``while time.time() - start < 3.0``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.execution.called_here import called_here
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import called_name, statements_of

if TYPE_CHECKING:
    from archlint.syntax.facts import Span

_CLOCKS = frozenset({"time", "monotonic", "perf_counter"})
_DEPTH = 4
"""How many calls lead from a callback to a loop."""
_WAITS = frozenset(
    {"acquire", "call", "get", "input", "join", "read", "readline", "recv", "result"}
    | {"sleep", "sleep_for", "sleep_until", "spin", "spin_once", "spin_until_future_complete", "wait"}
    | {"wait_for_message", "wait_for_server", "wait_for_service", "waitKey"}
)
"""Calls that keep the thread by themselves, of which other rules speak."""
_NANOSECONDS = 1e9
_Numbers = Mapping[str, float]


@dataclass(frozen=True)
class TimedLoop:
    """A loop that takes ``seconds``, in a function that a callback calls, or in the callback."""

    span: Span
    seconds: float
    function: str


def timed_loops(function: facts.Function, file: facts.Facts) -> Iterator[TimedLoop]:
    """The loops without a wait or an early end that a function, or what it calls in the same file, comes to."""
    if not _has_loops(file):
        return
    constants = _constants(file)
    seen: set[tuple[int, tuple[tuple[str, float], ...]]] = set()
    todo: list[tuple[facts.Function, dict[str, float], int]] = [(function, {}, _DEPTH)]
    while todo:
        current, given, depth = todo.pop()
        key = id(current), tuple(sorted(given.items()))
        if key in seen or current.is_async or any(True for _ in parts_of(current.body, facts.Yield)):
            continue
        seen.add(key)
        numbers = {**constants, **given}
        for loop in parts_of(current.body, facts.While):
            seconds = _seconds_of(loop, current, numbers)
            if seconds is not None and not _ends_early(loop) and not _waits(loop):
                yield TimedLoop(loop.span, seconds, current.name)
        if depth > 1:
            for call in parts_of(current.body, facts.Call):
                called = called_here(call, current, file)
                if called is not None:
                    todo.append((called, _given(call, called, numbers), depth - 1))


@once_for
def _has_loops(file: facts.Facts) -> bool:
    return any(True for _ in everything_in(file.body, facts.While))


def _seconds_of(loop: facts.While, function: facts.Function, numbers: _Numbers) -> float | None:
    """The seconds that the test of a loop lets pass."""
    parts = loop.test.values if isinstance(loop.test, facts.Boolean) and loop.test.op == "and" else [loop.test]
    known = [seconds for part in parts if (seconds := _limit(part, function, numbers)) is not None]
    others = [part for part in parts if _limit(part, function, numbers) is None and not _is_ok(part)]
    return min(known) if known and not others else None


def _is_ok(part: facts.Expr) -> bool:
    """``rclpy.ok()``."""
    return isinstance(part, facts.Call) and called_name(part) == "ok"


def _limit(test: facts.Expr, function: facts.Function, numbers: _Numbers) -> float | None:
    match test:
        case facts.Compare(left=clock, ops=["<" | "<="], comparators=[end]):
            pass
        case facts.Compare(left=end, ops=[">" | ">="], comparators=[clock]):
            pass
        case _:
            return None
    scale = _elapsed(clock, function)
    if scale is not None:
        seconds = _duration(end, numbers)
        return None if seconds is None else seconds / scale
    scale = _now(clock)
    return None if scale is None or not end.variable else _ahead(end.variable, function, scale, numbers)


def _elapsed(expression: facts.Expr, function: facts.Function) -> float | None:
    """How many of its units make a second, of an expression that is the time since the function read a clock."""
    match expression:
        case facts.Binary(op="-", left=now, right=start):
            scale = _now(now)
            return scale if scale is not None and _starts(start, function, scale) else None
        case (
            facts.Binary(op="/" as op, left=inner, right=facts.Literal(value=int() | float() as by))
            | facts.Binary(op="*" as op, left=inner, right=facts.Literal(value=int() | float() as by))
        ):
            scale = _elapsed(inner, function)
            return None if scale is None or not by else scale / by if op == "/" else scale * by
        case facts.Attribute(value=inner, attr="nanoseconds"):
            return _NANOSECONDS if _elapsed(inner, function) == 1 else None
        case facts.Name(id=name):
            values = _assigned(function, name)
            return _elapsed(values[0], function) if len(values) == 1 and not isinstance(values[0], facts.Name) else None
    return None


def _now(expression: facts.Expr) -> float | None:
    """How many units a second has, of an expression that asks a clock: 1 for one of Python, or a Time of rclpy."""
    match expression:
        case facts.Call(args=[]):
            return 1.0 if called_name(expression) in _CLOCKS | {"now"} else None
        case facts.Attribute(value=facts.Call(args=[]) as call, attr="nanoseconds"):
            return _NANOSECONDS if called_name(call) == "now" else None
        case facts.Binary(op="/", left=inner, right=facts.Literal(value=int() | float() as by)):
            scale = _now(inner)
            return None if scale is None or not by else scale / by
    return None


def _starts(expression: facts.Expr, function: facts.Function, scale: float) -> bool:
    """Whether a variable is the time at which the function asked the same clock."""
    values = _assigned(function, expression.variable) if expression.variable else []
    return bool(values) and all(_now(value) == scale for value in values)


def _ahead(name: str, function: facts.Function, scale: float, numbers: _Numbers) -> float | None:
    """How many seconds ahead of the clock a variable is set."""
    seconds: list[float] = []
    for value in _assigned(function, name):
        match value:
            case facts.Binary(op="+", left=clock, right=more) if _now(clock) == scale:
                ahead = _duration(more, numbers)
                if ahead is not None:
                    seconds.append(ahead / scale)
                    continue
        return None
    return max(seconds, default=None)


def _duration(expression: facts.Expr, numbers: _Numbers) -> float | None:
    """A number of units, or a Duration of rclpy in seconds."""
    match expression:
        case facts.Literal(value=int() | float() as number) if not isinstance(number, bool):
            return float(number)
        case facts.Name() | facts.Attribute():
            return numbers.get(expression.dotted)
        case facts.Binary(op="*", left=left, right=right):
            first, second = _duration(left, numbers), _duration(right, numbers)
            return None if first is None or second is None else first * second
        case facts.Call(args=[facts.Argument(value=value, keyword="seconds")]) if called_name(expression) == "Duration":
            return _duration(value, numbers)
        case facts.Call(func=facts.Name(id="int" | "float"), args=[facts.Argument(value=value)]):
            return _duration(value, numbers)
    return None


def _assigned(function: facts.Function, name: str) -> list[facts.Expr]:
    """What a function assigns to a variable."""
    return [
        statement.value
        for statement in statements_of(function.body, facts.Assign)
        if any(target.variable == name for target in statement.targets)
    ]


def _ends_early(loop: facts.While) -> bool:
    jumps = (part for part in parts_of(loop.body, facts.Jump) if part.kind == "break")
    return any(True for _ in jumps) or any(
        isinstance(part, (facts.Return, facts.Raise)) for part in parts_of(loop.body)
    )


def _waits(loop: facts.While) -> bool:
    return any(called_name(call) in _WAITS for call in everything_in([loop], facts.Call))


# ---------------------------------------------------------------------------------------------------- what is called


def _given(call: facts.Call, called: facts.Function, numbers: _Numbers) -> dict[str, float]:
    """The numbers that a call gives to parameters that the function then leaves alone."""
    bound = called.params[1:] if isinstance(call.func, facts.Attribute) else called.params
    given = {param.name: param.default for param in bound if param.default is not None}
    for number, argument in enumerate(call.args):
        if argument.star:
            return {}
        name = argument.keyword or (bound[number].name if number < len(bound) else "")
        given[name] = argument.value
    known = {name: _duration(value, numbers) for name, value in given.items() if not _assigned(called, name)}
    return {name: value for name, value in known.items() if value is not None}


@once_for
def _constants(file: facts.Facts) -> dict[str, float]:
    """The numbers that a file gives once, to variables of its own and to attributes."""
    values: dict[str, list[facts.Expr]] = {}
    for statement in everything_in(file.body, facts.Statement):
        for target in statement.assigned:
            if target.dotted:
                value = statement.value if isinstance(statement, (facts.Assign, facts.Annotated)) else None
                values.setdefault(target.dotted, []).append(value or target)
    known = {name: _duration(rows[0], {}) for name, rows in values.items() if len(rows) == 1}
    return {name: value for name, value in known.items() if value is not None}


__all__ = ["TimedLoop", "timed_loops"]
