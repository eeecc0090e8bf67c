"""Items: ``container[index]``, slices, and what is put there or taken away."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute, set_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import (
    ITEM_LIMIT,
    PYTHON,
    entries_of,
    fields_of_tuple,
    hashable,
    items_of,
    new_list,
)
from archlint.interpreter.values import (
    ENTRIES,
    FACTORY,
    ITEMS,
    AttributesValue,
    BoundMethod,
    ClassValue,
    DictValue,
    EachValue,
    Entries,
    External,
    Instance,
    Items,
    Known,
    ListValue,
    OneOf,
    Unknown,
    UnknownKey,
    Value,
    alternatives,
    as_default,
    one_of,
    reason,
    via,
    with_via,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine
STRANGE_KEYS = 64
"""How many values under keys that are not known a dict keeps."""


def slice_of(machine: Machine, value: Value, bounds: slice | None) -> Value:
    return machine.library.lost(_slice_of(machine, value, bounds), (value,), "it is in a part of a list")


def _slice_of(machine: Machine, value: Value, bounds: slice | None) -> Value:
    if isinstance(value, EachValue):
        return value
    if bounds is None or bounds.step == 0:
        return Unknown("a slice whose bounds are not known")
    if isinstance(value, ListValue):
        items = items_of(machine, value)
        if items.open:
            return Unknown("the items of this list are not known")
        return new_list(machine, items.values[bounds], value.kind)
    if isinstance(value, Known) and isinstance(value.value, str):
        return Known(value.value[bounds], value.via)
    return Unknown(reason(value))


def get_item(machine: Machine, container: Value, index: Value) -> Value:
    """``container[index]``."""
    found = _get_item(machine, container, index)
    if isinstance(container, (ListValue, DictValue)):
        return machine.library.lost(found, (container,), _TAKEN)
    return found


_TAKEN = "it is in a container from which something is taken"


def _get_item(machine: Machine, container: Value, index: Value) -> Value:
    if isinstance(container, EachValue):
        return container.element
    if isinstance(container, ListValue):
        items = items_of(machine, container)
        if isinstance(index, Known) and isinstance(index.value, int):
            inside = -len(items.values) <= index.value < len(items.values)
            if inside and not items.open:
                return with_via(items.values[index.value], index.via)
            return Unknown("the items of this list are not known")
        if items.values and not items.open:
            return with_via(one_of(items.values), via(index))
        return Unknown(reason(index, *items.values[:1]))
    if isinstance(container, DictValue):
        return get_entry(machine, container, index, None)
    if isinstance(container, Known) and isinstance(container.value, str):
        if isinstance(index, Known) and isinstance(index.value, int):
            try:
                return Known(container.value[index.value], container.via | index.via)
            except IndexError:
                return Unknown("an index outside of the text")
        return Unknown(reason(index))
    if isinstance(container, ClassValue):
        if isinstance(index, Known) and isinstance(index.value, str):
            member = machine.store.get(container.key, index.value)  # an enum by name, or a generic class
            if isinstance(member, Value):
                return member
        return container
    if isinstance(container, External):
        return _external_item(machine, container, index)
    if isinstance(container, Instance):
        items_ = fields_of_tuple(machine, container)
        if items_ is not None and isinstance(index, Known) and isinstance(index.value, int):
            return items_.values[index.value] if abs(index.value) < len(items_.values) else Unknown("no such item")
        method = get_attribute(machine, container, "__getitem__")
        if isinstance(method, BoundMethod):
            return machine.call(method, CallSite([index]))
    if isinstance(container, AttributesValue) and isinstance(index, Known) and isinstance(index.value, str):
        return get_attribute(machine, container.instance, index.value)
    if isinstance(container, Unknown):
        return Unknown(container.reason, container.parameter)
    return Unknown(reason(container, index))


def _external_item(machine: Machine, container: External, index: Value) -> Value:
    """``os.environ['X']``, an enum by name, or a generic such as ``list[str]``."""
    name = index.value if isinstance(index, Known) else None
    if container.path == "os.environ":
        known = machine.library.environment(name)
        return known or Unknown(f"the environment variable {name!s}" if name else "an environment variable")
    if container.path == "sys.version_info" and name == 0:
        return Known(PYTHON[0])
    return machine.library.item_of_external(container, name) or container


def get_entry(machine: Machine, container: DictValue, index: Value, default: Value | None) -> Value:
    """``dict[index]``, or ``dict.get(index, default)`` where a default is given; what chose the index chooses it."""
    return with_via(_get_entry(machine, container, index, default), via(index))


def _get_entry(machine: Machine, container: DictValue, index: Value, default: Value | None) -> Value:
    entries = entries_of(machine, container)
    at = hashable(index)
    if at is not None:
        found = entries.entries.get(at)
        if found is not None:
            return found[1]
        if entries.open:
            why = Unknown("the dict has entries that are not known")
            return why if default is None else one_of((as_default(default), why))
        if default is None:
            return _made_entry(machine, container, index)
        return default
    values = [value for _, value in entries.entries.values()]
    if default is not None:
        values.append(default)
    if entries.open or not values:
        return Unknown(reason(index, *values[:1]))
    return one_of(values)


def _made_entry(machine: Machine, container: DictValue, index: Value) -> Value:
    """What a ``defaultdict`` makes for a new key."""
    factory = machine.store.get(container.key, FACTORY)
    if factory is None:
        return Unknown("the dict has no such key")
    made = machine.call(factory)
    set_item(machine, container, index, made)
    return made


def set_item(machine: Machine, container: Value, index: Value, value: Value) -> None:
    """``container[index] = value``; where it is one of several containers, each may now hold it."""
    several = isinstance(container, OneOf)
    for target in alternatives(container):
        if isinstance(target, (DictValue, ListValue)):
            machine.library.kept(target.key, (index, value))
        if isinstance(target, DictValue):
            entries = entries_of(machine, target)
            at = hashable(index)
            updated = dict(entries.entries)
            if at is None:
                strange = [row for key, row in updated.items() if isinstance(key, UnknownKey)]
                if len(strange) < STRANGE_KEYS and (index, value) not in strange:
                    updated[UnknownKey(len(updated))] = (index, value)
                machine.store.set(target.key, ENTRIES, Entries(updated, True))
                continue
            if several and at in updated:
                value = one_of((updated[at][1], value))
            updated[at] = (index, value)
            if len(updated) <= ITEM_LIMIT:
                machine.store.set(target.key, ENTRIES, Entries(updated, entries.open))
        elif isinstance(target, ListValue):
            items = items_of(machine, target)
            if isinstance(index, Known) and isinstance(index.value, int) and not items.open:
                values = list(items.values)
                if -len(values) <= index.value < len(values):
                    values[index.value] = value
                    machine.store.set(target.key, ITEMS, Items(tuple(values)))
            else:
                machine.store.set(target.key, ITEMS, Items((*items.values, value)[:ITEM_LIMIT], True))
        elif isinstance(target, AttributesValue):
            if isinstance(index, Known) and isinstance(index.value, str):
                set_attribute(machine, target.instance, index.value, value)
        elif isinstance(target, Instance):
            method = get_attribute(machine, target, "__setitem__")
            if isinstance(method, BoundMethod):
                machine.call(method, CallSite([index, value]))
            else:
                machine.library.escaped((value,), "it is put into something that is not followed")
        else:
            machine.library.escaped((value,), "it is put into something that is not followed")


def delete_item(machine: Machine, container: Value, index: Value) -> None:
    at = hashable(index)
    if isinstance(container, DictValue):
        entries = entries_of(machine, container)
        kept = {key: entry for key, entry in entries.entries.items() if key != at}
        machine.store.set(container.key, ENTRIES, Entries(kept, entries.open or at is None))
    elif isinstance(container, ListValue):
        machine.store.set(container.key, ITEMS, Items(items_of(machine, container).values, True))


__all__ = ["delete_item", "get_entry", "get_item", "set_item", "slice_of"]
