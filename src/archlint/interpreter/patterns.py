"""Patterns of ``match``: whether they match, and the names that they bind."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.interpreter.operators import compare_values
from archlint.interpreter.values import DictValue, Entries, Items, ListValue, Unknown, Value
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def matches(machine: Machine, pattern: facts.Pattern, subject: Value) -> bool | None:
    """Whether a pattern matches; None where that is not known."""
    match pattern.kind, subject:
        case "capture", _:
            return True
        case "value", _ if pattern.value is not None:
            return compare_values(machine, "==", subject, machine.evaluate(pattern.value))
        case "or", _:
            verdicts = [matches(machine, part, subject) for part in pattern.parts]
            return True if True in verdicts else None if None in verdicts else False
        case "as", _ if pattern.parts:
            return matches(machine, pattern.parts[0], subject)
        case "mapping", DictValue():
            return _matches_mapping(machine, pattern, subject.entries(machine))
        case "sequence", ListValue():
            return _matches_sequence(machine, pattern, subject.items(machine))
    return None


def _matches_sequence(machine: Machine, pattern: facts.Pattern, items: Items) -> bool | None:
    if items.open or any(part.kind == "other" for part in pattern.parts):
        return None
    if items.size != len(pattern.parts):
        return False
    return _all(matches(machine, part, item) for part, item in zip(pattern.parts, items.values, strict=True))


def _matches_mapping(machine: Machine, pattern: facts.Pattern, entries: Entries) -> bool | None:
    verdicts: list[bool | None] = []
    for part in pattern.parts:
        if part.kind != "entry" or part.value is None:
            continue
        at = machine.evaluate(part.value).entry_key()
        entry = None if at is None else entries.entries.get(at)
        if entry is None:
            verdicts.append(None if entries.open or at is None else False)
        else:
            verdicts.append(matches(machine, part.parts[0], entry[1]))
    return _all(verdicts)


def _all(verdicts: Iterable[bool | None]) -> bool | None:
    different = set(verdicts)
    return False if False in different else None if None in different else True


def bind_pattern(machine: Machine, pattern: facts.Pattern, subject: Value) -> None:
    """Bind the names of a pattern that matches."""
    if pattern.name is not None:
        machine.assign_name(pattern.name, subject)
    if pattern.kind == "mapping" and isinstance(subject, DictValue):
        _bind_mapping(machine, pattern, subject.entries(machine))
        return
    items = subject.items(machine) if pattern.kind == "sequence" else None
    known = () if items is None or items.open else items.values
    for number, part in enumerate(pattern.parts):
        if pattern.kind in ("as", "or"):
            bind_pattern(machine, part, subject)
        elif number < len(known):
            bind_pattern(machine, part, known[number])
        else:
            bind_pattern(machine, part, Unknown("part of a value that a pattern matches"))


def _bind_mapping(machine: Machine, pattern: facts.Pattern, entries: Entries) -> None:
    for part in pattern.parts:
        at = None if part.value is None else machine.evaluate(part.value).entry_key()
        known = part.kind == "entry" and at in entries.entries
        value = entries.entries[at][1] if known and at is not None else Unknown("part of a mapping")
        bind_pattern(machine, part.parts[0], value)


__all__ = ["bind_pattern", "matches"]
