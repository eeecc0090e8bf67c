"""Messages that a callback keeps in an attribute, and that other code takes for the value in them: ``self.speed = msg``
and ``self.speed > 0.5``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.class_chains import classes_of, files_with, methods_of
from archlint.python_code.field_operations import deeds_in, goes_wrong
from archlint.python_code.message_operations import Delivered, MessageOperation, delivered
from archlint.python_code.message_variables import given_to_others
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.plain_kinds import values_of_self
from archlint.python_code.text_sums import is_its_own
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import Itself, parts_of
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


@dataclass(frozen=True)
class _Kept:
    by: Delivered
    alone: bool
    """Whether it is None until a message comes."""


def kept_message_operations(system: System) -> Iterator[MessageOperation]:
    """Each such piece of code of the same class, where nothing but whole messages, and plain values until they come, is
    assigned to the attribute."""
    workspace, by_file = system.workspace, dict[str, list[Delivered]]()
    for row in delivered(system):
        by_file.setdefault(row.file, []).append(row)
    for file, rows in by_file.items():
        code = None if workspace is None else workspace.facts_at(file)
        for number, cls in enumerate(classes_of(code)) if code is not None else ():
            own = {Itself[facts.Base](method) for method in methods_of(cls)}
            inside = [row for row in rows if Itself[facts.Base](row.function) in own]
            if inside and workspace is not None:
                yield from _of_class(workspace, file, number, cls, inside)


def _of_class(
    workspace: WorkspaceIndex, file: str, number: int, cls: facts.Class, rows: list[Delivered]
) -> Iterator[MessageOperation]:
    kept = _kept(cls, rows)
    attributes = {
        name: row
        for name, row in kept.items()
        if is_its_own(workspace, file, number, name) and not is_given(workspace, name)
    }
    for method in methods_of(cls) if attributes else ():
        for deed, other, by, value, span in deeds_in(method):
            held = attributes.get(of_self(value) or "")
            if held is None or not goes_wrong("message", deed, other, by):
                continue
            if deed == "compares" and not held.alone:
                continue  # it asks whether a message has come
            place, row = Place(file, *span), held.by
            yield MessageOperation(place, row.callback, value.dotted, row.type, "", deed, other, by, kept=True)


def is_given(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether any code gives an object that is not ``self`` an attribute of a name."""
    given = (given_to_others(workspace, path) for path in files_with(workspace, name))
    return any(names is None or name in names for names in given)


def _kept(cls: facts.Class, rows: list[Delivered]) -> dict[str, _Kept]:
    """The attributes that hold the messages of subscriptions, each with the callback that keeps them."""
    messages: dict[Itself[facts.Base], Delivered] = {}
    for row in rows:
        names = {name for name, section in row.names.items() if not section}.difference(names_bound(row.function.body))
        for part in parts_of(row.function.body, facts.Assign):
            if part.value.variable in names:
                messages[Itself[facts.Base](part.value)] = row
    attributes: dict[str, _Kept] = {}
    for name, values in values_of_self(cls).items() if messages else ():
        known = [value for value in values if value is not None]
        whole = [messages[Itself[facts.Base](value)] for value in known if Itself[facts.Base](value) in messages]
        others = [value for value in known if Itself[facts.Base](value) not in messages]
        if whole and len(known) == len(values) and all(map(is_plain, others)):
            attributes[name] = _Kept(whole[0], all(is_none(value) for value in others))
    return attributes


def is_plain(value: facts.Expr) -> bool:
    """Whether an expression stands for nothing yet: a constant, or an empty list, tuple or dict."""
    match value:
        case facts.Unary(op="-", operand=operand):
            return isinstance(operand, facts.Literal)
        case facts.Literal() | facts.Sequence(elements=[]):
            return True
        case facts.Mapping():
            return not value.children()
    return False


__all__ = ["is_given", "is_plain", "kept_message_operations"]
