"""Decisions: what a test decides, what it proves inside a branch, and which pattern matches."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import set_attribute
from archlint.interpreter.classes import class_lookup
from archlint.interpreter.containers import entries_of, hashable, items_of, iterate
from archlint.interpreter.operators import compare_values, is_object
from archlint.interpreter.type_tests import classes_of, is_any
from archlint.interpreter.values import (
    ApiMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def truth(machine: Machine, value: Value) -> bool | None:
    """Whether a value is true; None where that is not known.

    A parameter's default is one value of many: the default decides nothing.  What a launch file sets decides
    while the program starts; callbacks may see what was set later.
    """
    if isinstance(value, Known):
        settled = not value.via or machine.library.are_settled(value.via)
        return bool(value.value) if settled else None
    if isinstance(value, OneOf):
        found = {truth(machine, alternative) for alternative in value.values}
        return found.pop() if len(found) == 1 else None
    if isinstance(value, ListValue):
        items = items_of(machine, value)
        return True if items.values and not items.open else None if items.open else False
    if isinstance(value, DictValue):
        entries = entries_of(machine, value)
        return True if entries.entries and not entries.open else None if entries.open else False
    if isinstance(value, Holed):
        return True if any(value.parts) else None
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        return _object_truth(machine, value, value.cls)
    if isinstance(value, ApiMethod):
        return None  # what a library's object has may be a property: goal_handle.is_cancel_requested
    if is_object(value):
        return True
    return None


def _object_truth(machine: Machine, value: Instance, cls: ClassValue) -> bool | None:
    """An object is true, but where its class says otherwise: members of ``IntEnum`` are as true as their numbers."""
    held = value.member_value(machine)
    if held is not None and set(cls.external_bases()) - {"enum.Enum"}:
        return truth(machine, held)
    says = any(class_lookup(machine, cls, name)[0] is not None for name in ("__bool__", "__len__"))
    return None if says else True


def narrow(machine: Machine, test: facts.Expr, holds: bool) -> None:
    """Keep what a test proves about a variable or attribute inside a branch."""
    if isinstance(test, facts.Unary) and test.op == "not":
        narrow(machine, test.operand, not holds)
    elif isinstance(test, facts.Boolean):
        if (test.op == "and") == holds:
            for value in test.values:
                narrow(machine, value, holds)
    elif isinstance(test, (facts.Name, facts.Attribute)):
        _keep(machine, test, lambda value: _raw_truth(machine, value) in (None, holds))
    elif isinstance(test, facts.Assigned):
        narrow(machine, test.target, holds)
    elif isinstance(test, facts.Call):
        _narrow_class(machine, test, holds)
    elif isinstance(test, facts.Compare) and len(test.ops) == 1:
        op, other = test.ops[0], test.comparators[0]
        if op in ("is not", "!=", "not in"):
            op, holds = {"is not": "is", "!=": "==", "not in": "in"}[op], not holds
        if not isinstance(test.left, (facts.Name, facts.Attribute)) or op not in ("is", "==", "in"):
            return
        if not isinstance(other, (facts.Literal, facts.Name, facts.Attribute, facts.Sequence)):
            return
        right = machine.evaluate(other)
        proven = right if holds and op == "==" and isinstance(right, Known) else None
        _keep(machine, test.left, lambda value: compare_values(machine, op, value, right) in (None, holds), proven)


def _narrow_class(machine: Machine, test: facts.Call, holds: bool) -> None:
    """``isinstance(self.robot, Mock)``: keep the alternatives that are, or may be, of the class, or not of it."""
    if len(test.args) != 2 or any(argument.keyword is not None or argument.star for argument in test.args):
        return
    subject, of = (argument.value for argument in test.args)
    if not isinstance(subject, (facts.Name, facts.Attribute)) or machine.evaluate(test.func) != Builtin("isinstance"):
        return
    classes = classes_of(machine, machine.evaluate(of))
    if classes is not None:
        _keep(machine, subject, lambda value: is_any(machine, value, classes) in (None, holds))


def _raw_truth(machine: Machine, value: Value) -> bool | None:
    """Like :func:`truth`, with a parameter's default taken at its word."""
    return bool(value.value) if isinstance(value, Known) else truth(machine, value)


