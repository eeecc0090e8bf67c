"""Operators and comparisons, over all alternatives of their operands."""

from __future__ import annotations

import operator
import posixpath
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from archlint.interpreter.containers import ITEM_LIMIT, PYTHON, entry_key, new_dict, new_list
from archlint.interpreter.formatting import CARTESIAN, percent_format, plain_text
from archlint.interpreter.values import (
    TEXT_LIMIT,
    Constant,
    DictValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    constant,
    depends_on,
    file_origin,
    join_texts,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


_ARITHMETIC: dict[facts.BinaryOperator, Callable[[Any, Any], Any]] = {
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


def binary(machine: Machine, op: facts.BinaryOperator, left: Value, right: Value, span: facts.Span) -> Value:
    """``left op right`` over all alternatives."""
    results = [_combined(machine, op, a, b, span) for a in alternatives(left) for b in alternatives(right)]
    result = chosen_with(one_of(results[:CARTESIAN]), left, right)
    return result if left.is_text else machine.library.lost(result, (left, right), f"it is an operand of '{op}'")


def _combined(machine: Machine, op: facts.BinaryOperator, left: Value, right: Value, span: facts.Span) -> Value:
    left, right = plain_text(machine, left), plain_text(machine, right)
    match op, left, right:
        case "+", _, _ if left.is_text or right.is_text:
            return _joined_texts(machine, left, right, span)
        case "/", Known(value=str(folder)), Known(value=str(name)):  # of a pathlib.Path
            joined = posixpath.join(folder, name)
            return constant(joined, via(left, right), kind="path", origin=file_origin(left, right))
        case "%", _, _ if left.is_text:
            return percent_format(machine, left, right, span)
        case "+", ListValue(), ListValue() if left.kind == right.kind:
            return _joined_lists(machine, left, right)
        case "|", DictValue(), DictValue():
            first, second = left.entries(machine), right.entries(machine)
            return new_dict(machine, {**first.entries, **second.entries}, first.open or second.open)
        case "*", ListValue(), Known(value=int(times)):
            items = left.items(machine)
            if 0 <= times * items.size <= ITEM_LIMIT:
                return new_list(machine, items.values * min(times, ITEM_LIMIT), left.kind, items.open)
        case _, Known(), Known():
            return _arithmetic(op, left, right)
    return Unknown(reason(left, right), depends_on(left, right), of_class=_class_of_result(op, left, right))


_OF_NUMBERS: frozenset[facts.BinaryOperator] = frozenset({"+", "-", "*", "//", "%"})
"""The operators that give an int of two ints, and a float where one is a float."""


def _class_of_result(op: facts.BinaryOperator, left: Value, right: Value) -> str | None:
    """``int`` or ``float``, for an operation on two numbers of these classes."""
    classes = {left.number_class, right.number_class}
    if not classes <= {"int", "float"}:
        return None
    if op == "/":
        return "float"
    return ("float" if "float" in classes else "int") if op in _OF_NUMBERS else None


def _joined_texts(machine: Machine, left: Value, right: Value, span: facts.Span) -> Value:
    match left, right:
        case Known(), Known() if not (left.is_text and right.is_text):
            return Unknown("adding a string and something else fails")
    return join_texts((left, right), machine.place(span))


def _joined_lists(machine: Machine, left: ListValue, right: ListValue) -> Value:
    first, second = left.items(machine), right.items(machine)
    values = first.values + second.values
    long = len(values) > ITEM_LIMIT
    exhaustive = first.exhaustive and second.exhaustive and not long
    return new_list(machine, values[:ITEM_LIMIT], left.kind, first.open or second.open or long, exhaustive)


def _arithmetic(op: facts.BinaryOperator, left: Known, right: Known) -> Value:
    if op not in _ARITHMETIC:
        return Unknown(f"the operator {op} is not followed")
    match op, left.value, right.value:
        case "**" | "<<", int() | float(), int(exponent) | float(exponent):
            if abs(exponent) > 64:
                return Unknown("a number too large to follow")
        case "**" | "<<", _, _:
            return Unknown("a number too large to follow")
        case ("*", str(text), int(times)) | ("*", int(times), str(text)):
            if len(text) * times > TEXT_LIMIT:
                return Unknown("a string too long to follow")
        case ("*", str(), _) | ("*", _, str()):
            return Unknown("a string too long to follow")
    try:
        result = _ARITHMETIC[op](left.value, right.value)
    except (TypeError, ValueError, ArithmeticError):
        return Unknown("an operation that fails")
    if not isinstance(result, (str, int, float)):
        return Unknown("an operation whose result is not a constant")
    return constant(result, left.via | right.via)


def compare_values(machine: Machine, op: facts.CompareOperator, left: Value, right: Value) -> bool | None:
    """``left op right`` where all alternatives agree."""
    lefts, rights = alternatives(left), alternatives(right)
    if len(lefts) == len(rights) == 1:
        return _compared(machine, op, lefts[0], rights[0])  # as in most tests
    verdicts = {_compared(machine, op, a, b) for a in lefts for b in rights}
    return verdicts.pop() if len(verdicts) == 1 else None


_ORDER: dict[facts.CompareOperator, Callable[[Any, Any], bool]] = {
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


_OPPOSITE: dict[facts.CompareOperator, facts.CompareOperator] = {"not in": "in", "!=": "==", "is not": "is"}


def _compared(machine: Machine, op: facts.CompareOperator, left: Value, right: Value) -> bool | None:
    if op in _OPPOSITE:
        verdict = _compared(machine, _OPPOSITE[op], left, right)
        return None if verdict is None else not verdict
    if op == "in":
        return _contains(machine, left, right)
    match left, right:
        case External(path="sys.version_info"), _:
            return _compare_version(machine, op, right)
        case Known(), Known():
            return _compare_constants(op, left.value, right.value)
        case (Holed() as holed, Known(value=str(text))) | (Known(value=str(text)), Holed() as holed) if op == "==":
            return None if holed.may_be(text) else False
        case (Instance(is_member=True) as member, Known()) | (Known(), Instance(is_member=True) as member):
            return False if op in ("==", "is") and _is_no_number(machine, member) else None
    if op in ("==", "is"):
        same = _same(left, right)
        return None if same is False and op == "==" and _may_equal(machine, left, right) else same
    return None


def _compare_constants(op: facts.CompareOperator, left: Constant, right: Constant) -> bool | None:
    if op == "==":
        return bool(left == right)
    if op == "is":
        return type(left) is type(right) and left == right
    try:
        return bool(_ORDER[op](left, right))
    except (TypeError, KeyError):
        return None


def _compare_version(machine: Machine, op: facts.CompareOperator, right: Value) -> bool | None:
    """``sys.version_info >= (3, 8)``: decided where it is the same for every supported Python."""
    items = right.items(machine)
    numbers = () if items is None else tuple(item.constant for item in items.values if item.constant is not None)
    integers = [number for number in numbers if isinstance(number, int)]
    if not numbers or len(integers) < len(numbers) or tuple(integers) > PYTHON:
        return None
    return {">=": True, ">": True, "<": False, "<=": False}.get(op)


def _same(left: Value, right: Value) -> bool | None:
    if (left.is_none and right.is_object) or (right.is_none and left.is_object):
        return False
    if left.has_identity and right.has_identity:
        return left == right if type(left) is type(right) else False
    if left.dotted and right.dotted:
        return left == right
    return None


def _may_equal(machine: Machine, left: Value, right: Value) -> bool:
    """Whether two objects may be equal though they are two: messages are, and so are those of some classes."""
    if type(left) is type(right) and left.has_content:
        return True
    return any(isinstance(side, Instance) and _compares(machine, side) for side in (left, right))


def _compares(machine: Machine, value: Instance) -> bool:
    """Whether the class of an object says what is equal, or may do so: it is not here, or one of data."""
    cls = value.own_class
    if cls is None:
        return True
    data = any("dataclass" in path for base in cls.classes for path in base.decorators)
    return data or "typing.NamedTuple" in cls.external_bases() or cls.lookup(machine, "__eq__")[0] is not None


def _is_no_number(machine: Machine, member: Instance) -> bool:
    """Whether a member of an enum equals members alone, and nothing that it stands for, as one of an ``IntEnum``."""
    cls = member.own_class
    return cls is not None and set(cls.external_bases()) == {"enum.Enum"} and not _compares(machine, member)


def _contains(machine: Machine, item: Value, container: Value) -> bool | None:
    match container:
        case Known(value=str(text)):
            return None if item.text is None else item.text in text
        case DictValue():
            at, entries = entry_key(machine, item), container.entries(machine)
            if at is None:
                return None
            return True if at in entries.entries else None if entries.open else False
        case ListValue():
            items = container.items(machine)
            verdicts = [_compared(machine, "==", item, other) for other in items.values]
            if True in verdicts:
                return True
            return None if None in verdicts or items.open else False
    return None
