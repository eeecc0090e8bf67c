"""What makes collections, goes through them or counts what is in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.builtins.handlers import Handler, because_of, first
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import ITEM_LIMIT, all_items, new_dict, new_list
from archlint.interpreter.objects.dicts import updated
from archlint.interpreter.objects.lists import in_order
from archlint.interpreter.values import (
    EachValue,
    Entries,
    Items,
    Known,
    ListKind,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
    via,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


# ------------------------------------------------------------------------------------------ making collections


def collect(kind: ListKind) -> Handler:
    """``list``, ``tuple``, ``set``."""

    def handler(machine: Machine, site: CallSite) -> Value:
        if not site.args:
            return new_list(machine, [], kind)
        return one_of(_collected(machine, option, kind) for option in alternatives(site.args[0]))

    return handler


def _collected(machine: Machine, value: Value, kind: ListKind) -> Value:
    if value.each is not None:
        return value
    items = value.items(machine)
    if items is None:
        return replace(because_of(value), never_none=True)
    return new_list(machine, items.values, kind, items.open)


def dictionary(machine: Machine, site: CallSite) -> Value:
    """``dict``."""
    entries = updated(machine, Entries({}), site)
    return new_dict(machine, entries.entries, entries.open)


def numbers(machine: Machine, site: CallSite) -> Value:
    """``range``."""
    bounds = [number for number in (arg.whole_number for arg in site.args) if number is not None]
    if not bounds or len(bounds) != len(site.args):
        return because_of(*site.args)
    try:
        wanted = range(*bounds)
    except (TypeError, ValueError):
        return Unknown("a range that fails")
    if wanted[ITEM_LIMIT:]:  # its length may be too large a number for len()
        return Unknown("a range too long to follow")
    parameters = via(*site.args)
    if not wanted and parameters and not machine.are_settled(parameters):
        return Unknown("a parameter says how many, and its default is none", min(parameters))
    return new_list(machine, [Known(number, parameters) for number in wanted])


# ------------------------------------------------------------------------------------- from one to another


def _rows(row: list[Value], machine: Machine) -> Value:
    return EachValue(new_list(machine, row, "tuple"))


def enumerated(machine: Machine, site: CallSite) -> Value:
    """``enumerate``."""
    iterable = first(site)
    if iterable.each is not None:
        return _rows([Unknown("the number of an item"), iterable.each], machine)
    items = iterable.items(machine)
    if items is None:
        return Unknown(reason(*site.args))
    start = site.args[1] if len(site.args) > 1 else site.keywords.get("start", Known(0))
    base = start.whole_number
    places = [start if base is None else Known(base + number) for number in range(items.size)]
    pairs = zip(places, items.values, strict=True)
    return new_list(machine, [new_list(machine, pair, "tuple") for pair in pairs], "list", items.open)


def zipped(machine: Machine, site: CallSite) -> Value:
    """``zip``."""
    if any(arg.each is not None for arg in site.args):
        return _rows([arg.each or Unknown("an item of several collections") for arg in site.args], machine)
    columns = all_items(machine, site.args)
    if not columns:
        return Unknown(reason(*site.args))
    pairs = zip(*(column.values for column in columns), strict=False)
    rows = [new_list(machine, row, "tuple") for row in pairs]
    return new_list(machine, rows, "list", any(column.open for column in columns))


def reordered(order: Callable[[Items, CallSite], Sequence[Value]]) -> Handler:
    """``sorted``, ``reversed``."""

    def handler(machine: Machine, site: CallSite) -> Value:
        iterable = first(site)
        if iterable.each is not None:
            return iterable
        items = iterable.items(machine)
        if items is None:
            return Unknown(reason(*site.args))
        return new_list(machine, order(items, site), "list", items.open)

    return handler


def _backwards(items: Items, site: CallSite) -> Sequence[Value]:
    return items.values[::-1]


def _sorted(items: Items, site: CallSite) -> Sequence[Value]:
    return in_order(items.values, site.keywords)


in_reverse = reordered(_backwards)
in_sequence = reordered(_sorted)


def mapped(machine: Machine, site: CallSite) -> Value:
    """``map``."""
    if len(site.args) != 2:
        return Unknown("map() over several collections")
    function, iterable = site.args
    items = iterable.items(machine)
    if items is None:
        return Unknown(reason(iterable))
    results = [machine.call(function, CallSite([item])) for item in items.values]
    return new_list(machine, results, "list", items.open)


def filtered(machine: Machine, site: CallSite) -> Value:
    """``filter``."""
    if len(site.args) != 2:
        return Unknown("the result of filter()")
    function, iterable = site.args
    if iterable.each is not None:
        return iterable
    items = iterable.items(machine)
    if items is None:
        return Unknown("the result of filter()")
    kept: list[Value] = []
    open_ = items.open
    for item in items.values:
        result = item if function.is_none else machine.call(function, CallSite([item]))
        verdict = result.truth(machine)
        if verdict is not False:
            kept.append(item)
        open_ = open_ or verdict is None
    return new_list(machine, kept, "list", open_)


__all__ = [
    "collect",
    "dictionary",
    "enumerated",
    "filtered",
    "in_reverse",
    "in_sequence",
    "mapped",
    "numbers",
    "zipped",
]
