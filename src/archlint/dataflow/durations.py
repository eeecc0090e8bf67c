"""How long callbacks stand still, as far as the source says: sleeps, waits for servers, answers and transforms.

What they compute takes time, too; nobody can read that off the source, so it is left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once
from archlint.analysis.reach import argument, endpoint_words
from archlint.analysis.source_code import source_code
from archlint.execution.certain_sleeps import certain_sleep
from archlint.execution.loop_times import in_loops
from archlint.execution.piling_rates import RATE_SLEEP
from archlint.execution.sleeps import longest, stay_of
from archlint.execution.waits import Wait, waits
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Step
    from archlint.model import ApiCall
    from archlint.place import Place
    from archlint.systems.model import System

_LOOK_UPS = frozenset(
    {
        *("tf2_ros.buffer.Buffer.lookup_transform", "tf2_ros.buffer.Buffer.can_transform"),
        *("tf2_ros.buffer_h.Buffer.lookupTransform", "tf2_ros.buffer_h.Buffer.canTransform"),
    }
)


@dataclass(frozen=True)
class Pause:
    """A call at which a callback stands still: for at most ``most`` seconds (None: not known), and for certain for at
    least ``least`` seconds each time."""

    place: Place
    words: str
    most: float | None
    least: float = 0.0


def pauses(system: System, step: Step) -> Sequence[Pause]:
    """Where a callback stands still, in the order of the source."""
    return kept(system, (pauses, id(step)), lambda: tuple(_pauses(system, step)))


def longest_time(system: System, step: Step) -> float | None:
    """The seconds that a callback stands still at most; None where that is not known."""
    times = [pause.most for pause in pauses(system, step)]
    known = [time for time in times if time is not None]
    return sum(known) if len(known) == len(times) else None


def shortest_time(system: System, step: Step) -> float:
    """The seconds that a callback stands still for certain, each time."""
    return sum(pause.least for pause in pauses(system, step))


def _pauses(system: System, step: Step) -> Iterator[Pause]:
    by_place: dict[Place, Pause] = {}
    for call in step.calls:
        pause = _pause(system, call)
        if pause is not None:
            by_place.setdefault(call.place, pause)
    yield from (by_place[place] for place in sorted(by_place))


def _pause(system: System, call: ApiCall) -> Pause | None:
    code = source_code(system)
    wait = _waits_by_call(system).get(id(call))
    if wait is not None:
        given = (longest(argument(call, name)) for name in ("timeout_sec", "timeout"))
        limit = max((seconds for seconds in given if seconds is not None), default=None)
        words = f"waits for the answer of {endpoint_words(wait.client)}"
        return Pause(call.place, words, limit if wait.limited else None)
    if call.api == RATE_SLEEP:
        period = None if call.creation is None else call.creation.period
        return Pause(call.place, "sleeps in a rate", period)
    if call.api in _LOOK_UPS:
        timeout = argument(call, "timeout")
        if timeout is None:
            return None  # it looks at what is there
        return Pause(call.place, "waits for a transform", longest(timeout))
    stay = stay_of(code, call)
    if stay is None:
        return None
    seconds = in_loops(code, call, stay, with_callers=True)
    most = None if math.isinf(seconds) else seconds
    return Pause(call.place, stay.words, most, certain_sleep(system, call))


@once
def _waits_by_call(system: System) -> dict[int, Wait]:
    return {id(wait.call): wait for wait in waits(system)}


__all__ = ["Pause", "longest_time", "pauses", "shortest_time"]
