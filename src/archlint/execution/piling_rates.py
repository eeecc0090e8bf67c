"""Callbacks that start again while they still sleep in a ``Rate``, until no thread is left for the rate's own timer."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

from archlint.analysis.reach import calls_of
from archlint.execution.blocking import SEVERAL
from archlint.execution.deadlock import threads_of
from archlint.execution.paces import Pace, pace_of, runs_beside_itself
from archlint.execution.piling_waits import comes_each_time, threads_written_for
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

RATE_SLEEP: Final = "rclpy.timer.Rate.sleep"


@dataclass(frozen=True)
class PilingSleep:
    """A ``Rate.sleep()`` of up to ``longest`` seconds in a callback that takes one of ``threads`` threads each time."""

    call: ApiCall
    program: Program
    pace: Pace
    longest: float
    threads: int


def piling_sleeps(system: System) -> Iterator[PilingSleep]:
    """The sleeps that last longer than the callback needs to take all threads of its executor."""
    for program, call in calls_of(system, (RATE_SLEEP,)):
        callback = call.context
        rate = call.creation
        if rate is None or rate.period is None or rate.node is not callback.node or not runs_beside_itself(callback):
            continue
        pace, threads = pace_of(system, callback), threads_written_for(callback.node, program)
        if pace is None or threads is None or threads_of(callback.node, program) != SEVERAL:
            continue
        # One callback starts at each tick, and all of them sleep until the rate's next one.
        if rate.period > pace.period * (threads - 1) and comes_each_time(system, call):
            yield PilingSleep(call, program, pace, rate.period, threads)


__all__ = ["RATE_SLEEP", "PilingSleep", "piling_sleeps"]