def _keep(
    machine: Machine,
    target: facts.Name | facts.Attribute,
    wanted: Callable[[Value], bool],
    proven: Value | None = None,
) -> None:
    """Drop the alternatives that a test rules out.  Where none is left (a parameter's default that this
    branch contradicts), the value is what the test proves, or unknown."""
    if isinstance(target, facts.Attribute) and not isinstance(target.value, facts.Name):
        return
    before = machine.lookup(target.id) if isinstance(target, facts.Name) else machine.evaluate(target)
    if before is None:
        return
    kept = [value for value in alternatives(before) if wanted(value)]
    after: Value
    if kept:
        after = one_of(kept)
        if proven is not None and isinstance(after, Unknown):
            after = proven
    elif proven is not None:
        after = Known(proven.value, via(before)) if isinstance(proven, Known) else proven
    else:
        names = sorted(via(before))
        if not names:
            return
        after = Unknown(f"the parameter '{names[0]}' decides it", names[0])
    if after is before or (isinstance(before, (Unknown, Known)) and after == before):
        return
    if isinstance(target, facts.Name):
        machine.assign_name(target.id, after)
    else:
        # A test changes nothing: what it proves of an object that all programs share must not be kept there.
        own = [value for value in alternatives(machine.evaluate(target.value)) if not isinstance(value, External)]
        if own:
            set_attribute(machine, one_of(own), target.attr, after)


def matches(machine: Machine, pattern: facts.Pattern, subject: Value) -> bool | None:
    if pattern.kind == "capture":
        return True
    if pattern.kind == "value" and pattern.value is not None:
        return compare_values(machine, "==", subject, machine.evaluate(pattern.value))
    if pattern.kind == "or":
        verdicts = [matches(machine, part, subject) for part in pattern.parts]
        return True if True in verdicts else None if None in verdicts else False
    if pattern.kind == "as" and pattern.parts:
        return matches(machine, pattern.parts[0], subject)
    if pattern.kind == "mapping" and isinstance(subject, DictValue):
        return _matches_mapping(machine, pattern, subject)
    if pattern.kind == "sequence" and isinstance(subject, ListValue):
        items = items_of(machine, subject)
        if items.open or any(part.kind == "other" for part in pattern.parts):
            return None
        if len(items.values) != len(pattern.parts):
            return False
        verdicts = [matches(machine, p, v) for p, v in zip(pattern.parts, items.values, strict=True)]
        return False if False in verdicts else None if None in verdicts else True
    return None


def _matches_mapping(machine: Machine, pattern: facts.Pattern, subject: DictValue) -> bool | None:
    entries = entries_of(machine, subject)
    verdicts: list[bool | None] = []
    for part in pattern.parts:
        if part.kind != "entry" or part.value is None:
            continue
        at = hashable(machine.evaluate(part.value))
        found = entries.entries.get(at) if at is not None else None
        if found is None:
            verdicts.append(None if entries.open or at is None else False)
        else:
            verdicts.append(matches(machine, part.parts[0], found[1]))
    return False if False in verdicts else None if None in verdicts else True


def bind_pattern(machine: Machine, pattern: facts.Pattern, subject: Value) -> None:
    if pattern.name is not None:
        machine.assign_name(pattern.name, subject)
    if pattern.kind == "mapping" and isinstance(subject, DictValue):
        entries = entries_of(machine, subject).entries
        for part in pattern.parts:
            at = hashable(machine.evaluate(part.value)) if part.value is not None else None
            if part.kind == "entry" and at in entries:
                bind_pattern(machine, part.parts[0], entries[at][1])
            else:
                bind_pattern(machine, part.parts[0], Unknown("part of a mapping"))
        return
    items = iterate(machine, subject) if pattern.kind == "sequence" else None
    for number, part in enumerate(pattern.parts):
        if pattern.kind in ("as", "or"):
            bind_pattern(machine, part, subject)
        elif items is not None and not items.open and number < len(items.values):
            bind_pattern(machine, part, items.values[number])
        else:
            bind_pattern(machine, part, Unknown("part of a value that a pattern takes apart"))
