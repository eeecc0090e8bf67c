"""Arrays of numpy for whose truth code asks, as it asks for None: ``if not self.image:``, ``if self.image == None:``;
and comparisons of one, ``angles >= low and angles <= high``.

Source: ``ndarray.__bool__`` of numpy raises a ValueError for more than one element; ``==``, ``<`` and the like compare
each element.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.numpy_arrays import is_array
from archlint.python_code.plain_kinds import Kind, Values, kind_of, values_in, values_of_self
from archlint.python_code.text_sums import is_its_own
from archlint.python_code.tried_code import tried_for
from archlint.python_code.used_nothing import tests_in
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_EMPTY = (Kind.NONE, Kind.LIST, Kind.BOOL, Kind.NUMBER)
"""What stands in an attribute before the first array comes."""
_ASKS = frozenset({"isinstance", "type"})


@dataclass(frozen=True)
class ArrayTruth:
    """A test that fails as soon as ``what`` is the array that it gets at ``assigned``."""

    place: Place
    what: str
    compared: bool
    """Whether it is compared with None."""
    negated: bool
    """Whether the test holds where there is no array yet."""
    or_none: bool
    """Whether it is None until there is one."""
    assigned: Place
    comparison: str = ""
    """What it is compared with something else by, of which the truth is asked, ``<=``."""
    joined: str = ""
    """``and`` or ``or``, where that joins comparisons to a value that no condition asks for."""


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    what: str
    compared: bool
    negated: bool
    or_none: bool
    assigned: facts.Span
    cls: int | None = None
    comparison: str = ""
    joined: str = ""


def array_truths(workspace: WorkspaceIndex) -> Iterator[ArrayTruth]:
    """Every such test in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for row in _rows(workspace, path) or ():
            if row.cls is None or is_its_own(workspace, path, row.cls, row.what.removeprefix("self.")):
                place, assigned = Place(path, *row.span), Place(path, *row.assigned)
                yield ArrayTruth(
                    place, row.what, row.compared, row.negated, row.or_none, assigned, row.comparison, row.joined
                )


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    expecting = tried_for(code.body, {"ValueError", "Exception", ""})
    rows: list[_Row] = []
    for number, cls in enumerate(classes_of(code)):
        arrays = _arrays(values_of_self(cls), _EMPTY, cls)
        asked = _asked_in(cls) if arrays else frozenset()
        held = {f"self.{name}": array for name, array in arrays.items() if f"self.{name}" not in asked}
        for function in methods_of(cls) if held else ():
            rows += _asking(function, held, expecting, number)
    for function in everything_in(code.body, facts.Function):
        arrays = _arrays(values_in(function), (), None)
        asked = _asked_in(function) if arrays else frozenset()
        held = {name: array for name, array in arrays.items() if name not in asked}
        rows += _asking(function, held, expecting, None)
    return rows


@dataclass(frozen=True)
class _Array:
    """Where an array is made, and whether what holds it may be None."""

    span: facts.Span
    or_none: bool


def _arrays(values: Values, empty: Collection[Kind], cls: facts.Class | None) -> dict[str, _Array]:
    """What holds an array of many elements, and beside that only what is ``empty``.  In the methods of a class, what is
    made of a variable is as that."""
    makers = set(map(Itself[facts.Base], _made_of_variables(cls))) if cls is not None else set()
    arrays: dict[str, _Array] = {}
    for name, given in values.items():
        known = [
            value for value in given if value is not None and (is_array(value) or Itself[facts.Base](value) in makers)
        ]
        others = [value for value in given if not any(value is each for each in known)]
        kinds = [None if value is None else kind_of(value, {}) for value in others]
        if known and all(kind in empty for kind in kinds) and (span := getattr(known[0], "span", None)) is not None:
            arrays[name] = _Array(span, Kind.NONE in kinds)
    return arrays


def _made_of_variables(cls: facts.Class) -> Iterator[facts.Expr]:
    """The values that the methods of a class assign, and that are arrays for the variables in them."""
    for function in methods_of(cls):
        statements = [each for each in everything_in(function.body, facts.Assign) if not is_array(each.value)]
        variables = values_in(function) if statements else {}
        yield from (each.value for each in statements if is_array(each.value, variables))


def _asked_in(part: facts.Class | facts.Function) -> frozenset[str]:
    """What code asks for its class."""
    calls = (call for call in everything_in(part.body, facts.Call) if call.func.last_name in _ASKS)
    return frozenset(argument.value.dotted for call in calls for argument in call.args)


def _asking(
    function: facts.Function, arrays: Mapping[str, _Array], expecting: Set[Itself[facts.Base]], number: int | None
) -> Iterator[_Row]:
    told = {*expecting}
    parts = [*parts_of(function.body)] if arrays else []
    decisive = {Itself(each) for part in parts for test in _conditions(part) for each in everything_in([test])}
    for part in parts:
        is_value = Itself(part) not in decisive
        for test, joined in _truths_in(part):
            for tested, compared, negated in _tested(test):
                if Itself[facts.Base](tested) in told:
                    continue
                comparison = tested.ops[0] if isinstance(tested, facts.Compare) and not compared else ""
                for held in _held(tested):
                    name = f"self.{own}" if (own := of_self(held)) is not None else held.variable
                    if name in arrays and Itself[facts.Base](tested) not in told:
                        told.add(Itself(tested))
                        array = arrays[name]
                        row = _Row(tested.span, name, compared, negated, array.or_none, array.span, number)
                        yield replace(row, comparison=comparison, joined=joined if comparison and is_value else "")


def _truths_in(part: facts.Base) -> Iterator[tuple[facts.Expr, str]]:
    """The expressions for whose truth a piece of code asks.  Of ``a and b`` it is that of ``a``, and the word itself
    where no condition is asked for all of it; of ``a < b < c`` that of ``a < b``."""
    match part:
        case facts.Boolean(op=op, values=values):
            yield from ((value, op) for value in values[:-1])
        case facts.Compare(left=left, ops=[first, _, *_], comparators=[second, *_], span=span):
            yield facts.Compare(left, [first], [second], span), "and"
        case facts.Unary(op="not"):
            yield part, ""
        case _:
            yield from ((test, "") for test in _conditions(part))


def _conditions(part: facts.Base) -> Sequence[facts.Expr]:
    """The conditions that decide what runs, or what a value is."""
    return () if isinstance(part, facts.Boolean) else tests_in(part)


def _held(tested: facts.Name | facts.Attribute | facts.Compare) -> Sequence[facts.Expr]:
    """What may be an array in an expression of whose truth code asks."""
    return [tested.left, *tested.comparators] if isinstance(tested, facts.Compare) else [tested]


def _tested(
    test: facts.Expr, negated: bool = False
) -> Iterator[tuple[facts.Name | facts.Attribute | facts.Compare, bool, bool]]:
    """The names of whose values a test asks for the truth, the comparisons of one with None, and with anything else
    that makes an array of the same length."""
    match test:
        case facts.Unary(op="not", operand=operand):
            yield from _tested(operand, not negated)
        case facts.Boolean(values=values):
            for value in values:
                yield from _tested(value, negated)
        case facts.Name() | facts.Attribute():
            yield test, False, negated
        case facts.Compare(ops=["==" | "!=" as op], comparators=[facts.Literal(value=None)]):
            yield test, True, negated is not (op == "==")
        case facts.Compare(ops=["<" | "<=" | ">" | ">="]):
            yield test, False, negated


__all__ = ["ArrayTruth", "array_truths"]
