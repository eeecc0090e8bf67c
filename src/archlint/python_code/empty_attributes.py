"""Attributes to which a constructor assigns None alone, and what code does with them that None does not stand."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.python_code.class_chains import methods_of, targets_of
from archlint.python_code.methods_at_work import INIT, of_self
from archlint.python_code.plain_kinds import assigned_by, values_of_self
from archlint.python_code.tried_code import OF_A_WRONG_KIND, tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import is_none

_HAS = frozenset(dir(None))
_ORDER = frozenset({"<", "<=", ">", ">="})
_OF_PYTHON = frozenset({"abs", "enumerate", "float", "int", "iter", "len", "list", "round", "sorted", "sum", "tuple"})
_OF_MODULES = frozenset({"math"})


@dataclass(frozen=True)
class Failing:
    """A use of an attribute of ``self`` that raises ``error`` where it is None."""

    name: str
    span: facts.Span
    error: str


def empty_at_first(code: facts.Class) -> frozenset[str]:
    """The attributes to which the constructor assigns None and nothing else, but for those of which code asserts
    something."""
    empty, filled = set[str](), set[str]()
    for function in methods_of(code):
        if function.name != INIT:
            continue
        none = {Itself[facts.Base](target) for target in _set_to_none(function)}
        for target in targets_of(function.body):
            name = of_self(target)
            if name is not None:
                (empty if Itself[facts.Base](target) in none else filled).add(name)
    asserted = (part for each in everything_in(code.body, facts.Assert) for part in everything_in([each]))
    return frozenset(empty - filled - {of_self(part) for part in asserted})


def _set_to_none(function: facts.Function) -> Iterator[facts.Expr]:
    for part in everything_in(function.body):
        match part:
            case facts.Assign():
                for target, value in assigned_by(part):
                    if value is not None and is_none(value):
                        yield target
            case facts.Annotated(target=target, value=value) if value is not None and is_none(value):
                yield target


def failing_uses(code: facts.Class, names: frozenset[str]) -> dict[facts.Span, Failing]:
    """The uses of some attributes that fail where they are None, by the place of the attribute; not those in code that
    expects it."""
    expecting = tried_for(code.body, OF_A_WRONG_KIND)
    publishers = _publishers(code)
    uses: dict[facts.Span, Failing] = {}
    for part in everything_in(code.body):
        if Itself(part) in expecting:
            continue
        for of, error in _failing(part, publishers):
            name = of_self(of)
            if name in names and isinstance(of, facts.Attribute):
                uses[of.span] = Failing(of.attr, of.span, error)
    return uses


def _publishers(code: facts.Class) -> frozenset[str]:
    """The attributes that are publishers of rclpy and nothing else."""
    values = values_of_self(code)
    return frozenset(
        name
        for name, given in values.items()
        if all(isinstance(each, facts.Call) and each.func.last_name == "create_publisher" for each in given)
    )


def _failing(part: facts.Base, publishers: frozenset[str]) -> Iterator[tuple[facts.Expr, str]]:
    """What a part uses in such a way, with the error that it raises for None."""
    match part:
        case facts.Attribute(value=of, attr=name) if name not in _HAS:
            yield of, "AttributeError"
        case facts.Subscript(value=of) | facts.Call(func=of) | facts.Unary(op="-" | "+" | "~", operand=of):
            yield of, "TypeError"
        case facts.Binary(op=op, left=left, right=right):
            yield left, "TypeError"
            if op != "%":  # a text may be formatted with None
                yield right, "TypeError"
        case facts.Augmented(target=target, op=op, value=value):
            yield target, "TypeError"
            if op != "%":
                yield value, "TypeError"
        case facts.Compare(left=left, ops=[op], comparators=[right]) if op in _ORDER:
            yield left, "TypeError"
            yield right, "TypeError"
        case facts.For(iterable=of, is_async=False):
            yield of, "TypeError"
        case facts.Field(value=of, conversion=None, spec=str(spec)) if spec:
            yield of, "TypeError"
    if isinstance(part, facts.Call) and _takes_no_none(part.func, publishers):
        for argument in part.args[:1]:
            if argument.keyword is None and not argument.star:
                yield argument.value, "TypeError"


def _takes_no_none(func: facts.Expr, publishers: frozenset[str]) -> bool:
    """Whether a function raises a TypeError when its first argument is None."""
    match func:
        case facts.Name(id=name):
            return name in _OF_PYTHON
        case facts.Attribute(value=facts.Name(id=module)) if module in _OF_MODULES:
            return True
        case facts.Attribute(value=of, attr="publish"):
            return of_self(of) in publishers
    return False


__all__ = ["Failing", "empty_at_first", "failing_uses"]
