"""How a topic is used: what makes its publishers publish, and whether something comes back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.advice.model import Evidence, Judged, Use, unknown
from archlint.advice.words import node_name, occasion_words, rate_of, why_unknown
from archlint.dataflow.durations import shortest_time
from archlint.dataflow.model import How, StepKind
from archlint.dataflow.pace import sending_interval
from archlint.dataflow.runs import SCRIPT
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step

LONG = 2.0
"""Seconds that a callback works on a message for certain that make it a task."""
_WITH_DATA = frozenset({Role.SUBSCRIPTION, Role.FILTER, Role.FEEDBACK})
_ON_AN_OCCASION = frozenset(
    {Role.SERVICE, Role.DONE, Role.PARAMETER, Role.INIT, Role.LIFECYCLE, Role.METHOD, Role.EVENT}
)
_STREAM = "data is sent again and again, and nobody has to answer"
_COMMAND = (
    "it is sent on an occasion, and nothing comes back; a service fits where the sender has to know that it is done"
)
_TASK = "what is asked for takes long, and the sender never hears how it ended"


def judge_topic(flow: Flow, step: Step) -> Judged:
    """How a topic is used, and whether something else fits better."""
    links = [link for link in flow.into(step) if link.how == How.SEND and not link.broken]
    sent = [use for link in links for use in [_sent(flow, link)] if use is not None]
    evidence = tuple(dict.fromkeys(use.evidence for use in sent))
    if not sent:
        return unknown(why_unknown(links, "publishes", "no node here publishes it"))
    streams = [use for use in sent if use.use == Use.STREAM]
    if streams:
        rates = [use.rate for use in streams if use.rate is not None]
        return Judged(Use.STREAM, "topic", _STREAM, rate=sum(rates) or None, evidence=evidence)
    if all(use.use == Use.UNKNOWN for use in sent):
        return unknown("what makes its publishers publish is not known", evidence)
    answer = _answered_on(flow, step)
    if answer is not None:
        words = f"each message is answered by one on {answer.name}, which is what a service is for"
        return Judged(Use.QUERY, "service", words, "make a service of the two topics", evidence=evidence)
    task = _task(flow, step)
    if task is not None:
        instead = "make it an action: the sender then gets feedback and a result, and can cancel"
        return Judged(Use.TASK, "action", _TASK, instead, evidence=(task, *evidence))
    return Judged(Use.COMMAND, "topic", _COMMAND, evidence=evidence)


@dataclass(frozen=True)
class _Sent:
    """How one callback uses a topic."""

    use: Use
    rate: float | None
    evidence: Evidence


def _sent(flow: Flow, link: Link) -> _Sent | None:
    step, place = link.tail, link.place
    if step.kind != StepKind.CALLBACK or step.callback is None or place is None:
        return None
    who, seconds = node_name(step.node), sending_interval(flow, link)
    if seconds is not None:
        return _Sent(Use.STREAM, rate_of(seconds), Evidence(place, f"{who} publishes every {seconds:.3g} s"))
    call = next((call for call in step.calls if call.place == place), None)
    role, when = step.callback.role, occasion_words(step.callback)
    if role == Role.TIMER and not link.conditional:
        return _Sent(Use.STREAM, None, Evidence(place, f"{who} publishes {when}"))
    if role in _WITH_DATA and not link.conditional:
        return _Sent(Use.STREAM, None, Evidence(place, f"{who} publishes {when}"))
    if role in (*SCRIPT, Role.THREAD) and call is not None and call.looped:
        asks = any(other.api == "builtins.input" for other in step.calls)
        words = f"{who} publishes in a loop{' that asks for keyboard input' if asks else ''}"
        return _Sent(Use.COMMAND if asks else Use.UNKNOWN, None, Evidence(place, words))
    if role in _ON_AN_OCCASION or link.conditional or role in SCRIPT:
        condition = ", under a condition" if link.conditional and "condition" not in when else ""
        return _Sent(Use.COMMAND, None, Evidence(place, f"{who} publishes {when}{condition}"))
    return _Sent(Use.UNKNOWN, None, Evidence(place, f"{who} publishes {when}"))


def _takers(flow: Flow, step: Step) -> list[Step]:
    return [link.head for link in flow.out_of(step) if link.how == How.ARRIVE and not link.broken]


def _answered_on(flow: Flow, step: Step) -> Step | None:
    """The topic on which the only subscriber of a topic answers each message of the only publisher, and that nobody
    else has to do with."""
    senders = {id(link.tail.node): link.tail.node for link in flow.into(step)}
    takers = _takers(flow, step)
    if len(senders) != 1 or len(takers) != 1 or takers[0].callback is None or id(takers[0].node) in senders:
        return None
    for link in flow.out_of(takers[0]):
        if link.how != How.SEND or link.head.kind != StepKind.TOPIC or link.conditional or link.doubt or link.broken:
            continue
        publishers = {id(other.tail.node) for other in flow.into(link.head)}
        subscribers = {id(taker.node) for taker in _takers(flow, link.head)}
        if publishers == {id(takers[0].node)} and subscribers == set(senders):
            return link.head
    return None


def _task(flow: Flow, step: Step) -> Evidence | None:
    """Where the callback of the only subscriber works long on each message, for certain."""
    takers = _takers(flow, step)
    if len(takers) != 1 or takers[0].place is None:
        return None
    seconds = shortest_time(flow.system, takers[0])
    if seconds < LONG:
        return None
    return Evidence(takers[0].place, f"{node_name(takers[0].node)} takes {seconds:.3g} s for each message")


__all__ = ["judge_topic"]
