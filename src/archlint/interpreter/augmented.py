"""``x += y``: a collection grows where it is, everything else gets a new value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import operators
from archlint.interpreter.assignment import assign
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.machine import Phase
from archlint.interpreter.values import DictValue, Known, ListValue, Unknown, Value, alternatives
from archlint.reasons import Uninformative
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine, Status


def augmented(machine: Machine, s: facts.Augmented) -> Status:
    # What counts up at run time has no one value: only a straight run of a function keeps it known.
    before = machine.evaluate(s.target)
    operand = machine.evaluate(s.value)
    grows = _GROWS.get(s.op) if _is_collection(before) else None
    if grows is not None:
        # The collection itself grows: whoever else holds it sees that, and no second one comes of it.
        machine.call(get_attribute(machine, before, grows), CallSite([operand]))
        assign(machine, s.target, before)
        return None
    value = operators.binary(machine, s.op, before, operand, s.span)
    counted = s.target.attribute and machine.phase is Phase.LATER
    if counted and isinstance(value, Known) and not value.is_text:
        value = Unknown(Uninformative("the value changes at run time"), of_class=value.number_class)
    assign(machine, s.target, value)
    return None


_GROWS: dict[facts.BinaryOperator, str] = {
    "+": "extend",
    "|": "update",
    "-": "difference_update",
    "&": "intersection_update",
    "^": "symmetric_difference_update",
}
"""The method that changes a collection as ``+=`` and the like do."""


def _is_collection(value: Value) -> bool:
    """Whether a value is a list, set or dict, which ``+=`` and ``|=`` change in place."""
    return all(map(_is_mutable, alternatives(value)))


def _is_mutable(value: Value) -> bool:
    match value:
        case DictValue() | ListValue(kind="list" | "set"):
            return True
    return False


def forget_counters(machine: Machine, block: list[facts.Stmt]) -> None:
    """A loop that is run once stands for many rounds: what it counts up is no longer known."""
    for statement in block:
        match statement:
            case facts.Augmented(target=facts.Name(id=name)):
                before = machine.lookup(name)
                if before is None or not _is_collection(before):
                    machine.assign_name(name, Unknown(Uninformative("the value changes in a loop")))
            case facts.If() | facts.While() | facts.For():
                forget_counters(machine, statement.body)
                forget_counters(machine, statement.orelse)
            case facts.With() | facts.Try():
                forget_counters(machine, statement.body)
