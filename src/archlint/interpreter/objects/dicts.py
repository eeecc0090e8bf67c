"""Methods of dicts."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING

from archlint.interpreter.containers import entry_key, new_dict, new_list
from archlint.interpreter.items import delete_item, get_entry, set_item
from archlint.interpreter.values import (
    ENTRIES,
    NONE,
    DictValue,
    Entries,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
)

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

Method = Callable[["Machine", DictValue, "CallSite"], "Value | None"]
"""None where a call with these arguments is not followed."""


def call(machine: Machine, target: DictValue, name: str, site: CallSite) -> Value | None:
    """``target.name(…)``; None where that is not followed."""
    method = _METHODS.get(name)
    return None if method is None else method(machine, target, site)


def update_entries(machine: Machine, entries: dict[Hashable, tuple[Value, Value]], source: Value) -> bool:
    """Add the entries of a dict or of pairs; False where not all are known."""
    other = source.entries(machine)
    if other is not None:
        entries.update(other.entries)
        return not other.open
    items = source.items(machine)
    if items is None:
        return False
    for pair in items.values:
        row = pair.items(machine)
        if row is None or row.open or row.size != 2:
            return False
        key, value = row.values
        at = entry_key(machine, key)
        if at is None:
            return False
        entries[at] = (key, value)
    return not items.open


def updated(machine: Machine, before: Entries, site: CallSite) -> Entries:
    """Entries with those of the arguments of ``update()`` or ``dict()``."""
    entries = dict(before.entries)
    complete = all(update_entries(machine, entries, source) for source in site.args)
    for text, value in site.keywords.items():
        name = Known(text)
        entries[name.entry_key()] = (name, value)
    return Entries(entries, before.open or not complete)


def _items(machine: Machine, target: DictValue, site: CallSite) -> Value:
    entries = target.entries(machine)
    rows = [new_list(machine, row, "tuple") for row in entries.entries.values()]
    return new_list(machine, rows, "list", entries.open)


def _keys(machine: Machine, target: DictValue, site: CallSite) -> Value:
    entries = target.entries(machine)
    return new_list(machine, entries.keys, "list", entries.open)


def _values(machine: Machine, target: DictValue, site: CallSite) -> Value:
    entries = target.entries(machine)
    return new_list(machine, entries.values, "list", entries.open)


def _default(site: CallSite) -> Value:
    return site.args[1] if len(site.args) > 1 else NONE


def _get(machine: Machine, target: DictValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    return one_of(get_entry(machine, target, key, _default(site)) for key in alternatives(site.args[0]))


def _set_default(machine: Machine, target: DictValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    entries, at = target.entries(machine), entry_key(machine, site.args[0])
    if at is not None and at in entries.entries:
        return entries.entries[at][1]
    value = _default(site)
    if entries.open:
        value = one_of((value, Unknown("the dict has entries that are not known")))
    set_item(machine, target, site.args[0], value)
    return value


def _update(machine: Machine, target: DictValue, site: CallSite) -> Value:
    machine.store.set(target.key, ENTRIES, updated(machine, target.entries(machine), site))
    return NONE


def _pop(machine: Machine, target: DictValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    value = get_entry(machine, target, site.args[0], site.args[1] if len(site.args) > 1 else None)
    delete_item(machine, target, site.args[0])
    return value


def _pop_item(machine: Machine, target: DictValue, site: CallSite) -> Value:
    machine.store.set(target.key, ENTRIES, Entries(target.entries(machine).entries, True))
    return Unknown("the result of popitem()")


def _copy(machine: Machine, target: DictValue, site: CallSite) -> Value:
    entries = target.entries(machine)
    return new_dict(machine, dict(entries.entries), entries.open)


def _clear(machine: Machine, target: DictValue, site: CallSite) -> Value:
    machine.store.set(target.key, ENTRIES, Entries({}))
    return NONE


_METHODS: dict[str, Method] = {
    "clear": _clear,
    "copy": _copy,
    "get": _get,
    "items": _items,
    "keys": _keys,
    "pop": _pop,
    "popitem": _pop_item,
    "setdefault": _set_default,
    "update": _update,
    "values": _values,
}

__all__ = ["call", "update_entries", "updated"]
