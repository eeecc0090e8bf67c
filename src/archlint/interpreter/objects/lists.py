"""Methods of lists, tuples and sets."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from archlint.interpreter.containers import ITEM_LIMIT, distinct, new_list
from archlint.interpreter.values import (
    FALSE,
    ITEMS,
    JOINED_LIMIT,
    NONE,
    Items,
    Known,
    ListValue,
    Unknown,
    Value,
    constants_of,
    one_of,
    reason,
)

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

Method = Callable[["Machine", ListValue, "CallSite"], "Value | None"]
"""None where a call with these arguments is not followed."""


def call(machine: Machine, target: ListValue, name: str, site: CallSite) -> Value | None:
    """``target.name(…)``; None where that is not followed."""
    if name in _CHANGES:
        _put(machine, target, target.items(machine).values, True)
        return None
    method = _METHODS.get(name)
    return None if method is None else method(machine, target, site)


def in_order(values: Sequence[Value], keywords: Mapping[str, Value]) -> tuple[Value, ...]:
    """Values as ``sorted`` orders them; where their order is not known, as they are."""
    constants: list[Any] | None = constants_of(values)
    reverse = keywords.get("reverse", FALSE)
    if constants is None or "key" in keywords or not isinstance(reverse, Known):
        return tuple(values)
    try:
        order = sorted(range(len(constants)), key=constants.__getitem__, reverse=bool(reverse.value))
    except TypeError:
        return tuple(values)
    return tuple(values[i] for i in order)


def _put(
    machine: Machine, target: ListValue, values: tuple[Value, ...], open_: bool = False, exhaustive: bool = False
) -> Value:
    """Give a list other items."""
    full = len(values) > ITEM_LIMIT
    machine.store.set(target.key, ITEMS, Items(values[:ITEM_LIMIT], open_ or full, exhaustive and not full))
    return NONE


def _append(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    items = target.items(machine)
    # What is not followed to its end anyway is left as it is: nothing to join, after the loops that fill it.
    saturated = not items.exhaustive and items.size >= JOINED_LIMIT
    return NONE if saturated else _put(machine, target, (*items.values, site.args[0]), items.open, items.exhaustive)


def _add(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    known = bool(site.args) and site.args[0] in target.items(machine).values
    return NONE if known else _append(machine, target, site)


def _extend(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    items, more = target.items(machine), _more(machine, site)
    values = (*items.values, *more.values)
    values = distinct(values) if target.kind == "set" else values
    return _put(machine, target, values, items.open or more.open, items.exhaustive and more.exhaustive)


def _more(machine: Machine, site: CallSite) -> Items:
    """The items of what a method is given; of what cannot be iterated over none, and perhaps any."""
    return site.args[0].items(machine) or Items((), True)


def _insert(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if len(site.args) != 2:
        return None
    items, at = target.items(machine), site.args[0].whole_number
    values = list(items.values)
    last = len(values)
    values.insert(last if at is None else min(max(at, -last), last), site.args[1])  # a huge one is refused by Python
    return _put(machine, target, tuple(values), items.open or at is None)


def _append_left(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    items = target.items(machine)
    return _put(machine, target, (site.args[0], *items.values), items.open)


def _extend_left(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    items, more = target.items(machine), _more(machine, site)
    return _put(machine, target, (*reversed(more.values), *items.values), items.open or more.open)


def _pop(machine: Machine, target: ListValue, site: CallSite) -> Value:
    return _taken(machine, target, site.args[0].whole_number if site.args else -1)


def _pop_left(machine: Machine, target: ListValue, site: CallSite) -> Value:
    return _taken(machine, target, 0)


def _taken(machine: Machine, target: ListValue, at: int | None) -> Value:
    items = target.items(machine)
    if at is not None and not items.open and -items.size <= at < items.size:
        values = list(items.values)
        taken = values.pop(at)
        _put(machine, target, tuple(values))
        return taken
    _put(machine, target, items.values, True)
    return one_of(items.values) if items.values and not items.open else Unknown("the result of pop()")


def _clear(machine: Machine, target: ListValue, site: CallSite) -> Value:
    return _put(machine, target, ())


def _index(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    """Where a value first stands, where that is certain of each item in front of it."""
    if len(site.args) != 1 or site.keywords or target.kind == "set":
        return None
    wanted, items = site.args[0], target.items(machine)
    for number, item in enumerate(items.values):
        if not isinstance(item, Known) or not isinstance(wanted, Known):
            return Unknown(reason(item, wanted))
        if item.value == wanted.value:
            return Known(number, wanted.via | item.via)
    return Unknown("an operation that fails") if not items.open else None


def _count(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    values = constants_of(target.items(machine).values)
    if len(site.args) != 1 or values is None or target.items(machine).open or target.kind == "set":
        return None
    return _occurrences(values, site.args[0])


def _occurrences(values: list[Any], wanted: Value) -> Value:
    return Known(values.count(wanted.value), wanted.via) if isinstance(wanted, Known) else Unknown(reason(wanted))


def _remove(machine: Machine, target: ListValue, site: CallSite) -> Value | None:
    if not site.args:
        return None
    items = target.items(machine)
    at = next((number for number, value in enumerate(items.values) if value == site.args[0]), items.size)
    return _put(machine, target, (*items.values[:at], *items.values[at + 1 :]), items.open or at == items.size)


def _sort(machine: Machine, target: ListValue, site: CallSite) -> Value:
    items = target.items(machine)
    return _put(machine, target, in_order(items.values, site.keywords), items.open)


def _reverse(machine: Machine, target: ListValue, site: CallSite) -> Value:
    items = target.items(machine)
    return _put(machine, target, tuple(reversed(items.values)), items.open)


def _copy(machine: Machine, target: ListValue, site: CallSite) -> Value:
    items = target.items(machine)
    return new_list(machine, items.values, target.kind, items.open)


def _union(machine: Machine, target: ListValue, site: CallSite) -> Value:
    items, more = target.items(machine), _more(machine, site) if site.args else Items(())
    values = items.values + tuple(value for value in more.values if value not in items.values)
    return new_list(machine, values, target.kind, items.open or more.open)


_CHANGES = frozenset({"rotate", "difference_update", "intersection_update", "symmetric_difference_update"})
"""What leaves other items than were there."""

_METHODS: dict[str, Method] = {
    "add": _add,
    "append": _append,
    "appendleft": _append_left,
    "clear": _clear,
    "copy": _copy,
    "count": _count,
    "discard": _remove,
    "extend": _extend,
    "extendleft": _extend_left,
    "index": _index,
    "insert": _insert,
    "pop": _pop,
    "popleft": _pop_left,
    "remove": _remove,
    "reverse": _reverse,
    "sort": _sort,
    "union": _union,
    "update": _extend,
}

__all__ = ["call", "in_order"]
