"""Copies of objects and containers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    DictValue,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.rclpy import changed_profiles

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
    return changed_profiles.copy_profile(run, value)


def _deep_copy(run: Run, site: CallSite) -> Value:
    return _copied_deep(run, site.args[0], {}) if site.args else Unknown("no argument")


def _copied_deep(run: Run, value: Value, copies: dict[int, Value]) -> Value:
    """A copy, the containers inside it copied as well; ``copies`` has those already made, by key."""
    if isinstance(value, OneOf):
        return one_of(_copied_deep(run, option, copies) for option in value.values)
    if not isinstance(value, (ListValue, DictValue)):
        return changed_profiles.copy_profile(run, value)
    if value.key in copies:
        return copies[value.key]
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
