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
    machine: Machine,
    values: Sequence[Value],
    kind: ListKind = "list",
    open_: bool = False,
    exhaustive: bool = False,
    ordered: bool = False,
) -> ListValue:
    collection = ListValue(machine.store.new_key(), kind)
    items = Items(distinct(values) if kind == "set" else tuple(values), open_, exhaustive, ordered)
    machine.store.set(collection.key, ITEMS, items)
    return collection


def distinct(values: Iterable[Value]) -> tuple[Value, ...]:
    """The items of a set: of those that Python takes for the same, the first."""
    firsts: dict[Hashable, Value] = {}
    for value in values:
        at = value.entry_key()
        firsts.setdefault(UnknownKey(len(firsts)) if at is None else at, value)
    return tuple(firsts.values())


def new_dict(machine: Machine, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> DictValue:
    collection = DictValue(machine.store.new_key())
    machine.store.set(collection.key, ENTRIES, Entries(entries, open_))
    return collection


def entry_key(machine: Machine, value: Value) -> Hashable | None:
    """What stands for a value as the key of a dict, for a tuple what stands for its items; None where it is not
    known."""
    if not isinstance(value, ListValue) or value.kind != "tuple":
        return value.entry_key()
    items = value.items(machine)
    keys = [entry_key(machine, item) for item in items.values]
    return None if items.open or None in keys else ("tuple", *keys)


def dict_of_names(machine: Machine, values: Mapping[str, Value], open_: bool = False) -> DictValue:
    """A dict with texts for keys."""
    names = ((Known(name), value) for name, value in values.items())
    return new_dict(machine, {name.entry_key(): (name, value) for name, value in names}, open_)


def all_items(machine: Machine, values: Sequence[Value]) -> list[Items] | None:
    """The items of several collections; None where one of them is not known."""
    rows = [value.items(machine) for value in values]
    known = [row for row in rows if row is not None]
    return known if len(known) == len(rows) else None


def unknown_item(machine: Machine, iterable: Value, why: str) -> Value:
    """What stands for any of the items of what cannot be iterated over."""
    if iterable.each is not None:
        return iterable.each
    if isinstance(iterable, Unknown) and iterable.parameter is not None:
        return Unknown(iterable.reason, iterable.parameter)
    return Unknown(why)


PYTHON = (3, 10)
"""The oldest Python of a supported distribution: humble's."""
