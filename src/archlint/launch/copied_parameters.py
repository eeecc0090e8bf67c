"""What a node keeps of its ``parameters=``: launch_ros copies the lists and dicts as the node is made, so that what the
launch file does to one of them afterwards changes nodes made later only."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    ENTRIES,
    ITEMS,
    DictValue,
    Entries,
    Items,
    ListValue,
    OneOf,
    Value,
)
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.libraries.run import Run

COPYING = frozenset(
    {
        LaunchClass.NODE,
        LaunchClass.LIFECYCLE_NODE,
        LaunchClass.COMPOSABLE_NODE_CONTAINER,
        LaunchClass.COMPOSABLE_NODE,
        LaunchClass.COMPOSABLE_LIFECYCLE_NODE,
    }
)
"""The classes whose constructors call ``normalize_parameters``.

Source: launch_ros/actions/node.py and launch_ros/descriptions/composable_node.py of humble, jazzy and kilted.
"""


def with_copied_parameters(run: Run, kind: LaunchClass, arguments: dict[str, Value]) -> dict[str, Value]:
    """The arguments of an object of launch as it keeps them."""
    parameters = arguments.get("parameters") if kind in COPYING else None
    return arguments if parameters is None else {**arguments, "parameters": _copied(run, parameters, {})}


def _copied(run: Run, value: Value, copies: dict[int, Value]) -> Value:
    """A value with the lists and dicts in it copied, each once, one that holds itself, too."""
    match value:
        case OneOf(values=options):
            return replace(value, values=tuple(_copied(run, option, copies) for option in options))
        case ListValue() | DictValue() if value.key in copies:
            return copies[value.key]
        case ListValue():
            copies[value.key] = copy = replace(value, key=run.store.new_key())
            items = value.items(run)
            held = tuple(_copied(run, item, copies) for item in items.values)
            run.store.set(copy.key, ITEMS, Items(held, items.open, items.exhaustive, items.ordered))
            return copy
        case DictValue():
            copies[value.key] = copied = replace(value, key=run.store.new_key())
            rows = value.entries(run)
            entries = {at: (key, _copied(run, entry, copies)) for at, (key, entry) in rows.entries.items()}
            run.store.set(copied.key, ENTRIES, Entries(entries, rows.open))
            return copied
    return value


__all__ = ["with_copied_parameters"]
