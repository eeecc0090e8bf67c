"""Operators and comparisons, over all alternatives of their operands."""

from __future__ import annotations

import operator
import posixpath
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from archlint.interpreter.classes import class_lookup
from archlint.interpreter.containers import ITEM_LIMIT, PYTHON, entries_of, hashable, items_of, new_dict, new_list
from archlint.interpreter.formatting import CARTESIAN, percent_format, plain_text
from archlint.interpreter.values import (
    TEXT_LIMIT,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    ForeignValue,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    ModuleValue,
    Partial,
    Unknown,
    Value,
    alternatives,
    constant,
    file_origin,
    join_texts,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


_ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "//": operator.floordiv,
    "%": operator.mod,
    "**": operator.pow,
    "&": operator.and_,
    "|": operator.or_,
    "^": operator.xor,
    "<<": operator.lshift,
    ">>": operator.rshift,
}


def binary(machine: Machine, op: str, left: Value, right: Value, span: facts.Span) -> Value:
    """``left op right`` over all alternatives."""
    found = [_binary_one(machine, op, one, other, span) for one in alternatives(left) for other in alternatives(right)]
    result = one_of(found[:CARTESIAN])
    return result if is_text(left) else machine.library.lost(result, (left, right), f"it is an operand of '{op}'")


def is_text(value: Value) -> bool:
    return (isinstance(value, Known) and isinstance(value.value, str)) or isinstance(value, Holed)


def _binary_one(machine: Machine, op: str, left: Value, right: Value, span: facts.Span) -> Value:
    left, right = plain_text(machine, left), plain_text(machine, right)
    if op == "+" and (is_text(left) or is_text(right)):
        both_known = isinstance(left, Known) and isinstance(right, Known)
        if both_known and not (is_text(left) and is_text(right)):
            return Unknown("adding a text and something else fails")
        return join_texts((left, right), machine.place(span))
    if op == "/" and isinstance(left, Known) and isinstance(right, Known) and is_text(left) and is_text(right):
        joined = posixpath.join(str(left.value), str(right.value))  # of a pathlib.Path
        return constant(joined, via(left, right), kind="path", origin=file_origin(left, right))
    if op == "%" and is_text(left):
        return percent_format(machine, left, right, span)
    if op == "+" and isinstance(left, ListValue) and isinstance(right, ListValue) and left.kind == right.kind:
        one, other = items_of(machine, left), items_of(machine, right)
        values = one.values + other.values
        long = len(values) > ITEM_LIMIT
        whole = one.whole and other.whole and not long
        return new_list(machine, values[:ITEM_LIMIT], left.kind, one.open or other.open or long, whole)
    if op == "|" and isinstance(left, DictValue) and isinstance(right, DictValue):
        first, second = entries_of(machine, left), entries_of(machine, right)
        return new_dict(machine, {**first.entries, **second.entries}, first.open or second.open)
    if op == "*" and isinstance(left, ListValue) and isinstance(right, Known):
        items = items_of(machine, left)
        if isinstance(right.value, int) and 0 <= right.value * len(items.values) <= ITEM_LIMIT:
            return new_list(machine, items.values * min(right.value, ITEM_LIMIT), left.kind, items.open)
    if isinstance(left, Known) and isinstance(right, Known):
        return _arithmetic(op, left, right)
    return Unknown(reason(left, right), next(iter(sorted(via(left, right))), None))


def _arithmetic(op: str, left: Known, right: Known) -> Value:
    one, other = left.value, right.value
    if op not in _ARITHMETIC:
        return Unknown(f"the operator {op} is not followed")
    big = isinstance(one, (int, float)) and isinstance(other, (int, float))
    if op in ("**", "<<") and (not big or abs(other) > 64):  # type: ignore[arg-type]
        return Unknown("a number too large to follow")
    if op == "*" and (isinstance(one, str) or isinstance(other, str)):
        length = len(one) if isinstance(one, str) else len(other) if isinstance(other, str) else 0
        count = other if isinstance(one, str) else one
        if not isinstance(count, int) or length * count > TEXT_LIMIT:
            return Unknown("a string too long to follow")
    try:
        result = _ARITHMETIC[op](one, other)
    except (TypeError, ValueError, ArithmeticError):
        return Unknown("an operation that fails")
    if not isinstance(result, (str, int, float, bool)):
        return Unknown("an operation whose result is not a constant")
    return constant(result, left.via | right.via)


