"""Copies of objects and containers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    DictValue,
    Instance,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.rclpy.changed_profiles import copy_profile, is_profile

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.run import Run


def _copy(run: Run, site: CallSite) -> Value:
    return one_of(copied(run, value) for value in (alternatives(site.args[0]) if site.args else ()))


def copied(run: Run, value: Value) -> Value:
    match value:
        case ListValue():
            items = value.items(run)
            return containers.new_list(run, items.values, value.kind, items.open, items.exhaustive)
        case DictValue():
            entries = value.entries(run)
            return containers.new_dict(run, dict(entries.entries), entries.open)
    return _copied_object(run, value)


def _copied_object(run: Run, value: Value, copies: dict[int, Value] | None = None) -> Value:
    """A copy of what is no container: of an object with what it holds now.  That is copied as well where ``copies`` has
    what has been copied so far.  Nobody copies a node."""
    if not isinstance(value, Instance) or is_profile(value):
        return copy_profile(run, value)
    if value.key in run.nodes.by_object:
        return value
    copy = Instance(value.cls, run.store.new_key(), value.place, value.arguments)
    if copies is not None:
        copies[value.key] = copy
    for name in run.store.names_of(value.key):
        held = run.store.get(value.key, name)
        if held is not None:
            run.store.set(copy.key, name, held if copies is None else _copied_deep(run, held, copies))
    return copy


def _deep_copy(run: Run, site: CallSite) -> Value:
    return _copied_deep(run, site.args[0], {}) if site.args else Unknown("no argument")


def _copied_deep(run: Run, value: Value, copies: dict[int, Value]) -> Value:
    """A copy, the containers and objects inside it copied as well; ``copies`` has those already made, by key."""
    if isinstance(value, OneOf):
        return one_of(_copied_deep(run, option, copies) for option in value.values)
    if isinstance(value, (ListValue, DictValue, Instance)) and value.key in copies:
        return copies[value.key]
    if not isinstance(value, (ListValue, DictValue)):
        return _copied_object(run, value, copies)
    copies[value.key] = Unknown("a container that contains itself")
    if isinstance(value, ListValue):
        items = value.items(run)
        inside = [_copied_deep(run, item, copies) for item in items.values]
        copy: Value = containers.new_list(run, inside, value.kind, items.open, items.exhaustive)
    else:
        contents = value.entries(run)
        entries = {at: (key, _copied_deep(run, entry, copies)) for at, (key, entry) in contents.entries.items()}
        copy = containers.new_dict(run, entries, contents.open)
    copies[value.key] = copy
    return copy


__all__ = ["copied"]
