"""Comprehensions: what they collect, and what stays open of it."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.assignment import assign
from archlint.interpreter.conditions import evaluate_test
from archlint.interpreter.containers import ITEM_LIMIT, entry_key, new_dict, new_list, unknown_item
from archlint.interpreter.limits import UNROLL
from archlint.interpreter.values import NONE, Unknown, UnknownKey, Value, reason
from archlint.reasons import Uninformative
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def comprehension(machine: Machine, e: facts.Comprehension) -> Value:
    activation = machine.activation
    outermost = machine.evaluate(e.generators[0].iterable)  # in the scope around: a class body has names of its own
    scope = machine.new_scope(activation.scope, activation.module, "comprehension", activation.qualified)
    kept, activation.scope = activation.scope, scope
    activation.scopes.append(scope.key)
    rows: list[tuple[Value, Value]] = []
    open_, exhaustive = False, True

    def walk(depth: int) -> None:
        nonlocal open_, exhaustive
        if len(rows) > ITEM_LIMIT:
            open_, exhaustive = True, False
            return
        if depth == len(e.generators):
            value = NONE if e.value is None else machine.evaluate(e.value)
            rows.append((machine.evaluate(e.element), value))
            return
        generator = e.generators[depth]
        iterable = machine.evaluate(generator.iterable) if depth else outermost
        items = iterable.items(machine)
        values: Sequence[Value]
        if items is None or len(items.values) > min(UNROLL, machine.items_left):
            open_, exhaustive = True, False
            values = (iterable.each or Unknown(_why_unknown_items(iterable)),)
        else:
            open_ = open_ or items.open
            exhaustive = exhaustive and items.exhaustive
            # What is filled later is gone through once, with an item that is not known.
            later = items.open and not items.exhaustive and not items.values
            values = (
                (unknown_item(machine, iterable, "the items of the collection are not known"),)
                if later
                else items.values
            )
            machine.items_left -= len(values)
        for item in values:
            assign(machine, generator.target, item)
            truths = [evaluate_test(machine, condition)[1] for condition in generator.conditions]
            if False in truths:
                continue
            if None in truths:
                open_ = True
            walk(depth + 1)

    try:
        walk(0)
    finally:
        activation.scope = kept
    return _collected(machine, e, rows, open_, exhaustive)


def _collected(
    machine: Machine, e: facts.Comprehension, rows: Sequence[tuple[Value, Value]], open_: bool, exhaustive: bool
) -> Value:
    """The collection of what a comprehension gave: keys with values, or elements."""
    if e.kind == "dict":
        entries: dict[Hashable, tuple[Value, Value]] = {}
        for key, value in rows:
            at = entry_key(machine, key)
            open_ = open_ or at is None
            entries[at if at is not None else UnknownKey(len(entries))] = (key, value)
        return new_dict(machine, entries, open_)
    return new_list(machine, [element for element, _ in rows], "set" if e.kind == "set" else "list", open_, exhaustive)


def _why_unknown_items(iterable: Value) -> str:
    match reason(iterable):
        case Uninformative():
            return "the collection that the loop iterates over is not known"
        case why:
            return why


__all__ = ["comprehension"]
