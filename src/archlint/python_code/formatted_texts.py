"""Texts with places for another number of values than are given: ``'%s at %s' % name``, ``'{} at {}'.format(name)``.

Source: docs.python.org/3/library/stdtypes.html#printf-style-string-formatting and string.html#format-string-syntax.
``%`` takes as many values as there are places; ``format()`` at least as many, and by name all that are named.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from string import Formatter
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.plain_kinds import Kind, Values, kind_of, values_in
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PLACE = re.compile(
    r"%(?P<name>\([^)]*\))?[-+ #0]*(?P<width>\*|\d*)(?:\.(?P<digits>\*|\d*))?[hlL]?(?P<kind>.?)", re.DOTALL
)
_KINDS = frozenset("diouxXeEfFgGcrsa%")


@dataclass(frozen=True)
class WrongCount:
    """A text with so many ``places`` and so many ``values`` for them, or without the value of that ``name``."""

    place: Place
    error: str
    """The exception that Python raises."""
    places: int
    values: int
    name: str = ""


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    error: str
    places: int
    values: int
    name: str = ""


def wrong_counts(workspace: WorkspaceIndex) -> Iterator[WrongCount]:
    """Every such text in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for row in _rows(workspace, path) or ():
            yield WrongCount(Place(path, *row.span), row.error, row.places, row.values, row.name)


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    expected = {error: tried_for(code.body, {error}) for error in ("TypeError", "IndexError", "KeyError")}
    rows: list[_Row] = []
    scopes: tuple[facts.Facts | facts.Function, ...] = (code, *everything_in(code.body, facts.Function))
    for scope in scopes:
        variables: Values | None = None
        for part in parts_of(scope.body):
            row = None
            match part:
                case facts.Binary(op="%", left=facts.Literal(value=str(text)), right=values, span=span):
                    if variables is None:
                        variables = values_in(scope) if isinstance(scope, facts.Function) else {}
                    row = _by_percent(text, values, variables, span)
                case facts.Call(func=facts.Attribute(value=facts.Literal(value=str(text)), attr="format")):
                    row = _by_format(text, part)
            if row is not None and Itself[facts.Base](part) not in expected[row.error]:
                rows.append(row)
    return rows


# ---------------------------------------------------------------------------------------------------------- with %


def _by_percent(text: str, values: facts.Expr, variables: Values, span: facts.Span) -> _Row | None:
    places = _places(text)
    if places is None:
        return None
    match values:
        case facts.Sequence(kind="tuple", elements=elements):
            if any(isinstance(element, facts.Starred) for element in elements) or len(elements) == places:
                return None
            return _Row(span, "TypeError", places, len(elements))
    kind = Kind.NUMBER if _is_one(values) else kind_of(values, variables)
    if kind is None or kind in (Kind.TUPLE, Kind.NUMERIC) or places == 1:
        return None
    if places == 0 and kind in (Kind.LIST, Kind.DICT, Kind.ARRAY):
        return None  # what has items by a key may be left unused
    return _Row(span, "TypeError", places, 1)


def _is_one(value: facts.Expr) -> bool:
    """Whether an expression is a text, which is no tuple."""
    match value:
        case facts.Literal(value=str()) | facts.FormatString():
            return True
        case facts.Call(func=facts.Name(id="str" | "repr")):
            return True
    return False


def _places(text: str) -> int | None:
    """How many values a text takes; None where they have names, or where that cannot be told."""
    count = 0
    for match in _PLACE.finditer(text):
        if match["name"] is not None or match["kind"] not in _KINDS or "*" in (match["width"], match["digits"]):
            return None
        count += match["kind"] != "%"
    return count


# ----------------------------------------------------------------------------------------------------- with format()


def _by_format(text: str, call: facts.Call) -> _Row | None:
    if any(argument.star for argument in call.args):
        return None
    given = [argument for argument in call.args if argument.keyword is None]
    names = {argument.keyword for argument in call.args}
    try:
        fields = [*_fields(text)]
    except ValueError:
        return None
    by_position = [field for field in fields if not field or field.isdecimal()]
    if "" in by_position and any(by_position):
        return None  # which Python refuses, too
    places = max(
        len(by_position) if not any(by_position) else 0, *(int(field) + 1 for field in by_position if field), 0
    )
    if places > len(given):
        return _Row(call.span, "IndexError", places, len(given))
    missing = next((field for field in fields if field and not field.isdecimal() and field not in names), None)
    return None if missing is None else _Row(call.span, "KeyError", len(fields), len(call.args), missing)


def _fields(text: str) -> Iterator[str]:
    """What the places of a text ask for, those inside of others included: a number, a name, or nothing."""
    for _, field, spec, _ in Formatter().parse(text):
        if field is not None:
            yield re.split(r"[.\[]", field, maxsplit=1)[0]
            yield from _fields(spec or "")


__all__ = ["WrongCount", "wrong_counts"]
