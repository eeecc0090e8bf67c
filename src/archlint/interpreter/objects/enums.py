"""Members of enums."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    MEMBERS,
    ClassValue,
    Instance,
    Known,
    Unknown,
    Value,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def make_members(machine: Machine, cls: ClassValue) -> None:
    """Make objects of what the body of an enum assigns."""
    members: dict[str, Value] = {}
    for name in _assigned(cls.ir.body):
        value = machine.store.get(cls.key, name) or Unknown("an enum value")
        if value.dotted == "enum.auto":
            value = _automatic(cls, name, list(members.values()))
        same = _member_of(machine, cls, members, value)
        if same is not None:  # a second name of the same member
            machine.store.set(cls.key, name, same)
            continue
        member = Instance(cls, machine.store.new_key(), is_member=True)
        machine.store.set(member.key, "value", value)
        machine.store.set(member.key, "_value_", value)
        machine.store.set(member.key, "name", Known(name))
        machine.store.set(cls.key, name, member)
        members[name] = value
    machine.store.set(cls.key, MEMBERS, tuple(members))


def _member_of(machine: Machine, cls: ClassValue, members: dict[str, Value], value: Value) -> Value | None:
    """The member that has a constant for its value."""
    if not isinstance(value, Known):
        return None
    return next((machine.store.get(cls.key, name) for name, known in members.items() if known == value), None)


def _assigned(body: list[facts.Stmt]) -> Iterator[str]:
    """The names that are assigned in the body of a class, but for private ones."""
    for statement in body:
        targets: list[facts.Expr] = []
        match statement:
            case facts.Assign():
                targets = statement.targets
            case facts.Annotated() if statement.value is not None:
                targets = [statement.target]
        yield from (target.variable for target in targets if target.variable and not target.variable.startswith("_"))


def _automatic(cls: ClassValue, name: str, before: list[Value]) -> Value:
    """What ``enum.auto()`` stands for: the next number, bit or, of a ``StrEnum``, the name."""
    bases = set(cls.external_bases())
    if "enum.StrEnum" in bases:
        return Known(name.lower())
    numbers = [number for number in (value.whole_number for value in before) if number is not None]
    if len(numbers) < len(before) or numbers[-1:] != [max(numbers, default=0)][: len(numbers)]:
        return Unknown("an enum value")  # Pythons differ
    last = numbers[-1] if numbers else 0
    return Known(1 << last.bit_length() if {"enum.Flag", "enum.IntFlag"} & bases else last + 1)


def member(machine: Machine, cls: ClassValue, args: list[Value]) -> Value:
    """``Color(1)``: the member with a value, or one of them all."""
    members = cls.members(machine)
    if len(args) == 1 and isinstance(args[0], Known):
        for option in members:
            if isinstance(option, Instance) and option.member_value(machine) == args[0]:
                return option
    return one_of(members) if members else Unknown("an enum without members")


__all__ = ["make_members", "member"]
