"""How often callbacks start and messages are sent, where timers and sleeping loops decide it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from heapq import heapify, heappop, heappush
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.dataflow.model import How, StepKind
from archlint.dataflow.runs import SCRIPT, SENDS
from archlint.execution import own_timers
from archlint.execution.loop_paces import loop_interval
from archlint.execution.polling import is_unguarded, notes_that_it_ran
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step
    from archlint.model import ApiCall
    from archlint.systems.model import System


def interval(flow: Flow, step: Step) -> float | None:
    """The seconds between two starts of a callback at most; None where that is not known."""
    return _intervals(flow).get(id(step))


@once
def _intervals(flow: Flow) -> Mapping[int, float]:
    """The interval of each callback (``id``) that a timer or a sleeping loop starts, over however many topics: the
    shortest first, so that each is looked at once."""
    known: dict[int, float] = {}
    numbers = {id(step): number for number, step in enumerate(flow.steps)}
    left: list[tuple[float, int, Step]] = []
    for step in flow.steps:
        period = timer_period(flow.system, step) if _role(step) == Role.TIMER else None
        if period is not None:
            left.append((period, numbers[id(step)], step))
        elif _role(step) in (*SCRIPT, Role.THREAD):
            links = [(_regular_interval(link), link.head) for link in flow.out_of(step)]
            left += [(seconds, numbers[id(head)], head) for seconds, head in links if seconds is not None]
    heapify(left)
    while left:
        seconds, _, step = heappop(left)
        if id(step) in known:
            continue
        known[id(step)] = seconds
        for link in flow.out_of(step):
            if id(link.head) not in known and _goes_on(flow, link):
                heappush(left, (seconds, numbers[id(link.head)], link.head))
    return {id(step): known[id(step)] for step in flow.steps if step.callback is not None and id(step) in known}


def _role(step: Step) -> Role | None:
    return None if step.callback is None else step.callback.role


def _goes_on(flow: Flow, link: Link) -> bool:
    """Whether what a link leads to runs, or is sent, whenever what it comes from is."""
    if link.tail.kind == StepKind.TOPIC:
        return not link.doubt and not link.broken and _role(link.head) == Role.SUBSCRIPTION
    return link.head.kind == StepKind.TOPIC and _is_sent_each_time(flow, link)


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


def sending_interval(flow: Flow, link: Link) -> float | None:
    """The seconds between two messages that a link carries at most; None where that is not known."""
    if _role(link.tail) in (*SCRIPT, Role.THREAD):
        return _regular_interval(link)
    return interval(flow, link.tail) if _is_sent_each_time(flow, link) else None


def _call_of(link: Link) -> ApiCall | None:
    """The call that sends what a link carries, unless something keeps it back."""
    if link.how != How.SEND or link.doubt or link.broken or link.conditional:
        return None
    calls = (call for call in link.tail.calls if call.place == link.place and call.api in SENDS)
    return next(calls, None)


def _regular_interval(link: Link) -> float | None:
    """What the loop around the call of a script or a thread sleeps."""
    call = _call_of(link)
    return None if call is None else loop_interval(link.tail.calls, call)


def _is_sent_each_time(flow: Flow, link: Link) -> bool:
    """Whether each run of a callback sends what a link carries."""
    call, code = _call_of(link), source_code(flow.system)
    if call is None or call.looped:
        return False
    return is_unguarded(code, call) and not notes_that_it_ran(code, call)


def timer_period(system: System, step: Step) -> float | None:
    """The period of a timer, in seconds; None where it is not known, or where some code stops the timer."""
    return None if step.callback is None else own_timers.timer_period(system, step.callback)


def _topics(flow: Flow, step: Step) -> Iterator[Step]:
    """The topics whose messages start a callback for certain."""
    for link in flow.into(step):
        if link.tail.kind == StepKind.TOPIC and not link.doubt and not link.broken:
            yield link.tail


__all__ = ["interval", "rate", "sending_interval", "timer_period", "topic_rate"]
