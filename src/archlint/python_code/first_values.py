"""The constants that a constructor assigns to attributes, and what conditions come out as before anything else does."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from functools import partial

from archlint.python_code.class_chains import targets_of
from archlint.python_code.methods_at_work import INIT, MethodsAtWork, of_self
from archlint.syntax import facts
from archlint.syntax.flow_facts import outcome
from archlint.syntax.parts import everything_in, once_for, parts_of

_UNKNOWN = object()
_EMPTY: tuple[()] = ()
"""Stands for any list, set or dict without items."""
_COMPARE: Mapping[str, Callable[[object, object], bool]] = {
    "==": operator.eq,
    "!=": operator.ne,
    "is": operator.is_,
    "is not": operator.is_not,
}
_ORDER: Mapping[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


def first_values(work: MethodsAtWork) -> Mapping[str, object]:
    """The attributes to which the constructor assigns one constant, or something empty, at its top level."""
    init = work.methods.get(INIT)
    return {} if init is None else _values_of(init)


@once_for
def _values_of(init: facts.Function) -> dict[str, object]:
    targets = [name for target in targets_of(init.body) if (name := of_self(target)) is not None]
    values: dict[str, object] = {}
    for statement in init.body:
        match statement:
            case facts.Assign(targets=[target], value=value) | facts.Annotated(target=target, value=value):
                name = of_self(target)
                if name is not None and value is not None and targets.count(name) == 1:
                    values[name] = _constant(value)
    changed = {of_self(part.target) for part in everything_in(init.body, facts.Augmented)}
    filled = {
        of_self(call.func.value) for call in parts_of(init.body, facts.Call) if isinstance(call.func, facts.Attribute)
    }
    return {name: value for name, value in values.items() if value is not _UNKNOWN and name not in changed | filled}


def _constant(value: facts.Expr) -> object:
    match value:
        case facts.Literal(value=constant):
            return constant
        case facts.Unary(op="-", operand=facts.Literal(value=int() | float() as number)):
            return -number
        case facts.Sequence(elements=[]) | facts.Mapping(keys=[]):
            return _EMPTY
        case facts.Call(func=facts.Name(id="list" | "dict" | "set"), args=[]):
            return _EMPTY
    return _UNKNOWN


def holds(test: facts.Expr, values: Mapping[str, object]) -> bool | None:
    """How a condition comes out with some attributes of ``self``; None where they do not decide it."""
    return outcome(test, partial(_holds, values=values))


def _holds(test: facts.Expr, values: Mapping[str, object]) -> bool | None:
    """:func:`holds` of what neither ``not`` nor ``and`` nor ``or`` joins."""
    match test:
        case facts.Compare(left=left, ops=[sign], comparators=[right]):
            return _compared(_value(left, values), sign, _value(right, values))
    value = _value(test, values)
    return None if value is _UNKNOWN else bool(value)


def _value(part: facts.Expr, values: Mapping[str, object]) -> object:
    name = of_self(part)
    if name is not None:
        return values.get(name, _UNKNOWN)
    match part:
        case facts.Call(func=facts.Name(id="len"), args=[facts.Argument(value=inner)]):
            return 0 if _value(inner, values) is _EMPTY else _UNKNOWN
    return _constant(part)


def _compared(left: object, sign: str, right: object) -> bool | None:
    if left is _UNKNOWN or right is _UNKNOWN:
        return None
    if sign in _COMPARE:
        return _COMPARE[sign](left, right)
    if sign in _ORDER and isinstance(left, (int, float)) and isinstance(right, (int, float)):
        return _ORDER[sign](left, right)
    return None


__all__ = ["first_values", "holds"]
