"""Waits for events, of callbacks that start again while they still wait, until no thread is left for who sets them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument, has_limit
from archlint.execution.blocking import SEVERAL
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.event_waits import waits_for_events
from archlint.execution.paces import Pace, pace_of, runs_beside_itself
from archlint.execution.piling_waits import comes_each_time, outlasts, threads_written_for
from archlint.execution.sleeps import longest
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.systems.model import System

_ROLES = (Role.TIMER, Role.SUBSCRIPTION, Role.SERVICE)


@dataclass(frozen=True)
class PilingEvent:
    """A wait for an event that ``setter`` sets, on one of ``threads`` threads (None: the machine decides)."""

    call: ApiCall
    setter: Callback
    program: Program
    pace: Pace
    threads: int | None
    limited: bool


def piling_events(system: System) -> Iterator[PilingEvent]:
    """The waits for events that another callback of the node sets, and that may take all of its threads."""
    for program, call, setters in waits_for_events(system):
        if all(_needs_a_thread(call.context, setter) for setter in setters):
            yield from _piling(system, program, call, setters[0])


def _needs_a_thread(waiting: Callback, setter: Callback) -> bool:
    """Whether what sets the event is a callback of the node that waits, and not the answer to a request of its own."""
    return setter.role != Role.DONE and runs_in_executor(setter) and setter.node is waiting.node


def _piling(system: System, program: Program, call: ApiCall, setter: Callback) -> Iterator[PilingEvent]:
    callback = call.context
    if callback.role not in _ROLES or not runs_beside_itself(callback) or setter.place == callback.place:
        return
    if threads_of(callback.node, program) != SEVERAL or not comes_each_time(system, call):
        return
    pace, threads = pace_of(system, callback), threads_written_for(callback.node, program)
    limited = has_limit(call, "timeout")
    limit = longest(argument(call, "timeout")) if limited else None
    if pace is not None and outlasts(pace, limited, limit, threads):
        yield PilingEvent(call, setter, program, pace, threads, limited)
