"""Waits of a timer's callback one after the other, none of them long, and all together longer than its period."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.order import always_comes_after, paths_to
from archlint.analysis.reach import argument, judged_calls
from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.blocking import ONE
from archlint.execution.deadlock import threads_of
from archlint.execution.kept_waiting import blocks_nobody
from archlint.execution.own_timers import ends_its_timer_after, ends_its_timer_before
from archlint.execution.present_servers import is_there
from archlint.execution.sleeps import Stay, longest, stay_of
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.systems.model import System

_LOOKUPS = ("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform")
_COUNTED = ("sleep", "discovery", "message", "process")
_SLIGHTLY = 1.001
"""What is as long as the period but for the rounding of a sum is in time."""


@dataclass(frozen=True)
class AddedLimits:
    """What a callback waits for at most, in the order of the source, and how long all of it takes."""

    program: Program
    waits: Sequence[tuple[ApiCall, Stay]]
    seconds: float
    period: float


def added_limits(system: System) -> Iterator[AddedLimits]:
    """The callbacks of timers that may wait for longer than their period, though no single wait does."""
    callbacks: dict[int, tuple[Program, Callback, list[ApiCall]]] = {}
    for program, call in judged_calls(system):
        if call.context.role == Role.TIMER:
            callbacks.setdefault(id(call.context), (program, call.context, []))[2].append(call)
    for program, callback, calls in callbacks.values():
        period = None if callback.creation is None else callback.creation.period
        if period is None or period <= 0.0 or callback.is_async or blocks_nobody(callback, program):
            continue
        waits = list(_in_sequence(system, program, calls))
        seconds = sum(stay.seconds or 0.0 for _, stay in waits)
        longest_of_them = max((stay.seconds or 0.0 for _, stay in waits), default=0.0)
        if len(waits) > 1 and longest_of_them <= period and seconds > period * _SLIGHTLY:
            yield AddedLimits(program, waits, seconds, period)


def _in_sequence(system: System, program: Program, calls: Sequence[ApiCall]) -> Iterator[tuple[ApiCall, Stay]]:
    """The waits with a known limit that a callback gets to for certain, once it is in the first of them: one that
    returns where nobody is there does not get to the next."""
    code = source_code(system)
    first: ApiCall | None = None
    for call in sorted(calls, key=lambda call: next(paths_to(call))):  # in the order of the callback's own lines
        stay = _stay(code, program, call)
        if stay is None or call.looped or call.cleaning or is_there(system, call):
            continue
        if ends_its_timer_before(system, call) or ends_its_timer_after(system, call):
            continue
        if first is None or always_comes_after(code, call, first):
            first = first or call
            yield call, stay


def _stay(code: SourceCode, program: Program, call: ApiCall) -> Stay | None:
    """How long a call waits at most, where that is known; of a transform that cannot come EXE007 speaks."""
    if call.api in _LOOKUPS:
        seconds = longest(argument(call, "timeout"))
        alone = threads_of(call.context.node, program) == ONE
        return None if not seconds or alone else Stay("discovery", seconds, "waits for a transform")
    stay = stay_of(code, call)
    return stay if stay is not None and stay.kind in _COUNTED and stay.seconds else None


__all__ = ["AddedLimits", "added_limits"]
