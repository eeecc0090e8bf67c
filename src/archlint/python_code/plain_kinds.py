"""What plain values are that code assigns to variables and attributes: numbers, lists, None."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from archlint.python_code.class_chains import targets_of
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.numpy_arrays import is_array
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.parts import Itself, everything_in, targets_in

Values = Mapping[str, Sequence[facts.Expr | None]]
"""All that is assigned to each name; None for what is not one plain value."""


class Kind(StringEnum):
    """What a value is for certain."""

    NONE = "None"
    BOOL = "a bool"
    NUMBER = "a number"
    NUMERIC = "no text"
    """A number, or an array of numpy."""
    LIST = "a list"
    TUPLE = "a tuple"
    DICT = "a dict"
    ARRAY = "an array of numpy"


_OF_PYTHON = {
    "len": Kind.NUMBER,
    "int": Kind.NUMBER,
    "float": Kind.NUMBER,
    "abs": Kind.NUMERIC,
    "round": Kind.NUMERIC,
} | {
    "list": Kind.LIST,
    "sorted": Kind.LIST,
    "dict": Kind.DICT,
    "tuple": Kind.TUPLE,
}
_OF_NUMBERS = frozenset({"-", "/", "//", "**"})
"""What no text takes part in; ``*`` may repeat one, and ``%`` format it."""
_DEPTH = 3


def values_of_self(cls: facts.Class) -> dict[str, list[facts.Expr | None]]:
    """All that the methods of a class assign to each attribute."""
    values: dict[str, list[facts.Expr | None]] = {}
    plain = set[Itself[facts.Base]]()
    for part in everything_in(cls.body, facts.Assign):
        for target, value in assigned_by(part):
            if (name := of_self(target)) is not None:
                plain.add(Itself(target))
                values.setdefault(name, []).append(value)
    for change in everything_in(cls.body, facts.Augmented):
        name = of_self(change.target)
        if name is not None:
            values.setdefault(name, []).append(_changed(change))
    for other in targets_of(cls.body):
        name = of_self(other)
        if name is not None and Itself[facts.Base](other) not in plain:
            values.setdefault(name, []).append(None)
    return values


def values_in(function: facts.Function) -> dict[str, list[facts.Expr | None]]:
    """All that a function assigns to each of its variables."""
    values: dict[str, list[facts.Expr | None]] = {param.name: [None] for param in function.params}
    for part in everything_in(function.body):
        match part:
            case facts.Assign():
                for target, value in assigned_by(part):
                    if target.variable:
                        values.setdefault(target.variable, []).append(value)
            case facts.Augmented(target=facts.Name(id=name)):
                values.setdefault(name, []).append(_changed(part))
            case _:
                for name in bound_by(part):
                    values.setdefault(name, []).append(None)
    return values


def assigned_by(part: facts.Assign) -> Iterator[tuple[facts.Expr, facts.Expr | None]]:
    """What an assignment sets, each with its value; None for one that comes out of something else.  Of
    ``a, b = 1, None`` each name has a value of its own."""
    for target in part.targets:
        match target, part.value:
            case facts.Sequence(elements=targets), facts.Sequence(elements=given) if len(targets) == len(
                given
            ) and not any(isinstance(each, facts.Starred) for each in (*targets, *given)):
                for each, value in zip(targets, given, strict=True):
                    if isinstance(each, facts.Sequence):
                        yield from ((inner, None) for inner in targets_in(each))
                    else:
                        yield each, value
            case facts.Sequence(), _:
                yield from ((each, None) for each in targets_in(target))
            case _:
                yield target, part.value


def _changed(change: facts.Augmented) -> facts.Expr | None:
    """What stands for the value after ``+=`` a number: what is left of that when it is a number."""
    return change.value if change.op in ("+", "-", "*", "/", "//") else None


def kind_of_all(values: Sequence[facts.Expr | None], variables: Values, or_none: bool = False) -> Kind | None:
    """What all of some values are; None where they differ or one is not known.  ``or_none`` leaves out those that are
    None beside others."""
    kinds = {None if value is None else kind_of(value, variables) for value in values}
    if or_none and len(kinds) == 2:
        kinds.discard(Kind.NONE)
    if kinds == {Kind.NUMBER, Kind.NUMERIC}:
        return Kind.NUMERIC
    return kinds.pop() if len(kinds) == 1 else None


def kind_of(value: facts.Expr, variables: Values, depth: int = _DEPTH) -> Kind | None:
    """What an expression is for certain."""
    match value:
        case facts.Literal(value=None):
            return Kind.NONE
        case facts.Literal(value=bool()):
            return Kind.BOOL
        case facts.Literal(value=int() | float()):
            return Kind.NUMBER
        case facts.Unary(op="-" | "+", operand=operand) if depth:
            return Kind.NUMBER if kind_of(operand, variables, depth - 1) is Kind.NUMBER else Kind.NUMERIC
        case facts.Call() if is_array(value):
            return Kind.ARRAY
        case facts.Call(func=facts.Name(id=name)) if name not in variables:
            return _OF_PYTHON.get(name)
        case facts.Call() if value.func.dotted in ("time.time", "time.monotonic"):
            return Kind.NUMBER
        case facts.Sequence(kind="list") | facts.Comprehension(kind="list"):
            return Kind.LIST
        case facts.Sequence(kind="tuple"):
            return Kind.TUPLE
        case facts.Mapping() | facts.Comprehension(kind="dict"):
            return Kind.DICT
        case facts.Binary(op=op, left=left, right=right) if op in _OF_NUMBERS and depth:
            kinds = {kind_of(side, variables, depth - 1) for side in (left, right)}
            if kinds == {Kind.NUMBER}:
                return Kind.NUMBER
            return Kind.NUMERIC if Kind.NUMBER in kinds else None
        case facts.Binary(op="*" | "+" as op, left=left, right=right) if depth:
            return _joined(op, left, right, variables, depth - 1)
        case facts.Name(id=name) if depth and name in variables:
            return kind_of_all(variables[name], {})
    return None


def _joined(op: str, left: facts.Expr, right: facts.Expr, variables: Values, depth: int) -> Kind | None:
    """What lists, tuples and numbers come to: two of them, ``[0.0] * 3``, and ``[0.0] * joints``."""
    kind, other = kind_of(left, variables, depth), kind_of(right, variables, depth)
    if kind is other is Kind.NUMBER:
        return kind
    if op == "+":
        return kind if kind is other and kind in (Kind.LIST, Kind.TUPLE) else None
    if kind not in (Kind.LIST, Kind.TUPLE):
        left, right, kind, other = right, left, other, kind
    is_one = isinstance(left, facts.Sequence) and len(left.elements) == 1  # nobody multiplies an array by it
    is_count = other is Kind.NUMBER or (is_one and isinstance(right, (facts.Name, facts.Attribute)))
    return kind if kind in (Kind.LIST, Kind.TUPLE) and is_count else None


__all__ = ["Kind", "Values", "assigned_by", "kind_of", "kind_of_all", "values_in", "values_of_self"]
