"""Timers that some code ends: in their own callback, so that it runs once, or elsewhere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_after, always_comes_before
from archlint.analysis.reach import calls_of, creations_of
from archlint.analysis.source_code import source_code
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, Callback, Creation
    from archlint.systems.model import System

ENDS_TIMER = ("rclpy.timer.Timer.cancel", "rclpy.node.Node.destroy_timer")
"""The calls that end a timer."""


def ends_its_timer_before(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback has ended the timer by the time it comes to a call: there is no next turn."""
    code = source_code(system)
    return any(always_comes_before(code, end, call) for end in _ends_of_timer(system, call))


def ends_its_timer_after(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback that has come to a call ends the timer: it comes there once."""
    code = source_code(system)
    return any(always_comes_after(code, end, call) for end in _ends_of_timer(system, call))


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


__all__ = ["ENDS_TIMER", "ends_its_timer_after", "ends_its_timer_before", "timer_period"]
