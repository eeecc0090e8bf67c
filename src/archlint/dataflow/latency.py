"""How long data takes along a way at most: the sum of periods, waits and queues, each with what it stands for.

Times that nobody can read off the source are terms without seconds; what is assumed is :data:`ASSUMED`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.dataflow.durations import longest_time, pauses, shortest_time
from archlint.dataflow.misfits import queue_depth
from archlint.dataflow.model import StepKind
from archlint.dataflow.pace import interval, rate, sending_interval
from archlint.dataflow.runs import SCRIPT
from archlint.dataflow.threads import waits_for
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step

ASSUMED = (
    "computing and the transport of messages, requests and answers take no time",
    "no message is lost, timers keep their periods, and what is sent under a condition is sent",
    "what a callback sends depends on all that it is called with and on all attributes that it reads",
    "a frame hangs from the frames that code here is seen to send it with, and from no other",
    "what callbacks leave in objects other than their node, by calling methods of these, is not followed",
)
"""What the figures and ways rest on."""


@dataclass(frozen=True)
class Term:
    """A time that data may wait: ``seconds`` at most, None where that is not known; ``short`` stands for it in a
    sum."""

    seconds: float | None
    words: str
    short: str
    step: Step


def terms(flow: Flow, way: Sequence[Link]) -> list[Term]:
    """The times along a way, in its order; none of no length are among them."""
    return [term for term in _terms(flow, way) if term.seconds is None or term.seconds > 0]


def is_known_in_part(of: Sequence[Term]) -> bool:
    """Whether there is anything to say of how long it takes."""
    return any(term.seconds is not None for term in of)


def total(of: Sequence[Term]) -> float:
    """The sum of the times that are known, in seconds."""
    return sum(term.seconds for term in of if term.seconds is not None)


def _terms(flow: Flow, way: Sequence[Link]) -> Iterator[Term]:
    if way and way[0].tail.kind == StepKind.CALLBACK:
        yield from _of_first(flow, way[0].tail, way[0])
    for position, link in enumerate(way):
        step = link.head
        match step.kind:
            case StepKind.CALLBACK:
                following = way[position + 1] if position + 1 < len(way) else None
                yield from _of_callback(flow, link, step, following)
            case StepKind.SERVICE:
                yield Term(None, f"the service {step.name} takes its time", f"the service {step.name}", step)
            case StepKind.ACTION:
                yield Term(None, f"the action {step.name} takes its time", f"the action {step.name}", step)
            case StepKind.UNKNOWN | StepKind.STRANGER if position + 1 < len(way):
                node = step.name if step.kind == StepKind.STRANGER else _node_name(step)
                yield Term(None, f"what {node} does is not known", f"what {node} does", step)


def _of_first(flow: Flow, step: Step, link: Link) -> Iterator[Term]:
    """What happens just after a turn of the first callback waits for the next one."""
    seconds = sending_interval(flow, link) or interval(flow, step)
    if seconds is not None:
        yield Term(seconds, f"{_called(step)} has its turn every {seconds:.3g} s", "", step)
    elif step.callback is not None and step.callback.role in (*SCRIPT, Role.TIMER, Role.THREAD):
        yield Term(None, f"how often {_called(step)} sends is not known", f"the next turn of {step.name}", step)
    if step.callback is not None and step.callback.role not in (*SCRIPT, Role.THREAD):
        yield from _own_pauses(flow, step)  # what a loop sleeps is its period


def _of_callback(flow: Flow, link: Link, step: Step, following: Link | None) -> Iterator[Term]:
    if link.tail.kind in (StepKind.KEPT, StepKind.FRAME):
        yield _next_turn(flow, step, following)
    elif link.tail.kind == StepKind.TOPIC:
        yield from _queue(flow, link, step)
    yield from _for_thread(flow, step)
    if following is not None:
        yield from _own_pauses(flow, step)


def _next_turn(flow: Flow, step: Step, following: Link | None) -> Term:
    """What is left in an attribute, or in a buffer of transforms, waits until the callback that reads it runs again."""
    seconds = interval(flow, step)
    if seconds is None and following is not None:
        seconds = sending_interval(flow, following)
    words = f"{_called(step)} reads it "
    words += f"every {seconds:.3g} s" if seconds is not None else "when it runs next, nobody knows when"
    return Term(seconds, words, f"the next run of {step.name}", step)


def _queue(flow: Flow, link: Link, step: Step) -> Iterator[Term]:
    """A queue that fills up holds each message back until those before it are done."""
    seconds = shortest_time(flow.system, step)
    depth = queue_depth(step)
    if seconds and rate(flow, step) * seconds > 1 and depth is not None:
        words = f"{_called(step)} is behind: up to {depth} messages of {link.tail.name} are before it in the queue"
        yield Term(depth * seconds, words, "", step)


def _for_thread(flow: Flow, step: Step) -> Iterator[Term]:
    """The longest other callback that the same thread, or the same group, may be busy with."""
    others = [(longest_time(flow.system, other), other) for other in waits_for(flow, step)]
    endless = [other for seconds, other in others if seconds is None]
    if endless:
        other = endless[0]
        yield Term(None, f"{_called(step)} waits while {other.name} runs: {_why(flow, other)}", other.name, step)
    known = [(seconds, other) for seconds, other in others if seconds]
    if known:
        seconds, other = max(known, key=lambda row: row[0])
        yield Term(seconds, f"{_called(step)} waits while {other.name} runs: {_why(flow, other)}", "", step)


def _own_pauses(flow: Flow, step: Step) -> Iterator[Term]:
    for pause in pauses(flow.system, step):
        where = f"{pause.place.file}:{pause.place.line}"
        yield Term(pause.most, f"{step.name} {pause.words} at {where}", f"{step.name}, which {pause.words}", step)


def _why(flow: Flow, step: Step) -> str:
    longest_first = sorted(pauses(flow.system, step), key=lambda pause: (pause.most is not None, -(pause.most or 0)))
    return f"it {longest_first[0].words}" if longest_first else "it stands still"


def _called(step: Step) -> str:
    return f"{step.name} of {_node_name(step)}"


def _node_name(step: Step) -> str:
    node = step.node
    if node is None:
        return "?"
    return node.name or (node.blueprint.class_name if node.blueprint is not None else "?")


__all__ = ["ASSUMED", "Term", "is_known_in_part", "terms", "total"]
