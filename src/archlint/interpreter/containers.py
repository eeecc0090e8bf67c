"""Collections: lists, tuples, sets and dicts, and the items that iterating yields."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.heap import Entries, Items
from archlint.interpreter.values import (
    ClassValue,
    DictValue,
    EachValue,
    External,
    ForeignValue,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    with_via,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine
ITEM_LIMIT = 4096


def new_list(
    machine: Machine, values: Sequence[Value], kind: str = "list", open_: bool = False, whole: bool = False
) -> ListValue:
    made = ListValue(machine.store.new_key(), kind)
    machine.store.set(made.key, "#items", Items(distinct(values) if kind == "set" else tuple(values), open_, whole))
    return made


def distinct(values: Iterable[Value]) -> tuple[Value, ...]:
    """The items of a set: of those that Python takes for the same, the first."""
    found: dict[Hashable, Value] = {}
    for value in values:
        at = hashable(value)
        found.setdefault(("#unknown", len(found)) if at is None else at, value)
    return tuple(found.values())


def new_dict(machine: Machine, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> DictValue:
    made = DictValue(machine.store.new_key())
    machine.store.set(made.key, "#items", Entries(entries, open_))
    return made


def items_of(machine: Machine, value: ListValue) -> Items:
    items = machine.store.get(value.key, "#items")
    if not isinstance(items, Items):
        return Items((), True)
    if not value.via:
        return items
    return Items(tuple(with_via(item, value.via) for item in items.values), items.open, items.whole)


def entries_of(machine: Machine, value: DictValue) -> Entries:
    entries = machine.store.get(value.key, "#items")
    if not isinstance(entries, Entries):
        return Entries({}, True)
    if not value.via:
        return entries
    rows = {at: (key, with_via(entry, value.via)) for at, (key, entry) in entries.entries.items()}
    return Entries(rows, entries.open)


def hashable(value: Value) -> Hashable | None:
    """What stands for a value as a key; None where it is not known."""
    if isinstance(value, Known):
        return (type(value.value).__name__ if isinstance(value.value, str) else "", value.value)
    if isinstance(value, (Instance, ClassValue)):
        return ("#", id(value))
    if isinstance(value, ForeignValue) and value.is_hashable:
        return ("#", id(value))
    if isinstance(value, External):
        return ("#external", value.path)
    return None


def iterate(machine: Machine, value: Value) -> Items | None:
    """The items that iterating yields; None where nothing is known of them."""
    if isinstance(value, ListValue):
        return items_of(machine, value)
    if isinstance(value, DictValue):
        entries = entries_of(machine, value)
        return Items(tuple(key for key, _ in entries.entries.values()), entries.open)
    if isinstance(value, Known) and isinstance(value.value, str):
        if len(value.value) > 256:
            return None
        return Items(tuple(Known(character, value.via) for character in value.value))
    if isinstance(value, ClassValue):
        members = enum_members(machine, value)
        return Items(tuple(members)) if members else None
    if isinstance(value, Instance):
        return fields_of_tuple(machine, value)
    if isinstance(value, OneOf):
        rows = [iterate(machine, alternative) for alternative in value.values]
        known = [row for row in rows if row is not None]
        if not known:
            return None
        union: list[Value] = []
        for row in known:
            union.extend(item for item in row.values if item not in union)
        same = len(known) == len(rows) and all(row == known[0] for row in known)
        whole = len(known) == len(rows) and all(row.whole for row in known)
        return Items(tuple(union), not same or known[0].open, whole)
    return None


def fields_of_tuple(machine: Machine, value: Instance) -> Items | None:
    """The items of a named tuple."""
    names = machine.store.get(value.key, "#fields")
    if not isinstance(names, tuple):
        return None
    fields = [machine.store.get(value.key, name) for name in names]
    return Items(tuple(field for field in fields if isinstance(field, Value)))


def unknown_item(machine: Machine, iterable: Value, why: str) -> Value:
    """What stands for any of the items of what cannot be iterated over."""
    if isinstance(iterable, EachValue):
        return iterable.element
    if isinstance(iterable, Unknown) and iterable.parameter is not None:
        return Unknown(iterable.reason, iterable.parameter)
    return Unknown(why)


def enum_members(machine: Machine, cls: ClassValue) -> list[Value]:
    names = machine.store.get(cls.key, "#members")
    if not isinstance(names, tuple):
        return []
    found = [machine.store.get(cls.key, name) for name in names]
    return [value for value in found if isinstance(value, Value)]


PYTHON = (3, 10)
"""The oldest Python of a supported distribution: humble's."""
