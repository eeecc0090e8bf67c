"""Timers that end in their own callback: it runs once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.order import always_comes_before
from archlint.analysis.reach import calls_of, creations_of
from archlint.analysis.source_code import source_code
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall
    from archlint.systems.model import System

ENDS_TIMER = ("rclpy.timer.Timer.cancel", "rclpy.node.Node.destroy_timer")
"""The calls that end a timer."""


def ends_its_timer_before(system: System, call: ApiCall) -> bool:
    """Whether a timer's callback has ended the timer by the time it comes to a call: there is no next turn."""
    if call.context.role != Role.TIMER or call.context.creation is None:
        return False
    code = source_code(system)
    return any(
        end.context is call.context and _ends(end, call) and always_comes_before(code, end, call)
        for end in _ends_by_callback(system).get(call.context.place, ())
    )


def _ends(end: ApiCall, call: ApiCall) -> bool:
    given = [end.receiver, *end.arguments.values()]
    return any(creation is call.context.creation for value in given for creation in creations_of(value))


@once
def _ends_by_callback(system: System) -> dict[Place, list[ApiCall]]:
    by_callback: dict[Place, list[ApiCall]] = {}
    for _, call in calls_of(system, ENDS_TIMER):
        by_callback.setdefault(call.context.place, []).append(call)
    return by_callback


__all__ = ["ENDS_TIMER", "ends_its_timer_before"]
