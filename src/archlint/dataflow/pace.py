"""How often callbacks start and messages are sent, where timers and sleeping loops decide it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.own_timers import ENDS_TIMER
from archlint.analysis.piling_rates import RATE_SLEEP
from archlint.analysis.polling import is_unguarded, notes_that_it_ran
from archlint.analysis.reach import argument, calls_of
from archlint.analysis.sleeps import SLEEP, longest
from archlint.analysis.source_code import source_code
from archlint.dataflow.model import How, StepKind
from archlint.dataflow.runs import SCRIPT, SENDS, is_decided
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step
    from archlint.model import ApiCall
    from archlint.place import Place
    from archlint.systems.model import System

_DEPTH = 16
"""How many topics a rate is followed through."""


def interval(flow: Flow, step: Step, depth: int = _DEPTH) -> float | None:
    """The seconds between two starts of a callback at most; None where that is not known."""
    if step.callback is None:
        return None
    if step.callback.role == Role.TIMER:
        return timer_period(flow.system, step)
    if step.callback.role != Role.SUBSCRIPTION:
        return None
    sent = [sending_interval(flow, link, depth - 1) for topic in _topics(flow, step) for link in flow.into(topic)]
    return min((seconds for seconds in sent if seconds is not None), default=None)


def rate(flow: Flow, step: Step) -> float:
    """How many times a second a callback is due at least, as far as that is known."""
    if step.callback is None or step.callback.role not in (Role.TIMER, Role.SUBSCRIPTION):
        return 0.0
    if step.callback.role == Role.TIMER:
        period = timer_period(flow.system, step)
        return 1 / period if period else 0.0
    links = [link for topic in _topics(flow, step) for link in flow.into(topic)]
    times = (sending_interval(flow, link) for link in links)
    return sum(1 / seconds for seconds in times if seconds)


def topic_rate(flow: Flow, topic: Step) -> float:
    """Messages a second on a topic at least, as far as that is known."""
    times = (sending_interval(flow, link) for link in flow.into(topic))
    return sum(1 / seconds for seconds in times if seconds)


def sending_interval(flow: Flow, link: Link, depth: int = _DEPTH) -> float | None:
    """The seconds between two messages that a link carries at most; None where that is not known."""
    step = link.tail
    if depth <= 0 or link.how != How.SEND or link.doubt or link.conditional or step.callback is None:
        return None
    code = source_code(flow.system)
    calls = [call for call in step.calls if call.place == link.place and call.api in SENDS]
    if not calls:
        return None
    call = calls[0]
    if step.callback.role in (*SCRIPT, Role.THREAD):
        return loop_interval(step, call)
    if call.looped or not is_unguarded(code, call) or notes_that_it_ran(code, call):
        return None
    return interval(flow, step, depth)


def loop_interval(step: Step, call: ApiCall) -> float | None:
    """The seconds that the innermost loop around a call sleeps each time; None where it does not, or nobody knows how
    long."""
    for loop in reversed(call.enclosing_loops):
        sleeps = [other for other in step.calls if loop in other.enclosing_loops[-1:] and other.api in _SLEEPS]
        times = [_sleep_seconds(other) for other in sleeps if not is_decided(other)]
        if times:
            known = [seconds for seconds in times if seconds is not None]
            return sum(known) or None if len(known) == len(times) else None
    return None


_SLEEPS = frozenset({SLEEP, RATE_SLEEP})


def _sleep_seconds(call: ApiCall) -> float | None:
    if call.api == RATE_SLEEP:
        return None if call.creation is None else call.creation.period
    return longest(argument(call, "seconds"))


def timer_period(system: System, step: Step) -> float | None:
    """The period of a timer, in seconds; None where it is not known, or where some code stops the timer."""
    callback = step.callback
    period = None if callback is None or callback.creation is None else callback.creation.period
    if callback is None or not period or period <= 0 or callback.place in _stopping(system):
        return None
    return period


@once
def _stopping(system: System) -> frozenset[Place]:
    """The callbacks that cancel or destroy a timer, by their places."""
    return frozenset(call.context.place for _, call in calls_of(system, ENDS_TIMER))


def _topics(flow: Flow, step: Step) -> Iterator[Step]:
    """The topics whose messages start a callback for certain."""
    for link in flow.into(step):
        if link.tail.kind == StepKind.TOPIC and not link.doubt and not link.broken:
            yield link.tail


__all__ = ["interval", "loop_interval", "rate", "sending_interval", "timer_period", "topic_rate"]
