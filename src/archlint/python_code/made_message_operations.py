"""What code does with messages that it has made itself, as if they were numbers or lists: ``x, y, z = Point()``.

Source: as for :mod:`~archlint.python_code.message_operations`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.rclpy.names import interface_and_section
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.python_code.field_operations import LEVELS, deeds_in, goes_wrong
from archlint.python_code.kept_messages import is_given
from archlint.python_code.message_variables import imported_messages, makes_message, variables_of_messages
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.plain_kinds import values_of_self
from archlint.python_code.text_sums import is_its_own
from archlint.python_code.tried_code import OF_A_WRONG_KIND, tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_OPERATORS = frozenset({"+", "-", "*", "/", "//", "**"})
_TIMES = frozenset({"builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"})
"""What API001 judges, with the times of rclpy."""


@dataclass(frozen=True)
class MadeMessageOperation:
    """Such a piece of code: what holds the message, its type, what is done with it, with what, and by what."""

    place: Place
    name: str
    type: str
    deed: str
    other: str
    by: str


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    name: str
    type: str
    deed: str
    other: str
    by: str
    cls: int | None = None


def made_message_operations(workspace: WorkspaceIndex) -> Iterator[MadeMessageOperation]:
    """Each such piece of code in the files that were asked for, but for test code."""
    table = workspace.interfaces
    for path in workspace.python_files() if table is not None else ():
        for row in _rows(workspace, path) or ():
            own = row.name.removeprefix("self.")
            if row.cls is not None and (not is_its_own(workspace, path, row.cls, own) or is_given(workspace, own)):
                continue
            if table is not None and table.get(row.type) is not None:
                yield MadeMessageOperation(Place(path, *row.span), row.name, row.type, row.deed, row.other, row.by)


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    classes = imported_messages(code)
    if not classes:
        return []
    expecting = tried_for(code.body, OF_A_WRONG_KIND)
    rows: list[_Row] = []
    for number, cls in enumerate(classes_of(code)):
        held = _held_by(cls, classes)
        for function in methods_of(cls) if held else ():
            rows += _in(function, held, expecting, number)
    for function in everything_in(code.body, facts.Function):
        rows += _in(function, _variables(function, classes), expecting, None)
    return rows


def _held_by(cls: facts.Class, classes: dict[str, str]) -> dict[str, str]:
    """The attributes that hold nothing but messages of one type, or None until there is one."""
    held: dict[str, str] = {}
    for name, values in values_of_self(cls).items():
        types = {_type_of(value, classes) for value in values if value is None or not is_none(value)}
        type_ = types.pop() if len(types) == 1 else None
        if type_ is not None:
            held[f"self.{name}"] = type_
    return held


def _variables(function: facts.Function, classes: dict[str, str]) -> dict[str, str]:
    names = variables_of_messages(function, classes)
    types: dict[str, set[str | None]] = {}
    for part in parts_of(function.body, facts.Assign) if names else ():
        if len(part.targets) == 1 and part.targets[0].variable in names:
            types.setdefault(part.targets[0].variable, set()).add(_type_of(part.value, classes))
    return {name: type_ for name, given in types.items() for type_ in given if type_ is not None and len(given) == 1}


def _type_of(value: facts.Expr | None, classes: dict[str, str]) -> str | None:
    """The type of the message that an expression makes; None for anything else, and for what is not judged here."""
    match value:
        case facts.Call(func=facts.Name(id=name)) if makes_message(value, classes):
            type_, section = interface_and_section(classes[name])
            return type_ if type_ is not None and not section and type_ not in _TIMES else None
    return None


def _in(
    function: facts.Function, held: Mapping[str, str], expecting: set[Itself[facts.Base]], number: int | None
) -> Iterator[_Row]:
    for part in parts_of(function.body, facts.Binary) if held else ():
        left, right = _name(part.left), _name(part.right)
        if part.op in _OPERATORS and left in held and right in held and Itself[facts.Base](part) not in expecting:
            yield _Row(part.span, left, held[left], "calculates", "message", part.op, number)
    for deed, other, by, value, span in deeds_in(function) if held else ():
        name = _name(value)
        if deed == "looks into" or by in LEVELS or name not in held:
            continue  # MSG001 asks which fields there are, and API001 what is logged
        if goes_wrong("message", deed, other, by):
            yield _Row(span, name, held[name], deed, other, by, number)


def _name(e: facts.Expr) -> str:
    return f"self.{own}" if (own := of_self(e)) is not None else e.variable


__all__ = ["MadeMessageOperation", "made_message_operations"]
