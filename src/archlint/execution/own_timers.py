"""Timers that some code ends: in their own callback, so that it runs once, or elsewhere."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_after, always_comes_before, path_comes_before, paths_to
from archlint.analysis.reach import calls_of, creations_of
from archlint.analysis.source_code import source_code
from archlint.execution.ways_out import lines_of_miss
from archlint.finding import Place
from archlint.model import Role
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall, Callback, Creation
    from archlint.systems.model import System

ENDS_TIMER = ("rclpy.timer.Timer.cancel", "rclpy.timer.Timer.destroy", "rclpy.node.Node.destroy_timer")
"""The calls that end a timer."""


def ends_its_timer_before(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback has ended the timer by the time it comes to a call: there is no next turn."""
    code = source_code(system)
    return any(always_comes_before(code, end, call) for end in _ends_of_timer(system, call))


def ends_its_timer_after(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback that has come to a call ends the timer: it comes there once."""
    code = source_code(system)
    return any(always_comes_after(code, end, call) for end in _ends_of_timer(system, call))


def runs_once(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback that comes to a call comes there once: it ends the timer before or afterwards, be that
    only if it is there: ``if self.timer: self.timer.cancel()``."""
    code, ends = source_code(system), _ends_of_timer(system, call)
    if any(always_comes_before(code, end, call) or always_comes_after(code, end, call) for end in ends):
        return True
    return all(any(path_comes_before(code, _guard(code, end), other) for end in ends) for other in paths_to(call))


def gives_up_at_a_miss(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback ends the timer where what it waits for has not come: ``if not
    ….wait_for_service(timeout_sec=1.0): self.timer.cancel()``."""
    ends = [end.place for end in _ends_of_timer(system, call) if end.file == call.file]
    return any(covers(line, place.span) for line in lines_of_miss(source_code(system), call) for place in ends)


def _guard(code: SourceCode, end: ApiCall) -> tuple[Place, ...]:
    """The way to a call that ends a timer, or to the condition around it that only asks whether there is one."""
    *way, last = next(paths_to(end))
    expression = code.expression(end)
    ended = [] if expression is None else [expression.func, *(given.value for given in expression.args)]
    owners = {part.dotted for part in everything_in(ended, facts.Attribute)}
    for branch in statements_of(code.body(end), facts.If):
        asked = _asked_for(branch.test, owners)
        if asked is not None and any(covers(line, end.place.span) for line in branch.body):
            return (*way, Place.of(end.file, asked))
    return (*way, last)


def _asked_for(test: facts.Expr, owners: AbstractSet[str]) -> facts.Span | None:
    """Where a test only asks whether an object is there: ``self.timer``, ``hasattr(self, 'timer')``."""
    match test:
        case facts.Call(
            func=facts.Name(id="hasattr"), args=[owner, facts.Argument(value=facts.Literal(text=name))], span=span
        ):
            return span if f"{owner.value.dotted}.{name}" in owners else None
    if any(True for _ in calls_in(test)):
        return None
    return next((part.span for part in everything_in([test], facts.Attribute) if part.dotted in owners), None)


def _ends_of_timer(system: System, call: ApiCall) -> list[ApiCall]:
    """The calls with which the timer's callback that comes to a call ends the timer."""
    if call.context.role != Role.TIMER or call.context.creation is None:
        return []
    ends = _ends_by_callback(system).get(call.context.place, ())
    return [end for end in ends if end.context is call.context and _ends(end, call)]


def _ends(end: ApiCall, call: ApiCall) -> bool:
    return any(creation is call.context.creation for creation in _ended(end))


def _ended(end: ApiCall) -> Iterator[Creation]:
    """The timers that a call ends, where that is known."""
    return (creation for value in (end.receiver, *end.arguments.values()) for creation in creations_of(value))


def timer_period(system: System, callback: Callback) -> float | None:
    """The seconds between two turns of a timer's callback; None where that is not known, or where some code ends the
    timer."""
    timer = callback.creation
    if callback.role != Role.TIMER or timer is None or not timer.period or timer.period <= 0:
        return None
    ended = callback.place in _ends_by_callback(system) or id(timer) in _ended_timers(system)
    return None if ended else timer.period


@once
def _ended_timers(system: System) -> frozenset[int]:
    """The timers (``id``) that some callback ends, be it another."""
    return frozenset(id(creation) for _, call in calls_of(system, ENDS_TIMER) for creation in _ended(call))


@once
def _ends_by_callback(system: System) -> dict[Place, list[ApiCall]]:
    by_callback: dict[Place, list[ApiCall]] = {}
    for _, call in calls_of(system, ENDS_TIMER):
        by_callback.setdefault(call.context.place, []).append(call)
    return by_callback


__all__ = [
    "ENDS_TIMER",
    "ends_its_timer_after",
    "ends_its_timer_before",
    "gives_up_at_a_miss",
    "runs_once",
    "timer_period",
]
