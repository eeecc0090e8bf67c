"""``x += y``: a collection grows where it is, everything else gets a new value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import operators
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import DictValue, Known, ListValue, Unknown, Value, alternatives
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Run, Status


def augmented(run: Run, s: facts.Augmented) -> Status:
    from archlint.interpreter.statements import assign

    # What counts up at run time has no one value: only a straight run of a function keeps it known.
    before = run.evaluate(s.target)
    operand = run.evaluate(s.value)
    grows = _GROWS.get(s.op) if _is_collection(before) else None
    if grows is not None:
        # The collection itself grows: whoever else holds it sees that, and no second one comes of it.
        run.call(get_attribute(run, before, grows), [operand], {})
        assign(run, s.target, before)
        return None
    value = operators.binary(run, s.op, before, operand, s.span)
    counted = isinstance(s.target, facts.Attribute) and run.context.role not in ("init", "main", "module")
    if counted and isinstance(value, Known) and not isinstance(value.value, str):
        value = Unknown("the value changes at run time")
    assign(run, s.target, value)
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


def forget_counters(run: Run, block: list[facts.Stmt]) -> None:
    """A loop that is run once stands for many rounds: what it counts up is no longer known."""
    for statement in block:
        if isinstance(statement, facts.Augmented) and isinstance(statement.target, facts.Name):
            before = run.lookup(statement.target.id)
            if before is None or not _is_collection(before):
                run.assign_name(statement.target.id, Unknown("the value changes in a loop"))
        elif isinstance(statement, (facts.If, facts.While, facts.For)):
            forget_counters(run, statement.body)
            forget_counters(run, statement.orelse)
        elif isinstance(statement, (facts.With, facts.Try)):
            forget_counters(run, statement.body)
