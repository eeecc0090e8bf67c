"""Lists, tuples, numbers and None that code looks into as if they were objects: ``self.goal.x`` of ``[0.0, 0.0]``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Union

from archlint.analysis.kept import kept_for_each_file, once
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.numpy_arrays import ATTRIBUTES
from archlint.python_code.plain_kinds import Kind, Values, kind_of_all, values_in, values_of_self
from archlint.python_code.text_sums import is_its_own
from archlint.python_code.tried_code import tried_for
from archlint.python_code.used_nothing import tests_in
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_TYPES: dict[Kind, tuple[type, ...]] = {
    Kind.NONE: (type(None),),
    Kind.BOOL: (bool,),
    Kind.NUMBER: (int, float),
    Kind.LIST: (list,),
    Kind.TUPLE: (tuple,),
    Kind.DICT: (dict,),
}
HAVE = {kind: frozenset(name for type_ in types for name in dir(type_)) for kind, types in _TYPES.items()}
HAVE[Kind.ARRAY] = ATTRIBUTES
"""The attributes of each kind of values."""
ASKS = frozenset({"callable", "getattr", "hasattr", "isinstance", "type"})


_Use = Union[facts.Attribute, facts.Call, facts.Subscript]


class Misuse(StringEnum):
    """What code does with a value that it does not stand."""

    LOOKS_INTO = "looks into"
    CALLS = "calls"
    TAKES_ITEM = "takes item"


@dataclass(frozen=True)
class MisusedKind:
    """``self.goal.x``, where ``self.goal`` is a list; ``assigned`` is one of the places that say so."""

    place: Place
    what: str
    kind: Kind
    misuse: Misuse
    name: str
    assigned: Place


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    what: str
    kind: Kind
    misuse: Misuse
    name: str
    assigned: facts.Span
    cls: int | None = None


@once
def misused_kinds(workspace: WorkspaceIndex) -> list[MisusedKind]:
    """Every such use in the files that were asked for, but for test code."""
    return [*_misused(workspace)]


def _misused(workspace: WorkspaceIndex) -> Iterator[MisusedKind]:
    for path in workspace.python_files():
        for row in _rows(workspace, path) or ():
            if row.cls is None or is_its_own(workspace, path, row.cls, row.what.removeprefix("self.")):
                assigned = Place(path, *row.assigned)
                yield MisusedKind(Place(path, *row.span), row.what, row.kind, row.misuse, row.name, assigned)


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    expecting = tried_for(code.body, {"AttributeError", "TypeError", "Exception", ""})
    rows: list[_Row] = []
    for number, cls in enumerate(classes_of(code)):
        of_class = values_of_self(cls)
        attributes = {
            name: kind for name, values in of_class.items() if (kind := kind_of_all(values, {}, or_none=True)) in HAVE
        }
        asked = _asked_in([cls])
        for function in methods_of(cls) if attributes else ():
            for part, of, misuse, name in _uses(function):
                own = of_self(of)
                kind = None if own is None else attributes.get(own)
                if own is None or kind is None or asked.protects(own, kind) or Itself(part) in expecting:
                    continue
                if _goes_wrong(kind, misuse, name):
                    rows.append(_Row(part.span, f"self.{own}", kind, misuse, name, _first(of_class, own), number))
    for function in everything_in(code.body, facts.Function):
        rows += _in_function(function, expecting)
    return rows


def _in_function(function: facts.Function, expecting: set[Itself[facts.Base]]) -> Iterator[_Row]:
    shared = {name for statement in everything_in(function.body, facts.Global) for name in statement.names}
    values = values_in(function)
    kinds = {name: kind_of_all(rows, values) for name, rows in values.items() if name not in shared}
    known = {name: kind for name, kind in kinds.items() if kind in HAVE}
    asked = _asked_in(function.body if known else [])
    for part, of, misuse, name in _uses(function) if known else ():
        variable = of.variable
        kind = known.get(variable)
        if kind is None or asked.protects(variable, kind) or Itself(part) in expecting:
            continue
        if _goes_wrong(kind, misuse, name):
            yield _Row(part.span, variable, kind, misuse, name, _first(values, variable))


def _first(values: Values, name: str) -> facts.Span:
    first = values[name][0]
    assert first is not None
    assert not isinstance(first, (facts.Slice, facts.Starred))
    return first.span


def _uses(
    function: facts.Function,
) -> Iterator[tuple[_Use, facts.Expr, Misuse, str]]:
    for part in parts_of(function.body):
        match part:
            case facts.Attribute(value=facts.Name() | facts.Attribute() as of, attr=name):
                yield part, of, Misuse.LOOKS_INTO, name
            case facts.Call(func=facts.Name() | facts.Attribute() as of):
                yield part, of, Misuse.CALLS, ""
            case facts.Subscript(value=facts.Name() | facts.Attribute() as of):
                yield part, of, Misuse.TAKES_ITEM, ""


def _goes_wrong(kind: Kind, misuse: Misuse, name: str) -> bool:
    match misuse:
        case Misuse.LOOKS_INTO:
            return name not in HAVE[kind] and not (kind is Kind.ARRAY and name.startswith("__"))
        case Misuse.CALLS:
            return True
    return kind in (Kind.NONE, Kind.NUMBER, Kind.BOOL)


@dataclass(frozen=True)
class _Asked:
    """The variables and attributes whose class some code asks for, and those for whose truth."""

    kind: frozenset[str]
    truth: frozenset[str]

    def protects(self, name: str, kind: Kind) -> bool:
        return name in self.kind or (kind is Kind.NONE and name in self.truth)


def _asked_in(body: Sequence[facts.Base]) -> _Asked:
    kinds: list[facts.Base] = []
    truths: list[facts.Base] = []
    for part in everything_in(body):
        truths += tests_in(part)
        if isinstance(part, facts.Call) and part.func.last_name in ASKS:
            kinds += [argument.value for argument in part.args]
    return _Asked(_names_in(kinds), _names_in(truths))


def _names_in(parts: Sequence[facts.Base]) -> frozenset[str]:
    names = {of_self(each) or (each.id if isinstance(each, facts.Name) else "") for each in everything_in(parts)}
    return frozenset(names - {""})


__all__ = ["ASKS", "HAVE", "Misuse", "MisusedKind", "misused_kinds"]
