"""Collections: lists, tuples, sets and dicts, and the items that iterating yields."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    ENTRIES,
    ITEMS,
    DictValue,
    Entries,
    Items,
    Known,
    ListKind,
    ListValue,
    Unknown,
    UnknownKey,
    Value,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine
ITEM_LIMIT = 4096


def new_list(
    machine: Machine, values: Sequence[Value], kind: ListKind = "list", open_: bool = False, whole: bool = False
) -> ListValue:
    made = ListValue(machine.store.new_key(), kind)
    machine.store.set(made.key, ITEMS, Items(distinct(values) if kind == "set" else tuple(values), open_, whole))
    return made


def distinct(values: Iterable[Value]) -> tuple[Value, ...]:
    """The items of a set: of those that Python takes for the same, the first."""
    found: dict[Hashable, Value] = {}
    for value in values:
        at = hashable(value)
        found.setdefault(UnknownKey(len(found)) if at is None else at, value)
    return tuple(found.values())


def new_dict(machine: Machine, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> DictValue:
    made = DictValue(machine.store.new_key())
    machine.store.set(made.key, ENTRIES, Entries(entries, open_))
    return made


def dict_of_names(machine: Machine, values: Mapping[str, Value], open_: bool = False) -> DictValue:
    """A dict with texts for keys."""
    names = ((Known(name), value) for name, value in values.items())
    return new_dict(machine, {name.entry_key(): (name, value) for name, value in names}, open_)


def items_of(machine: Machine, value: ListValue) -> Items:
    """The items of a list."""
    return value.items(machine)


def entries_of(machine: Machine, value: DictValue) -> Entries:
    """The entries of a dict."""
    return value.entries(machine)


def hashable(value: Value) -> Hashable | None:
    """What stands for a value as a key; None where it is not known."""
    return value.entry_key()


def iterate(machine: Machine, value: Value) -> Items | None:
    """The items that iterating yields; None where nothing is known of them."""
    return value.items(machine)


def unknown_item(machine: Machine, iterable: Value, why: str) -> Value:
    """What stands for any of the items of what cannot be iterated over."""
    if iterable.each is not None:
        return iterable.each
    if isinstance(iterable, Unknown) and iterable.parameter is not None:
        return Unknown(iterable.reason, iterable.parameter)
    return Unknown(why)


PYTHON = (3, 10)
"""The oldest Python of a supported distribution: humble's."""