def compare_values(machine: Machine, op: str, left: Value, right: Value) -> bool | None:
    found = {_compare_one(machine, op, one, other) for one in alternatives(left) for other in alternatives(right)}
    return found.pop() if len(found) == 1 else None


_ORDER: dict[str, Callable[[Any, Any], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


def _compare_one(machine: Machine, op: str, left: Value, right: Value) -> bool | None:
    if op in ("not in", "!=", "is not"):
        opposite = {"not in": "in", "!=": "==", "is not": "is"}[op]
        verdict = _compare_one(machine, opposite, left, right)
        return None if verdict is None else not verdict
    if op == "in":
        return _contains(machine, left, right)
    if isinstance(left, External) and left.path == "sys.version_info":
        return _compare_version(machine, op, right)
    if isinstance(left, Known) and isinstance(right, Known):
        if op == "==":
            return bool(left.value == right.value)
        if op == "is":
            return type(left.value) is type(right.value) and left.value == right.value
        try:
            return bool(_ORDER[op](left.value, right.value))
        except (TypeError, KeyError):
            return None
    if op in ("==", "is"):
        same = _same(left, right)
        return None if same is False and op == "==" and _may_equal(machine, left, right) else same
    return None


def _compare_version(machine: Machine, op: str, right: Value) -> bool | None:
    """``sys.version_info >= (3, 8)``: decided where it is the same for every supported Python."""
    if not isinstance(right, ListValue):
        return None
    numbers = tuple(item.value for item in items_of(machine, right).values if isinstance(item, Known))
    if not numbers or not all(isinstance(number, int) for number in numbers):
        return None
    if numbers <= PYTHON:
        return {">=": True, ">": True, "<": False, "<=": False}.get(op)
    return None


_OBJECTS = (Instance, FunctionValue, BoundMethod, ClassValue)


def _has_identity(value: Value) -> bool:
    """Whether a value is equal to itself alone."""
    return isinstance(value, _OBJECTS) or (isinstance(value, ForeignValue) and value.is_object)


def _same(left: Value, right: Value) -> bool | None:
    for one, other in ((left, right), (right, left)):
        if isinstance(one, Known) and one.value is None and is_object(other):
            return False
    if _has_identity(left) and _has_identity(right):
        return left == right if type(left) is type(right) else False
    if isinstance(left, External) and isinstance(right, External):
        return left == right
    return None


def _may_equal(machine: Machine, left: Value, right: Value) -> bool:
    """Whether two objects may be equal though they are two: messages are, and so are those of some classes."""
    if isinstance(left, ForeignValue) and type(left) is type(right) and left.has_content:
        return True
    return any(_compares(machine, one) for one in (left, right) if isinstance(one, Instance))


def _compares(machine: Machine, value: Instance) -> bool:
    """Whether the class of an object says what is equal, or may do so: it is not here, or one of data."""
    if isinstance(value.cls, External):
        return True
    data = any(
        "dataclass" in path for base in value.cls.mro if isinstance(base, ClassValue) for path in base.decorators
    )
    return (
        data
        or "typing.NamedTuple" in value.cls.external_bases()
        or class_lookup(machine, value.cls, "__eq__")[0] is not None
    )


def is_object(value: Value) -> bool:
    """Whether a value is certainly not None."""
    return _has_identity(value) or isinstance(
        value, (ListValue, DictValue, Holed, ModuleValue, Partial, Builtin, ApiMethod)
    )


def _contains(machine: Machine, item: Value, container: Value) -> bool | None:
    if isinstance(container, Known) and isinstance(container.value, str):
        if isinstance(item, Known) and isinstance(item.value, str):
            return item.value in container.value
        return None
    if isinstance(container, DictValue):
        at = hashable(item)
        entries = entries_of(machine, container)
        if at is None:
            return None
        return True if at in entries.entries else None if entries.open else False
    if isinstance(container, ListValue):
        items = items_of(machine, container)
        verdicts = [_compare_one(machine, "==", item, other) for other in items.values]
        if True in verdicts:
            return True
        return None if None in verdicts or items.open else False
    return None
