"""Tests: what ``and``, ``or`` and ``not`` make of their operands, and whether the whole holds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.narrowing import narrow
from archlint.interpreter.values import NO_PARAMETERS, Known, Unknown, Value, alternatives, one_of, reason, via
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def evaluate_test(machine: Machine, e: facts.Expr) -> tuple[Value, bool | None]:
    """The value of a test, and whether it holds (None where that is not known).  The two are asked for together
    because ``unknown and False`` never holds, though what its value is nobody knows."""
    match e:
        case facts.Boolean():
            return operands(machine, e)
        case facts.Unary(op="not"):
            value, known = evaluate_test(machine, e.operand)
            return (Unknown(reason(value)), None) if known is None else (Known(not known, via(value)), not known)
    value = machine.evaluate(e)
    return value, value.truth(machine)


def operands(machine: Machine, e: facts.Boolean) -> tuple[Value, bool | None]:
    """``and``/``or``: the first operand that decides, or one of those that may; and whether the test holds, which
    a later operand can decide alone."""
    possible: list[Value] = []
    holds: bool | None = None
    stop = e.op == "or"
    pushed = 0
    depth = machine.store.depth
    asked: frozenset[str] = NO_PARAMETERS
    try:
        for number, operand in enumerate(e.values):
            value, verdict = evaluate_test(machine, operand)
            if stop and asked:
                # A placeholder for a parameter that may be empty can be set by that parameter.
                value = one_of(_chosen_by(asked, option) for option in alternatives(value))
            last = number == len(e.values) - 1
            if last or verdict is stop:
                possible.append(value)
                holds = verdict if verdict is stop or not pushed else None
                break
            if verdict is None:
                possible.extend(_with_truth(machine, value, stop))
                asked |= via(*alternatives(value))
                # What follows runs only if this operand did not decide.
                machine.store.push()
                branch = machine.branch_at(e.span, number)
                machine.library.undecided(branch, value)
                machine.branch_arms.append((branch, 0))
                narrow(machine, operand, not stop)
                pushed += 1
    finally:
        for _ in range(pushed):
            machine.branch_arms.pop()
        if pushed:
            machine.store.merge([machine.store.cut(depth), {}])
    return one_of(possible), holds


def _chosen_by(parameters: frozenset[str], value: Value) -> Value:
    return value.chosen_by(parameters) if isinstance(value, Known) else value


def _with_truth(machine: Machine, value: Value, wanted: bool) -> list[Value]:
    """The alternatives of a value that can be as true as wanted; an unknown truth value of a test is itself."""
    return [option for option in alternatives(value) if option.truth(machine) in (None, wanted)]


__all__ = ["evaluate_test", "operands"]
