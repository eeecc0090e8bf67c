"""Loops: round by round where each round is known, else one round for all."""

from __future__ import annotations

from archlint.interpreter import containers, refusals
from archlint.interpreter.assignment import assign
from archlint.interpreter.augmented import forget_counters
from archlint.interpreter.conditions import evaluate_test
from archlint.interpreter.heap import Layer
from archlint.interpreter.limits import FLAG_ROUNDS, RETURNS, SHARE_OF_A_LOOP, UNROLL
from archlint.interpreter.machine import Machine, Status
from archlint.interpreter.narrowing import narrow
from archlint.interpreter.values import Items, Known, Unknown, Value, reason
from archlint.reasons import NOT_A_CONSTANT
from archlint.syntax import facts


def for_each(machine: Machine, s: facts.For) -> Status:
    iterable = machine.evaluate(s.iterable)
    if refusals.refuses_to_iterate(machine, iterable):
        return "raise"
    activation = machine.activation
    activation.loops.append(s)
    try:
        items = iterable.items(machine)
        if items is None or items.open or len(items.values) > UNROLL:
            return _loop_of_unknown(machine, s, iterable, items)
        last_step = _last_step(machine)
        for item in items.values:
            if len(activation.returns) > RETURNS or machine.steps > last_step:
                return _loop_of_unknown(machine, s, iterable, None)
            assign(machine, s.target, item)
            status = machine.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return _otherwise(machine, s)


def _loop_of_unknown(machine: Machine, s: facts.For, iterable: Value, items: Items | None) -> Status:
    if items is not None and len(items.values) <= UNROLL:
        for number, item in enumerate(items.values):
            with machine.arm(machine.branch_at(s.span, number), 0) as taken:
                assign(machine, s.target, item)
                machine.execute(s.body)
            machine.store.merge([taken[0], {}])
        if items.exhaustive or any(isinstance(item, Unknown) for item in items.values):
            return None
    with machine.arm(machine.branch_at(s.span), 0) as taken:
        forget_counters(machine, s.body)
        why = reason(iterable)
        if why is NOT_A_CONSTANT:
            why = "the collection that the loop iterates over is not known"
        assign(machine, s.target, containers.unknown_item(machine, iterable, why))
        status = machine.execute(s.body)
    _join_optional_body(machine, status, taken[0])
    return None


def _join_optional_body(machine: Machine, status: Status, written: Layer) -> None:
    """Go on after a body that may have run, or not."""
    machine.join([(None if status in ("break", "continue") else status, written), (None, {})])


def while_it_holds(machine: Machine, s: facts.While) -> Status:
    activation = machine.activation
    activation.loops.append(s)
    try:
        last_step, most = _last_step(machine), UNROLL
        for number in range(UNROLL):
            value, truth = evaluate_test(machine, s.test)
            if truth is False:
                break
            if number == 0 and isinstance(value, Known) and isinstance(value.value, bool) and _is_flag(s.test):
                most = FLAG_ROUNDS
            if number == most or machine.steps > last_step:
                return _loop_of_many(machine, s)
            constant = isinstance(s.test, facts.Literal)
            if truth is None or constant:
                return _loop_once(machine, s, certain=constant)
            status = machine.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
        else:
            return _loop_of_many(machine, s)
    finally:
        activation.loops.pop()
    return _otherwise(machine, s)


def _last_step(machine: Machine) -> float:
    """The last statement that a loop may begin a round at.  A program that came late is known to be cut short."""
    if machine.late:
        return machine.allowed_steps
    return machine.steps + SHARE_OF_A_LOOP * (machine.allowed_steps - machine.steps)


def _is_flag(test: facts.Expr) -> bool:
    """Whether a test asks only what variables hold, and neither compares nor calls anything."""
    match test:
        case facts.Unary(op="not", operand=operand):
            return _is_flag(operand)
        case facts.Boolean(values=values):
            return all(map(_is_flag, values))
        case facts.Attribute(value=value):
            return _is_flag(value)
    return isinstance(test, (facts.Name, facts.Implicit))


def _loop_of_many(machine: Machine, s: facts.While) -> Status:
    """More rounds than are followed: one more stands for them."""
    forget_counters(machine, s.body)
    return _loop_once(machine, s, certain=False)


def _loop_once(machine: Machine, s: facts.While, certain: bool) -> Status:
    if certain:
        forget_counters(machine, s.body)
        status = machine.execute(s.body)
        return status if status in ("return", "raise") else None
    with machine.arm(machine.branch_at(s.span), 0) as taken:
        narrow(machine, s.test, True)
        forget_counters(machine, s.body)
        status = machine.execute(s.body)
    _join_optional_body(machine, status, taken[0])
    return None


def _otherwise(machine: Machine, s: facts.For | facts.While) -> Status:
    """The ``else`` of a loop: only one of two ways on where a ``break`` may have left the loop."""
    if not s.orelse or id(s) not in machine.activation.left:
        return machine.execute(s.orelse)
    machine.activation.left.discard(id(s))
    return machine.join([machine.branch(machine.branch_at(s.span), 0, s.orelse), (None, {})])


__all__ = ["for_each", "while_it_holds"]
