"""How often a loop repeats that sleeps in each round."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.execution.piling_rates import RATE_SLEEP
from archlint.execution.sleeps import SLEEP, longest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall

_SLEEPS = frozenset({SLEEP, RATE_SLEEP})


def is_decided(call: ApiCall) -> bool:
    """Whether a branch decides that a call is made: more than whether a loop around it goes on."""
    return call.conditional and len(call.branch_arms) > len(call.enclosing_loops)


def paced_loop(calls: Iterable[ApiCall], call: ApiCall) -> tuple[Place, float] | None:
    """The innermost loop around a call that sleeps each time, and how many seconds; None where none does, or nobody
    knows how long.  ``calls`` are those of what runs."""
    among = [other for other in calls if other.api in _SLEEPS]
    for loop in reversed(call.enclosing_loops):
        sleeps = [other for other in among if loop in other.enclosing_loops[-1:]]
        times = [_seconds(other) for other in sleeps if not is_decided(other)]
        if times:
            known = [seconds for seconds in times if seconds is not None]
            total = sum(known) if len(known) == len(times) else 0.0
            return (loop, total) if total else None
    return None


def loop_interval(calls: Iterable[ApiCall], call: ApiCall) -> float | None:
    """The seconds that the innermost loop around a call sleeps each time."""
    paced = paced_loop(calls, call)
    return None if paced is None else paced[1]


def _seconds(call: ApiCall) -> float | None:
    if call.api == RATE_SLEEP:
        return None if call.creation is None else call.creation.period
    return longest(argument(call, "seconds"))


__all__ = ["is_decided", "loop_interval", "paced_loop"]
