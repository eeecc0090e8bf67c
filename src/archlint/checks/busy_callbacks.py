"""EXE012: callbacks that calculate for longer than they have time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import node_name, one_for_each_place
from archlint.analysis.source_code import source_code
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.blocking import SEVERAL
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.kept_waiting import blocks_nobody
from archlint.execution.known_work import Work, work_of
from archlint.execution.paces import pace_of
from archlint.execution.timed_loops import TimedLoop, timed_loops
from archlint.finding import Finding, Place, Related
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import Callback, Program
    from archlint.systems.model import System

_ROLES = frozenset({Role.TIMER, Role.SUBSCRIPTION, Role.FILTER})
_IMAGES = frozenset({"sensor_msgs/msg/Image", "sensor_msgs/msg/CompressedImage"})
_LONG = 0.5
"""Seconds that are too long whatever the callback is for."""


@rule("EXE012", scope=Scope.CODE, taste=True)
def busy_callback(system: System, options: Options) -> Iterator[Finding]:
    """Loops in callbacks whose number of iterations is known and too large."""
    yield from one_for_each_place(
        _busy(system, callback, work, period)
        for program in system.programs
        if not system.roles.is_test(program.file)
        for callback in program.callbacks
        if callback.role in _ROLES and not system.roles.is_test(callback.file)
        for work, period in _too_long(system, program, callback)
    )
    yield from one_for_each_place(
        _timed(system, callback, loop)
        for program in system.programs
        if not system.roles.is_test(program.file)
        for callback in program.callbacks
        if callback.role in _ROLES and not system.roles.is_test(callback.file)
        for loop in _loops_for_a_time(system, program, callback)
    )


def _too_long(system: System, program: Program, callback: Callback) -> Iterator[tuple[Work, float | None]]:
    """The loops that do not fit into the time of a callback, with its period where that is known."""
    code = source_code(system)
    function, file = code.definition(callback), code.facts_at(callback.file)
    if function is None or file is None:
        return
    pace = pace_of(system, callback)
    period = None if pace is None else pace.period
    alone = threads_of(callback.node, program) == SEVERAL
    for work in work_of(function, file):
        if work.pixels:
            if callback.creation is not None and callback.creation.type in _IMAGES:
                yield work, period
        elif (period is not None and work.seconds > period) or (work.seconds > _LONG and not alone):
            yield work, period


def _loops_for_a_time(system: System, program: Program, callback: Callback) -> Iterator[TimedLoop]:
    """The loops that keep others of its node waiting until a time has passed."""
    code = source_code(system)
    function, file = code.definition(callback), code.facts_at(callback.file)
    if function is None or file is None or blocks_nobody(callback, program) or callback.node is None:
        return
    several = threads_of(callback.node, program) == SEVERAL
    others = [other for other in callback.node.callbacks if not several or other.group == callback.group]
    if any(other.place != callback.place and runs_in_executor(other) for other in others):
        yield from (loop for loop in timed_loops(function, file) if loop.seconds > _LONG)


def _timed(system: System, callback: Callback, loop: TimedLoop) -> Finding:
    inside = "" if callback.name.rpartition(".")[2] == loop.function else f" in {loop.function}()"
    return finding(
        "EXE012",
        Place.of(callback.file, loop.span),
        f"{callback_words(callback)} loops{inside} until {loop.seconds:g} s have passed: everything else on its "
        "thread has to wait",
        help="remember when it began, return, and let a timer go on until the time has passed",
        related=[Related(callback.place, f"{callback.name} is the callback")],
        node=node_name(system, callback.node),
        identity=(callback.name, loop.function),
    )


def _busy(system: System, callback: Callback, work: Work, period: float | None) -> Finding:
    who = callback_words(callback)
    inside = "" if callback.name.rpartition(".")[2] == work.function else f" in {work.function}()"
    if work.pixels:
        message = (
            f"{who} goes over every pixel of an image{inside}: {work.iterations:,} iterations for 640 × 480, which "
            "take Python a tenth of a second or more"
        )
        help = "use the functions of numpy or OpenCV, which work on the whole image"
    else:
        late = "" if period is None else f", and it has {period:g} s until the next time"
        message = f"{who} calculates for at least {work.seconds:.2g} s{inside}, in {work.iterations:,} iterations{late}"
        help = "do less each time, use numpy, or calculate in another process"
    return finding(
        "EXE012",
        Place.of(callback.file, work.span),
        message,
        help=help,
        related=[Related(callback.place, f"{callback.name} is the callback")],
        node=node_name(system, callback.node),
        identity=(callback.name, work.function),
    )


__all__ = ["busy_callback"]
