"""What makes one value of a collection: a number, an item, a verdict."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from archlint.interpreter.builtins.handlers import Handler, first
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import all_items, new_list
from archlint.interpreter.values import (
    Items,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    chosen_for,
    constant,
    constants_of,
    one_of,
    reason,
    via,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def length(machine: Machine, site: CallSite) -> Value:
    """``len``."""
    value = first(site)
    if isinstance(value, Known):
        return Unknown("the length of a number") if value.text is None else Known(len(value.text), value.via)
    items = value.items(machine)
    if items is None or items.open or isinstance(value, OneOf):
        return Unknown("the length of a collection that is not known", of_class="int")
    if isinstance(value, ListValue) and value.kind == "set" and constants_of(items.values) is None:
        return Unknown("how many items of this set are equal", of_class="int")
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
            return _clamped(items.values) or Unknown(reason(*items.values), of_class=_one_class(items.values))
        try:
            return constant(pick(constants), via(*items.values))
        except (TypeError, OverflowError):
            return Unknown("an operation that fails")

    return handler


def _clamped(values: Sequence[Value]) -> Value | None:
    """``min(speed, 1)``: the limit, or a number of which nothing is known; None of other values.

    A limit that is a whole number is one among floats, which a message does not take.
    """
    match values:
        case (Known(value=int() as limit, via=via_) as known, other) | (
            other,
            Known(value=int() as limit, via=via_) as known,
        ):
            if limit and not via_ and other.number_class != "int" and not isinstance(other, Known):
                return chosen_for(one_of((other, known)), "which of two numbers is larger")
    return None


def _one_class(values: Sequence[Value]) -> str | None:
    """The class that all of some numbers are of."""
    classes = {value.number_class for value in values}
    return classes.pop() if len(classes) == 1 else None


_total = extreme(sum)


def total(machine: Machine, site: CallSite) -> Value:
    """``sum``: of numbers; of lists, ``sum(lists, [])``, one list with all that they hold."""
    start = site.args[1] if len(site.args) == 2 else site.keywords.get("start")
    if start is None:
        return _total(machine, CallSite(site.args))
    lists = first(site).items(machine)
    if lists is None or not isinstance(start, ListValue) or start.kind != "list":
        return Unknown(reason(*site.args))
    parts = all_items(machine, (start, *lists.values))
    if parts is None:
        return Unknown(reason(*site.args))
    values = [value for part in parts for value in part.values]
    return new_list(machine, values, "list", lists.open or any(part.open for part in parts))


def quotient(machine: Machine, site: CallSite) -> Value:
    """``divmod``."""
    match constants_of(site.args):
        case [int() | float() as number, int() | float() as by] if by:
            pair = divmod(number, by)
            return new_list(machine, [constant(part, via(*site.args)) for part in pair], "tuple")
    return Unknown(reason(*site.args))


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
        return one_of((*items.values, *(default if items.open else ())))
    return default[0] if default and items is not None and not items.open else Unknown("an item of an iterator")


__all__ = ["any_or_all", "extreme", "following", "length", "total"]
