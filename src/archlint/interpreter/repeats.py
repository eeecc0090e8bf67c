"""Calls that a run has followed before: which of them are alike, and what the next one gives.

A function is followed a few times with the same arguments.  What it gave then is the answer to one more such call only
where nothing that it reads or writes has changed since, and where it makes no object.  Otherwise it is followed some
more times, and then its answer is unknown: that of another call is never used in its place.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.activation import Repeated
from archlint.interpreter.heap import Slot
from archlint.interpreter.identity import Key, argument_key
from archlint.interpreter.values import FunctionValue, PythonValue, Unknown, Value

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from archlint.interpreter.machine import Machine

REPEATS = 3
"""How often one root runs a function with the same arguments, whatever it does."""
AGAIN = 12
"""How often it runs one with the same arguments that does something else each time, or makes an object."""


def call_key(function: FunctionValue, args: Iterable[Value], keywords: Mapping[str, Value]) -> Key:
    """What sets one call apart from another: the function, what it closes over, and the arguments."""
    named = tuple((name, argument_key(value)) for name, value in sorted(keywords.items()))
    return (argument_key(function), tuple(map(argument_key, args)), named)


def follow(machine: Machine, function: FunctionValue, key: Key, enter: Callable[[], Value]) -> Value:
    """What a call gives: it is followed, by ``enter``, as long as it may give or do something new."""
    known = machine.repeats.setdefault(key, Repeated())
    if known.count >= REPEATS:
        if known.value is None:
            return Unknown(f"'{function.qualified}' calls itself")
        if known.around is not None and _holds(machine, known.around):
            return known.value
        if known.count >= AGAIN:
            if machine.library.matters(function.ir):
                machine.give_up()
            return Unknown(f"'{function.qualified}' is called too often to follow")
    else:
        runs = machine.runs.get(id(function.ir), 0)
        if runs >= machine.allowed_runs:
            machine.give_up()
            return Unknown(f"'{function.qualified}' is called too often to follow")
        machine.runs[id(function.ir)] = runs + 1
    known.count += 1
    known.value, known.around = None, None
    if known.count < REPEATS:
        known.value = enter()
        return known.value
    before = machine.store.new_key()
    with machine.store.watched() as around:
        value = enter()
    known.value = value
    known.around = around if is_older(value, before) else None
    return value


def _holds(machine: Machine, around: Mapping[Slot, object]) -> bool:
    """Whether the state is as it was, as far as these slots go."""
    return all(_same(machine.store.value_at(at), value) for at, value in around.items())


def _same(now: object, then: object) -> bool:
    if now is then:
        return True
    return isinstance(now, Value) and isinstance(then, Value) and argument_key(now) == argument_key(then)


def is_older(value: Value, before: int) -> bool:
    """Whether a value holds no object that was made after the key ``before`` was."""
    if isinstance(value, PythonValue):
        return False
    if isinstance(value, FunctionValue):
        return value.scope.key <= before and all(is_older(default, before) for _, default in value.defaults)
    return (value.heap_key or 0) <= before and all(is_older(part, before) for part in value.inner)
