"""What makes collections, goes through them or counts what is in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from archlint.interpreter.builtins.handlers import Handler, because_of, first
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import ITEM_LIMIT, new_dict, new_list
from archlint.interpreter.objects.dicts import updated
from archlint.interpreter.objects.lists import in_order
from archlint.interpreter.values import (
    EachValue,
    Entries,
    Items,
    Known,
    ListKind,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    constant,
    constants_of,
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
    return because_of(value) if items is None else new_list(machine, items.values, kind, items.open)


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
    return new_list(machine, [Known(number, via(*site.args)) for number in wanted])


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
        return _rows([arg.each or Unknown("an item beside others") for arg in site.args], machine)
    columns = _all_items(machine, site.args)
    if not columns:
        return Unknown(reason(*site.args))
    pairs = zip(*(column.values for column in columns), strict=False)
    rows = [new_list(machine, row, "tuple") for row in pairs]
    return new_list(machine, rows, "list", any(column.open for column in columns))


def _all_items(machine: Machine, values: Sequence[Value]) -> list[Items] | None:
    """The items of several collections; None where one of them is not known."""
    rows = [value.items(machine) for value in values]
    known = [row for row in rows if row is not None]
    return known if len(known) == len(rows) else None


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
        return Unknown("what filter() leaves")
    function, iterable = site.args
    if iterable.each is not None:
        return iterable
    items = iterable.items(machine)
    if items is None:
        return Unknown("what filter() leaves")
    kept: list[Value] = []
    open_ = items.open
    for item in items.values:
        result = item if function.is_none else machine.call(function, CallSite([item]))
        verdict = result.truth(machine)
        if verdict is not False:
            kept.append(item)
        open_ = open_ or verdict is None
    return new_list(machine, kept, "list", open_)


# ------------------------------------------------------------------------------------------ from all to one


def length(machine: Machine, site: CallSite) -> Value:
    """``len``."""
    value = first(site)
    if isinstance(value, Known):
        return Unknown("the length of a number") if value.text is None else Known(len(value.text), value.via)
    items = value.items(machine)
    if items is None or items.open or isinstance(value, OneOf):
        return Unknown("the length of a collection that is not known")
    if isinstance(value, ListValue) and value.kind == "set" and constants_of(items.values) is None:
        return Unknown("how many items of this set are the same")
    return Known(items.size)


def extreme(pick: Callable[[Any], Any]) -> Handler:
    """``min``, ``max``, and the ``sum`` of numbers."""

    def handler(machine: Machine, site: CallSite) -> Value:
        if len(site.args) == 1 and site.args[0].each is not None:
            return site.args[0].each
        items = site.args[0].items(machine) if len(site.args) == 1 else Items(tuple(site.args))
        if items is None or items.open or "key" in site.keywords:
            return Unknown(reason(*site.args))
        constants = constants_of(items.values)
        if not constants:
            return Unknown(reason(*items.values))
        try:
            return constant(pick(constants), via(*items.values))
        except (TypeError, OverflowError):
            return Unknown("an operation that fails")

    return handler


_total = extreme(sum)


def total(machine: Machine, site: CallSite) -> Value:
    """``sum``: of numbers; of lists, ``sum(lists, [])``, one list with all that they hold."""
    start = site.args[1] if len(site.args) == 2 else site.keywords.get("start")
    if start is None:
        return _total(machine, CallSite(site.args))
    lists = first(site).items(machine)
    if lists is None or not isinstance(start, ListValue) or start.kind != "list":
        return Unknown(reason(*site.args))
    parts = _all_items(machine, (start, *lists.values))
    if parts is None:
        return Unknown(reason(*site.args))
    values = [value for part in parts for value in part.values]
    return new_list(machine, values, "list", lists.open or any(part.open for part in parts))


def any_or_all(wanted: bool) -> Handler:
    """``any`` where ``wanted`` is true, else ``all``."""

    def handler(machine: Machine, site: CallSite) -> Value:
        items = first(site).items(machine)
        if items is None:
            return Unknown(reason(*site.args))
        verdicts = [item.truth(machine) for item in items.values]
        if wanted in verdicts:
            return Known(wanted)
        return Unknown("not all items are known") if None in verdicts or items.open else Known(not wanted)

    return handler


def following(machine: Machine, site: CallSite) -> Value:
    """``next``."""
    iterable, default = first(site), site.args[1:]
    if iterable.each is not None:
        return one_of((iterable.each, *default))
    items = iterable.items(machine)
    if items is not None and items.values:
        return one_of(items.values)
    return default[0] if default and items is not None and not items.open else Unknown("an item of an iterator")


__all__ = [
    "any_or_all",
    "collect",
    "dictionary",
    "enumerated",
    "extreme",
    "filtered",
    "following",
    "in_reverse",
    "in_sequence",
    "length",
    "mapped",
    "numbers",
    "total",
    "zipped",
]
