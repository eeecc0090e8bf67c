"""Items: ``container[index]``, slices, and what is put there or taken away."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute, method_of, set_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import ITEM_LIMIT, PYTHON, entry_key, new_list
from archlint.interpreter.values import (
    ENTRIES,
    FACTORY,
    ITEMS,
    AttributesValue,
    ClassValue,
    DictValue,
    Entries,
    External,
    Instance,
    Items,
    Known,
    ListValue,
    Unknown,
    UnknownKey,
    Value,
    alternatives,
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
    return machine.library.lost(_slice_of(machine, value, bounds), (value,), "it is in a slice of a list")


def _slice_of(machine: Machine, value: Value, bounds: slice | None) -> Value:
    if value.each is not None:
        return value
    if bounds is None or bounds.step == 0:
        return Unknown("a slice whose bounds are not known")
    match value:
        case ListValue():
            items = value.items(machine)
            if items.open:
                return Unknown("the items of this list are not known")
            return new_list(machine, items.values[bounds], value.kind)
        case Known(value=str(text)):
            return Known(text[bounds], value.via)
    return Unknown(reason(value))


def get_item(machine: Machine, container: Value, index: Value) -> Value:
    """``container[index]``."""
    item = _get_item(machine, container, index)
    if isinstance(container, (ListValue, DictValue)):
        return machine.library.lost(item, (container,), _TAKEN)
    return item


_TAKEN = "it is in a container from which an item is taken"


def _get_item(machine: Machine, container: Value, index: Value) -> Value:
    match container:
        case ListValue():
            of_pairs = None if index.text is None else _item_of_pairs(machine, container, index.text)
            return of_pairs or _item_of_list(container.items(machine), index)
        case DictValue():
            return get_entry(machine, container, index, None)
        case Known(value=str(text)):
            return _letter(text, container.via, index)
        case ClassValue():  # an enum by name, or a generic class
            member = None if index.text is None else machine.store.get(container.key, index.text)
            return member or container
        case External():
            return _external_item(machine, container, index)
        case Instance():
            return _item_of_object(machine, container, index)
        case AttributesValue() if index.text is not None:
            return get_attribute(machine, container.instance, index.text)
        case Unknown():
            return Unknown(container.reason, container.parameter)
    return container.each or Unknown(reason(container, index))


def _item_of_pairs(machine: Machine, container: ListValue, key: str) -> Value | None:
    """What a map of C++ has for a key, where it was given its items as a list: ``names_ = {{"left", "l"}, …}``."""
    rows = [item.items(machine) for item in container.items(machine).values]
    pairs = [row.values for row in rows if row is not None and row.size == 2 and not row.open]
    return next((value for name, value in pairs if name.text == key), None) if len(pairs) == len(rows) else None


def _item_of_list(items: Items, index: Value) -> Value:
    number = index.whole_number
    if number is not None:
        if -items.size <= number < items.size and not items.open:
            return with_via(items.values[number], index.via)
        if items.ordered and number >= 0:
            return with_via(items.values[min(number, items.size - 1)], index.via)
        return Unknown("the items of this list are not known")
    if items.values and not items.open:
        return with_via(one_of(items.values), index.via)
    return Unknown(reason(index, *items.values[:1]))


def _letter(text: str, parameters: frozenset[str], index: Value) -> Value:
    number = index.whole_number
    if number is None:
        return Unknown(reason(index))
    if not -len(text) <= number < len(text):
        return Unknown("an index outside of the string")
    return Known(text[number], parameters | index.via)


def _item_of_object(machine: Machine, container: Instance, index: Value) -> Value:
    fields, number = container.items(machine), index.whole_number
    if fields is not None and number is not None:
        return fields.values[number] if abs(number) < fields.size else Unknown("the item does not exist")
    method = method_of(machine, container, "__getitem__")
    if method is not None:
        return machine.call(method, CallSite([index]))
    return Unknown(reason(container, index))


def _external_item(machine: Machine, container: External, index: Value) -> Value:
    """``os.environ['X']``, an enum by name, or a generic such as ``list[str]``."""
    name = index.constant
    if container.path == "os.environ":
        known = machine.library.environment(name)
        return known or Unknown(f"the environment variable {name!s}" if name else "an environment variable")
    if container.path == "sys.version_info" and name == 0:
        return Known(PYTHON[0])
    return machine.library.item_of_external(container, name) or container


def is_absent(machine: Machine, container: DictValue, key: Known) -> bool:
    """Whether a dict certainly has no such key, and makes none."""
    entries, at = container.entries(machine), entry_key(machine, key)
    makes = machine.store.get(container.key, FACTORY) is not None
    return at is not None and not entries.open and at not in entries.entries and not makes


def get_entry(machine: Machine, container: DictValue, index: Value, default: Value | None) -> Value:
    """``dict[index]``, or ``dict.get(index, default)`` where a default is given; what chose the index chooses it."""
    return with_via(_get_entry(machine, container, index, default), via(index))


def _get_entry(machine: Machine, container: DictValue, index: Value, default: Value | None) -> Value:
    entries = container.entries(machine)
    at = entry_key(machine, index)
    if at is None:
        values = [*entries.values, *(() if default is None else (default,))]
        return Unknown(reason(index, *values[:1])) if entries.open or not values else one_of(values)
    entry = entries.entries.get(at)
    if entry is not None:
        return entry[1]
    if entries.open:
        why = Unknown("the dict has entries that are not known")
        return why if default is None else one_of((default.as_default("fallback"), why))
    return _made_entry(machine, container, index) if default is None else default


def _made_entry(machine: Machine, container: DictValue, index: Value) -> Value:
    """What a ``defaultdict`` makes for a new key."""
    factory = machine.store.get(container.key, FACTORY)
    if factory is None:
        return Unknown("the dict has no such key")
    value = machine.call(factory)
    set_item(machine, container, index, value)
    return value


def set_item(machine: Machine, container: Value, index: Value, value: Value) -> None:
    """``container[index] = value``; where it is one of several containers, each may now hold it."""
    options = alternatives(container)
    for target in options:
        match target:
            case DictValue():
                machine.library.kept(target.key, (index, value))
                _set_entry(machine, target, index, value, several=len(options) > 1)
            case ListValue():
                machine.library.kept(target.key, (index, value))
                _set_item_of_list(machine, target, index, value)
            case AttributesValue():
                if index.text is not None:
                    set_attribute(machine, target.instance, index.text, value)
            case _:
                _set_item_of_object(machine, target, index, value)


def _set_entry(machine: Machine, target: DictValue, index: Value, value: Value, several: bool) -> None:
    entries = target.entries(machine)
    at = entry_key(machine, index)
    updated = dict(entries.entries)
    if at is None:
        strange = [row for key, row in updated.items() if isinstance(key, UnknownKey)]
        if len(strange) < STRANGE_KEYS and (index, value) not in strange:
            updated[UnknownKey(len(updated))] = (index, value)
        machine.store.set(target.key, ENTRIES, Entries(updated, True))
        return
    updated[at] = (index, one_of((updated[at][1], value)) if several and at in updated else value)
    if len(updated) <= ITEM_LIMIT:
        machine.store.set(target.key, ENTRIES, Entries(updated, entries.open))


def _set_item_of_list(machine: Machine, target: ListValue, index: Value, value: Value) -> None:
    items, number = target.items(machine), index.whole_number
    if number is None or items.open:
        machine.store.set(target.key, ITEMS, Items((*items.values, value)[:ITEM_LIMIT], True))
    elif -items.size <= number < items.size:
        values = list(items.values)
        values[number] = value
        machine.store.set(target.key, ITEMS, Items(tuple(values)))


def _set_item_of_object(machine: Machine, target: Value, index: Value, value: Value) -> None:
    method = method_of(machine, target, "__setitem__")
    if method is not None:
        machine.call(method, CallSite([index, value]))
    else:
        machine.library.escaped((value,), "it is put into something that is not followed")


def delete_item(machine: Machine, container: Value, index: Value) -> None:
    """``del container[index]``."""
    match container:
        case DictValue():
            at, entries = entry_key(machine, index), container.entries(machine)
            kept = {key: entry for key, entry in entries.entries.items() if key != at}
            machine.store.set(container.key, ENTRIES, Entries(kept, entries.open or at is None))
        case ListValue():
            machine.store.set(container.key, ITEMS, Items(container.items(machine).values, True))


__all__ = ["delete_item", "get_entry", "get_item", "set_item", "slice_of"]
