"""What a test proves of variables and attributes inside a branch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import set_attribute
from archlint.interpreter.operators import compare_values
from archlint.interpreter.type_tests import classes_of, has_attribute, is_any
from archlint.interpreter.values import (
    Builtin,
    External,
    Known,
    Unknown,
    Value,
    alternatives,
    depends_on,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def narrow(machine: Machine, test: facts.Expr, holds: bool) -> None:
    """Keep what a test proves about a variable or attribute inside a branch."""
    match test:
        case facts.Unary(op="not"):
            narrow(machine, test.operand, not holds)
        case facts.Boolean():
            if (test.op == "and") == holds:
                for value in test.values:
                    narrow(machine, value, holds)
        case facts.Name() | facts.Attribute():
            _keep(machine, test, lambda value: _raw_truth(machine, value) in (None, holds), flag=holds)
        case facts.Assigned():
            narrow(machine, test.target, holds)
        case facts.Call(
            func=facts.Attribute(
                value=facts.Name() | facts.Attribute() as subject, attr="startswith" | "endswith" as end
            ),
            args=[facts.Argument(value=facts.Literal(value=str(part)), keyword=None)],
        ):
            _narrow_text(machine, subject, end, part, holds)
        case facts.Call():
            _narrow_class(machine, test, holds)
        case facts.Compare(
            left=facts.Subscript(value=facts.Name() | facts.Attribute() as subject, index=index),
            ops=["==" | "!=" as op],
            comparators=[facts.Literal(value=str(part))],
        ):
            asked = _end_asked(index)
            if asked is not None and len(part) == 1:
                _narrow_text(machine, subject, asked, part, holds is (op == "=="))
        case facts.Compare(left=facts.Name() | facts.Attribute() as left, ops=[op], comparators=[right]):
            _narrow_compared(machine, left, op, right, holds)


_OPPOSITE: dict[facts.CompareOperator, facts.CompareOperator] = {"is not": "is", "!=": "==", "not in": "in"}


def _narrow_compared(
    machine: Machine, left: facts.Name | facts.Attribute, op: facts.CompareOperator, other: facts.Expr, holds: bool
) -> None:
    """Keep what ``left op other`` proves of ``left``."""
    if op in _OPPOSITE:
        op, holds = _OPPOSITE[op], not holds
    plain = isinstance(other, (facts.Literal, facts.Name, facts.Attribute, facts.Sequence))
    if op not in ("is", "==", "in", "<", "<=", ">", ">=") or not plain:
        return
    right = machine.evaluate(other)
    proven = right if holds and op == "==" and isinstance(right, Known) else None
    _keep(machine, left, lambda value: compare_values(machine, op, value, right) in (None, holds), proven)


def _narrow_class(machine: Machine, test: facts.Call, holds: bool) -> None:
    """Keep the alternatives that are, or may be, of the class, or not of it."""
    if len(test.args) != 2 or any(argument.keyword is not None or argument.star for argument in test.args):
        return
    subject, of = (argument.value for argument in test.args)
    if not isinstance(subject, (facts.Name, facts.Attribute)):
        return
    function, name = machine.evaluate(test.func), of.text
    if function == Builtin("hasattr") and name is not None:
        _keep(machine, subject, lambda value: has_attribute(value, name) in (None, holds))
    if function != Builtin("isinstance"):
        return
    classes = classes_of(machine, machine.evaluate(of))
    if classes is not None:
        _keep(machine, subject, lambda value: is_any(machine, value, classes) in (None, holds))


def _narrow_text(machine: Machine, subject: facts.Name | facts.Attribute, method: str, part: str, holds: bool) -> None:
    """Keep the texts that begin or end with a part, or do not: of ``not prefix.startswith('/')``."""

    def says(text: str) -> bool:
        return text.startswith(part) if method == "startswith" else text.endswith(part)

    # A parameter's default is taken at its word.
    _keep(machine, subject, lambda value: value.text is None or says(value.text) is holds)


def _end_asked(index: facts.Expr) -> str | None:
    """Which end of a text an index is of: ``prefix[0]`` and ``prefix[-1]``."""
    match index:
        case facts.Literal(value=0) | facts.Slice(lower=None, upper=facts.Literal(value=1), step=None):
            return "startswith"
        case facts.Literal(value=-1) | facts.Unary(op="-", operand=facts.Literal(value=1)):
            return "endswith"
    return None


def _raw_truth(machine: Machine, value: Value) -> bool | None:
    """Like :func:`truth`, with a parameter's default taken at its word."""
    return value.is_true if isinstance(value, Known) else value.truth(machine)


def _keep(
    machine: Machine,
    target: facts.Name | facts.Attribute,
    wanted: Callable[[Value], bool],
    proven: Known | None = None,
    flag: bool | None = None,
) -> None:
    """Drop the alternatives that a test rules out; ``flag`` is what it proves of a truth value."""
    if isinstance(target, facts.Attribute) and not target.value.variable:
        return
    before = machine.lookup(target.variable) if target.variable else machine.evaluate(target)
    if before is None:
        return
    after = _narrowed(before, wanted, proven, flag)
    if after is None or after is before:
        return
    if isinstance(before, (Unknown, Known)) and not before.is_closed and after == before:
        return
    if isinstance(target, facts.Name):
        machine.assign_name(target.id, after)
        return
    # A test changes nothing: what it proves of an object that all programs share must not be kept there.
    own = [value for value in alternatives(machine.evaluate(target.value)) if not isinstance(value, External)]
    if own:
        set_attribute(machine, one_of(own), target.attr, after)


def _narrowed(before: Value, wanted: Callable[[Value], bool], proven: Known | None, flag: bool | None) -> Value | None:
    """What a value is after a test.  Where no alternative is left (a parameter's default that this branch
    contradicts), it is what the test proves, or unknown; None where nothing is known to decide it."""
    kept: list[Value] = []
    for value in alternatives(before):
        if flag is not None and value.is_closed and isinstance(value, Known) and value.python_type is bool:
            kept.append(Known(flag, value.via))  # whatever the launch gives, here it is this
        elif wanted(value):
            kept.append(value)
    if kept:
        after = one_of(kept)
        return proven if proven is not None and isinstance(after, Unknown) else after
    if proven is not None:
        return Known(proven.value, before.via)
    name = depends_on(before)
    return None if name is None else Unknown(f"it depends on the parameter '{name}'", name)
