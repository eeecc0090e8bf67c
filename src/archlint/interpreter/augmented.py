"""``x += y``: a collection grows where it is, everything else gets a new value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import operators
from archlint.interpreter.assignment import assign
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.machine import Phase
from archlint.interpreter.values import DictValue, Known, ListValue, Unknown, Value, alternatives
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
    counted = isinstance(s.target, facts.Attribute) and machine.phase is Phase.LATER
    if counted and isinstance(value, Known) and not isinstance(value.value, str):
        value = Unknown("the value changes at run time")
    assign(machine, s.target, value)
    return None


_GROWS = {
    "+": "extend",
    "|": "update",
    "-": "difference_update",
    "&": "intersection_update",
    "^": "symmetric_difference_update",
}
"""The method that changes a collection as ``+=`` and the like do."""


def _is_collection(value: Value) -> bool:
    """Whether a value is a list, set or dict, which ``+=`` and ``|=`` change in place."""
    options = alternatives(value)
    return all(isinstance(o, DictValue) or (isinstance(o, ListValue) and o.kind in ("list", "set")) for o in options)


def forget_counters(machine: Machine, block: list[facts.Stmt]) -> None:
    """A loop that is run once stands for many rounds: what it counts up is no longer known."""
    for statement in block:
        if isinstance(statement, facts.Augmented) and isinstance(statement.target, facts.Name):
            before = machine.lookup(statement.target.id)
            if before is None or not _is_collection(before):
                machine.assign_name(statement.target.id, Unknown("the value changes in a loop"))
        elif isinstance(statement, (facts.If, facts.While, facts.For)):
            forget_counters(machine, statement.body)
            forget_counters(machine, statement.orelse)
        elif isinstance(statement, (facts.With, facts.Try)):
            forget_counters(machine, statement.body)
