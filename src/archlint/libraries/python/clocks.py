"""How long a loop that watches the clock goes on: ``while time.monotonic() - start < 1.5``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known
from archlint.libraries.python.countdowns import limit_of_rounds
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.walk import called_name, statements_of

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_CLOCKS = frozenset({"time", "monotonic", "perf_counter"})
"""The functions of the module ``time`` that count seconds."""


def limit_of(run: Run, loop: facts.While | facts.For) -> float | None:
    """The seconds after which a loop of the function that runs now ends in any case; None where nobody knows.

    Its own condition may watch the clock or a counter, or one in its body:
    ``if time.monotonic() - start >= limit: break``.
    """
    flow = loop_of(loop)
    conditions = [condition for edge in flow.endings for condition in edge.sufficient]
    limits = [_limit(run, test, holds) for test, holds in conditions]
    if isinstance(loop, facts.While):
        limits += [limit_of_rounds(run, flow, test, holds) for test, holds in conditions]
    return min((limit for limit in limits if limit is not None), default=None)


def _limit(run: Run, test: facts.Expr, holds: bool) -> float | None:
    """The seconds after which a comparison with the clock comes out so for certain."""
    match test:
        case facts.Compare(left, ["<" | "<="], [right]) if not holds:
            clock, end = left, right
        case facts.Compare(left, [">" | ">="], [right]) if holds:
            clock, end = left, right
        case facts.Compare(left, [">" | ">="], [right]) if not holds:
            clock, end = right, left
        case facts.Compare(left, ["<" | "<="], [right]) if holds:
            clock, end = right, left
        case _:
            return None
    if _is_elapsed(run, clock):
        return _seconds(run, end)
    return _until(run, end.variable) if _is_clock(clock) and end.variable else None


def _is_elapsed(run: Run, expression: facts.Expr) -> bool:
    """Whether an expression is the seconds since something: of the module ``time``, or of the clock of a node, which
    counts nanoseconds."""
    values = _assigned(run, expression.variable) if expression.variable else [expression]
    return bool(values) and all(map(_is_difference, values))


def _is_difference(expression: facts.Expr) -> bool:
    match expression:
        case facts.Binary("-", now) if _is_clock(now):
            return True
        case facts.Binary("*", facts.Attribute(value=of, attr="nanoseconds"), facts.Literal(value=1e-9)):
            return _is_ros_difference(of)
        case facts.Binary("/", facts.Attribute(value=of, attr="nanoseconds"), facts.Literal(value=1e9)):
            return _is_ros_difference(of)
    return False


def _is_ros_difference(expression: facts.Expr) -> bool:
    return isinstance(expression, facts.Binary) and expression.op == "-" and _is_now(expression.left)


def _is_now(expression: facts.Expr) -> bool:
    return isinstance(expression, facts.Call) and not expression.args and called_name(expression) == "now"


def _assigned(run: Run, name: str) -> list[facts.Expr]:
    """What the function assigns to a variable."""
    return [
        statement.value
        for statement in statements_of(run.activation.body, facts.Assign)
        if any(target.variable == name for target in statement.targets)
    ]


def _until(run: Run, name: str) -> float | None:
    """How far ahead of the clock a deadline is set."""
    values = _assigned(run, name)
    ahead = [_ahead(run, value) for value in values]
    known = [seconds for seconds in ahead if seconds is not None]
    return max(known) if known and len(known) == len(values) else None


def _ahead(run: Run, value: facts.Expr) -> float | None:
    match value:
        case facts.Binary("+", clock, seconds) if _is_clock(clock):
            return _seconds(run, seconds)
    return None


def _is_clock(expression: facts.Expr) -> bool:
    return isinstance(expression, facts.Call) and not expression.args and called_name(expression) in _CLOCKS


def _seconds(run: Run, expression: facts.Expr) -> float | None:
    """What a number, a name or an attribute holds, or the larger or smaller of such; nothing else is called for it.  A
    parameter counts as its default."""
    match expression:
        case facts.Call(func=facts.Name(id="max" | "min" as choice), args=given) if given:
            numbers = [_seconds(run, argument.value) for argument in given]
            known = [number for number in numbers if number is not None]
            return None if len(known) < len(numbers) else max(known) if choice == "max" else min(known)
    if not isinstance(expression, (facts.Literal, facts.Name, facts.Attribute)):
        return None
    value = run.evaluate(expression)
    if not isinstance(value, Known) or not isinstance(value.value, (int, float)):
        return None
    return float(value.value)
