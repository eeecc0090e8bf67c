"""How long the pauses of a loop take that counts its rounds by hand: ``while timeout > 0.0: …; timeout -= 0.1``."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known
from archlint.syntax import facts
from archlint.syntax.flow_blocks import Loop
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_UP = frozenset({">", ">="})
_DOWN = frozenset({"<", "<="})


def limit_of_rounds(run: Run, loop: Loop, test: facts.Expr, holds: bool) -> float | None:
    """The seconds of all pauses of a loop that a comparison of its counter ends, which comes out so; None where nobody
    knows how often it repeats."""
    match test:
        case facts.Compare(facts.Name(id=name), [op], [end]):
            ends_above = (op in _UP) == holds
        case facts.Compare(end, [op], [facts.Name(id=name)]):
            ends_above = (op in _DOWN) == holds
        case _:
            return None
    step, last = _step(run, loop, name), _number(run, end)
    first = None if step is None else _first(run, loop, name)
    if op not in _UP | _DOWN or step is None or last is None or first is None or (step > 0) != ends_above:
        return None
    pauses = _pauses(run, loop)
    return None if pauses is None else max(1, math.ceil((last - first) / step)) * pauses


def _step(run: Run, loop: Loop, name: str) -> float | None:
    """What every round adds to a variable; None where it is not the same each time, or anything else sets it."""
    steps = []
    for statement in statements_of(loop.statement.body):
        if not any(part.variable == name for target in statement.assigned for part in target.unpacked):
            continue
        own = [block for block in loop.blocks if block.statement is statement]
        if len(own) != 1 or not loop.is_in_every_round(own[0]):
            return None
        match statement:
            case facts.Augmented(op="+" | "-" as op, value=value):
                steps.append((_number(run, value), op))
            case facts.Assign(
                targets=[facts.Name()], value=facts.Binary("+" | "-" as op, facts.Name(id=before), value)
            ) if before == name:
                steps.append((_number(run, value), op))
            case _:
                return None
    if len(steps) != 1:
        return None
    [(step, op)] = steps
    return None if not step else step if op == "+" else -step


def _first(run: Run, loop: Loop, name: str) -> float | None:
    """What a variable holds in front of the loop: the number that the function gives it, or its argument."""
    inside = {id(statement) for statement in statements_of(loop.statement.body)}
    before = [
        statement
        for statement in statements_of(run.activation.body)
        if id(statement) not in inside
        and any(part.variable == name for target in statement.assigned for part in target.unpacked)
    ]
    match before:
        case []:
            return _value(run, facts.Name(name, loop.statement.span))
        case [facts.Assign(targets=[facts.Name()], value=value)]:
            return _number(run, value)
    return None


def _pauses(run: Run, loop: Loop) -> float | None:
    """The seconds that one round sleeps, all its calls taken together."""
    sleeps = [call for call in calls_in(loop.statement.body) if called_name(call) == "sleep"]
    seconds = [_number(run, call.args[0].value) if len(call.args) == 1 else None for call in sleeps]
    known = [pause for pause in seconds if pause is not None]
    return sum(known) if known and len(known) == len(seconds) else None


def _number(run: Run, expression: facts.Expr) -> float | None:
    """A number that is written here, or what a name or an attribute holds.  What is called for it (``get().value``) is
    not followed here: the call asks for the limits of its loops in turn."""
    match expression:
        case facts.Literal() | facts.Name() | facts.Attribute() if not any(calls_in(expression)):
            return _value(run, expression)
    return None


def _value(run: Run, expression: facts.Expr) -> float | None:
    value = run.evaluate(expression)
    if not isinstance(value, Known) or value.via or isinstance(value.value, bool):
        return None
    return float(value.value) if isinstance(value.value, (int, float)) else None


__all__ = ["limit_of_rounds"]
