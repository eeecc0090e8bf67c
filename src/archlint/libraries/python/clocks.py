"""How long a loop that watches the clock goes on: ``while time.monotonic() - start < 1.5``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known
from archlint.syntax import facts
from archlint.syntax.walk import called_name, statements_of

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_CLOCKS = frozenset({"time", "monotonic", "perf_counter"})
"""The functions of the module ``time`` that count seconds."""


def limit_of(run: Run, loop: facts.While | facts.For) -> float | None:
    """The seconds after which a loop of the function that runs now ends in any case; None where nobody knows."""
    if not isinstance(loop, facts.While):
        return None
    test = loop.test
    together = test.values if isinstance(test, facts.Boolean) and test.op == "and" else [test]
    limits = [_limit(run, one) for one in together]
    return min((limit for limit in limits if limit is not None), default=None)


def _limit(run: Run, test: facts.Expr) -> float | None:
    if not isinstance(test, facts.Compare) or len(test.ops) != 1:
        return None
    left, right, op = test.left, test.comparators[0], test.ops[0]
    if op in (">", ">="):
        left, right = right, left
    elif op not in ("<", "<="):
        return None
    if isinstance(left, facts.Binary) and left.op == "-" and _is_clock(left.left):
        return _seconds(run, right)
    if _is_clock(left) and isinstance(right, facts.Name):
        return _until(run, right.id)
    return None


def _until(run: Run, name: str) -> float | None:
    """How far ahead of the clock a deadline is set."""
    values = [
        one.value
        for one in statements_of(run.activation.body)
        if isinstance(one, facts.Assign) and any(isinstance(t, facts.Name) and t.id == name for t in one.targets)
    ]
    found = [
        _seconds(run, value.right)
        for value in values
        if isinstance(value, facts.Binary) and value.op == "+" and _is_clock(value.left)
    ]
    known = [seconds for seconds in found if seconds is not None]
    return max(known) if known and len(known) == len(values) else None


def _is_clock(expression: facts.Expr) -> bool:
    return isinstance(expression, facts.Call) and not expression.args and called_name(expression) in _CLOCKS


def _seconds(run: Run, expression: facts.Expr) -> float | None:
    """What a number, a name or an attribute holds; nothing is called for it, and no parameter decides it."""
    if not isinstance(expression, (facts.Literal, facts.Name, facts.Attribute)):
        return None
    value = run.evaluate(expression)
    if not isinstance(value, Known) or value.via or not isinstance(value.value, (int, float)):
        return None
    return float(value.value)
