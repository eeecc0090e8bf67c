"""Binding assignment targets: names, attributes, items, and several at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.attributes import set_attribute
from archlint.interpreter.items import set_item
from archlint.interpreter.values import Unknown, Value, alternatives, one_of
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def assign(machine: Machine, target: facts.Expr, value: Value) -> None:
    """Bind an assignment target."""
    kind = target.__class__
    if kind is facts.Name:
        assert isinstance(target, facts.Name)
        machine.assign_name(target.id, value)
    elif kind is facts.Attribute:
        assert isinstance(target, facts.Attribute)
        set_attribute(machine, machine.evaluate(target.value), target.attr, value, target)
    elif kind is facts.Subscript:
        assert isinstance(target, facts.Subscript)
        set_item(machine, machine.evaluate(target.value), machine.evaluate(target.index), value)
    elif kind is facts.Sequence:
        assert isinstance(target, facts.Sequence)
        _unpack(machine, target.elements, value)
    elif kind is facts.Starred:
        assert isinstance(target, facts.Starred)
        assign(machine, target.value, value)


def _unpack(machine: Machine, targets: list[facts.Expr], value: Value) -> None:
    if isinstance(value, (Unknown,)):
        for target in targets:
            assign(machine, target, value)
        return
    rows = []
    for alternative in alternatives(value):
        items = containers.iterate(machine, alternative)
        rows.append(None if items is None or items.open else list(items.values))
    stars = [i for i, target in enumerate(targets) if isinstance(target, facts.Starred)]
    if any(row is None for row in rows) or stars or any(len(row or ()) != len(targets) for row in rows):
        if len(rows) == 1 and rows[0] is not None and len(stars) == 1 and len(rows[0]) >= len(targets) - 1:
            row, at = rows[0], stars[0]
            after = len(targets) - at - 1
            middle = row[at : len(row) - after]
            for target, item in zip(targets[:at], row[:at], strict=True):
                assign(machine, target, item)
            assign(machine, targets[at], containers.new_list(machine, middle))
            for target, item in zip(targets[at + 1 :], row[len(row) - after :], strict=True):
                assign(machine, target, item)
            return
        unknown = Unknown("the items of this value are not known")
        machine.library.lost(unknown, (value,), "it is unpacked from a list")
        for target in targets:
            assign(machine, target, unknown)
        return
    for i, target in enumerate(targets):
        assign(machine, target, one_of(row[i] for row in rows if row is not None))


__all__ = ["assign"]
