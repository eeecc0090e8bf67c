"""Binding assignment targets: names, attributes, items, and several at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.attributes import has_member, set_attribute
from archlint.interpreter.items import set_item
from archlint.interpreter.values import Unknown, Value, alternatives, one_of
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def assign(machine: Machine, target: facts.Expr, value: Value) -> None:
    """Bind an assignment target."""
    match target:
        case facts.Name():
            machine.assign_name(target.id, value)
        case facts.Implicit():
            itself = machine.lookup("self")
            if itself is None or (
                machine.lookup(target.name) is not None and not has_member(machine, itself, target.name)
            ):
                machine.assign_around(target.name, value)
            else:
                set_attribute(machine, itself, target.name, value)
        case facts.Attribute():
            set_attribute(machine, machine.evaluate(target.value), target.attr, value, target)
        case facts.Subscript():
            container, index = machine.evaluate(target.value), machine.evaluate(target.index)
            set_item(machine, container, index, value)
            if container.dotted:
                machine.library.note_item(container.dotted, index, value, target)
        case facts.Sequence():
            _unpack(machine, target.elements, value)
        case facts.Starred():
            assign(machine, target.value, value)


def assign_where_it_is(machine: Machine, target: facts.Expr, value: Value) -> None:
    """A call assigns to a variable that it is given, of whichever scope around that is; nothing for what is none."""
    bound = machine.activation.scope.bound
    if isinstance(target, facts.Name) and bound is not None and target.id not in bound:
        machine.assign_around(target.id, value)  # no statement of this function assigns to it
    elif isinstance(target, (facts.Name, facts.Implicit, facts.Attribute, facts.Subscript)):
        assign(machine, target, value)


def _unpack(machine: Machine, targets: list[facts.Expr], value: Value) -> None:
    rows = [_row(machine, option) for option in alternatives(value)]
    known = [row for row in rows if row is not None]
    stars = [i for i, target in enumerate(targets) if isinstance(target, facts.Starred)]
    if len(known) == len(rows) and not stars and all(len(row) == len(targets) for row in known):
        for i, target in enumerate(targets):
            assign(machine, target, one_of(row[i] for row in known))
    elif len(rows) == len(known) == len(stars) == 1 and len(known[0]) >= len(targets) - 1:
        _unpack_starred(machine, targets, known[0], stars[0])
    elif isinstance(value, Unknown):
        for target in targets:
            assign(machine, target, value)
    else:
        unknown = Unknown("the items of this value are not known")
        machine.library.lost(unknown, (value,), "it is unpacked from a list")
        for target in targets:
            assign(machine, target, unknown)


def _row(machine: Machine, value: Value) -> tuple[Value, ...] | None:
    """The items of a collection of which all are known."""
    items = value.items(machine)
    return None if items is None or items.open else items.values


def _unpack_starred(machine: Machine, targets: list[facts.Expr], row: tuple[Value, ...], at: int) -> None:
    """``first, *rest = row``: the target at a place takes what the others leave."""
    after = len(row) - (len(targets) - at - 1)
    for target, item in zip(targets[:at], row[:at], strict=True):
        assign(machine, target, item)
    assign(machine, targets[at], containers.new_list(machine, row[at:after]))
    for target, item in zip(targets[at + 1 :], row[after:], strict=True):
        assign(machine, target, item)


__all__ = ["assign", "assign_where_it_is"]
