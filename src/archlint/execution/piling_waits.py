"""Waits of callbacks that start again while they still wait, a thread each time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import argument
from archlint.analysis.source_code import source_code
from archlint.execution.paces import Pace, pace_of, runs_beside_itself
from archlint.execution.polling import is_unguarded, notes_that_it_ran
from archlint.execution.sleeps import longest
from archlint.execution.threaded_waits import complete_wait, threaded_waits
from archlint.execution.waits import DONE, Wait
from archlint.model import ExecutorKind, Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System

_OFTEN_S = 1.0
"""The longest period of a timer whose ticks are said to come often."""


@once
def piling_up(system: System) -> list[Wait]:
    """The waits of callbacks that run beside themselves and that a late answer multiplies, until no thread is left.

    Those of service handlers that have no limit are left to what SRV003 says of them.
    """
    return [wait for wait in threaded_waits(system) if _outruns(system, wait)]


def _outruns(system: System, wait: Wait) -> bool:
    """Whether the callback starts often enough, for certain, while the first still waits."""
    callback = wait.call.context
    if not runs_beside_itself(callback) or (callback.role == Role.SERVICE and not wait.limited):
        return False
    pace = pace_of(system, callback)
    return (
        pace is not None
        and comes_each_time(system, wait.call)
        and outlasts(pace, wait.limited, _limit(wait), known_threads(wait))
    )


def comes_each_time(system: System, call: ApiCall) -> bool:
    """Whether a callback comes to a wait each time it runs, for all that is seen."""
    code = source_code(system)
    return not call.conditional and is_unguarded(code, complete_wait(call)) and not notes_that_it_ran(code, call)


def outlasts(pace: Pace, limited: bool, limit: float | None, threads: int | None) -> bool:
    """Whether a wait of ``limit`` seconds (None: not known) is long enough for the callback to take all threads."""
    if pace.period > _OFTEN_S:
        return False
    if not limited:
        return True
    # The first tick has a thread at once, the last thread is taken so many periods later.
    return limit is not None and threads is not None and limit > pace.period * (threads - 1)


def _limit(wait: Wait) -> float | None:
    if wait.call.api == DONE:
        return wait.call.limits[-1] if wait.call.limits else None
    given = (argument(wait.call, name) for name in ("timeout_sec", "timeout"))
    return next((longest(value) for value in given if value is not None), None)


def known_threads(wait: Wait) -> int | None:
    """How many threads there are, at least by what is written; None where the machine decides."""
    return threads_written_for(wait.call.context.node, wait.program)


def threads_written_for(node: Blueprint | None, program: Program) -> int | None:
    """``num_threads`` of the executors of a node; None where the machine decides."""
    uses = [] if node is None else program.executors_of(node)
    numbers = [use.threads for use in uses if use.kind == ExecutorKind.MULTI_THREADED]
    known = [number for number in numbers if number is not None]
    return max(known) if known and len(known) == len(numbers) else None
