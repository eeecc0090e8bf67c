"""What steps and links of a trace are called."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.dataflow.builder import IDLE
from archlint.dataflow.model import How, Link, StepKind
from archlint.dataflow.pace import interval, topic_rate
from archlint.model import Role
from archlint.render import look

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step
    from archlint.dataflow.paths import Direction
    from archlint.place import Place
    from archlint.systems.nodes import Node

_ROLES = {
    Role.SUBSCRIPTION: "subscription",
    Role.TIMER: "timer",
    Role.SERVICE: "service handler",
    Role.EXECUTE: "goal execution",
    Role.GOAL: "goal callback",
    Role.CANCEL: "cancel callback",
    Role.ACCEPTED: "callback for accepted goals",
    Role.FEEDBACK: "feedback callback",
    Role.DONE: "done callback",
    Role.PARAMETER: "parameter callback",
    Role.EVENT: "event callback",
    Role.GUARD: "guard condition",
    Role.TASK: "task",
    Role.FILTER: "message filter",
    Role.LIFECYCLE: "lifecycle transition",
    Role.THREAD: "thread",
    Role.INIT: "at the start",
    Role.MAIN: "main",
    Role.MODULE: "script",
    Role.METHOD: "method",
}
_BACK: dict[tuple[How, StepKind], str] = {
    (How.SEND, StepKind.TOPIC): "published by",
    (How.SEND, StepKind.SERVICE): "called by",
    (How.SEND, StepKind.ANSWER): "answered by",
    (How.SEND, StepKind.ACTION): "sent by",
    (How.SEND, StepKind.RESULT): "given by",
    (How.SEND, StepKind.FRAME): "sent by",
    (How.SET, StepKind.KEPT): "set by",
    (How.SET, StepKind.UNKNOWN): "perhaps from",
    (How.MAY, StepKind.STRANGER): "perhaps from",
}
"""By the kind of what the link leads to: what is said of where it comes from."""
_ARRIVES = {
    StepKind.TOPIC: "on topic",
    StepKind.SERVICE: "on a request of",
    StepKind.ANSWER: "on an answer of",
    StepKind.ACTION: "on a goal of",
    StepKind.RESULT: "on feedback or a result of",
    StepKind.KEPT: "reads",
    StepKind.FRAME: "looks up the frame",
}
_ON: dict[tuple[How, StepKind], str] = {
    (How.SEND, StepKind.TOPIC): "publishes",
    (How.SEND, StepKind.SERVICE): "calls",
    (How.SEND, StepKind.ANSWER): "answers",
    (How.SEND, StepKind.ACTION): "sends a goal to",
    (How.SEND, StepKind.RESULT): "gives feedback and result of",
    (How.SEND, StepKind.FRAME): "sends the frame",
    (How.SET, StepKind.KEPT): "sets",
    (How.SET, StepKind.UNKNOWN): "perhaps goes on to",
    (How.READ, StepKind.CALLBACK): "read by",
    (How.MAY, StepKind.STRANGER): "perhaps to",
}
"""By the kind of what the link leads to: what is said of that."""
_TAKEN = {
    StepKind.TOPIC: "received by",
    StepKind.SERVICE: "served by",
    StepKind.ANSWER: "answer taken by",
    StepKind.ACTION: "executed by",
    StepKind.RESULT: "feedback or result taken by",
}


def relation(link: Link, direction: Direction) -> str:
    """What is said before a step that a link leads to, going back or on."""
    if direction == "back":
        if link.how in (How.ARRIVE, How.READ):
            return _ARRIVES.get(link.tail.kind, "from")
        return _BACK.get((link.how, link.head.kind), "perhaps from")
    if link.tail.kind == StepKind.FRAME:
        return "looked up by"
    if link.how == How.ARRIVE:
        return _TAKEN.get(link.tail.kind, "taken by")
    return _ON.get((link.how, link.head.kind), "perhaps to")


def node_words(node: Node | None) -> str:
    """A node's name, or its class."""
    return "" if node is None else look.node_label(node).partition("\n")[0]


def step_name(step: Step) -> str:
    """What a step is called; code that is not known has no name."""
    if step.kind == StepKind.UNKNOWN:
        return "" if step.name == IDLE else "code that is not known"
    if step.kind == StepKind.FRAME and step.reason:
        return "that is not known"
    names = step.name.split(", ")
    return step.name if len(names) <= _NAMES else f"{', '.join(names[:_NAMES])} and {len(names) - _NAMES} more"


_NAMES = 3
"""Attributes that are named where several are one step."""


_TITLES = {
    StepKind.SERVICE: "requests of ",
    StepKind.ANSWER: "answers of ",
    StepKind.ACTION: "goals of ",
    StepKind.RESULT: "feedback and results of ",
    StepKind.FRAME: "frame ",
}


def title(step: Step) -> str:
    """What a step is called where nothing before it says what of a service or action it is."""
    return f"{_TITLES.get(step.kind, '')}{step_name(step)}"


def notes(flow: Flow, step: Step) -> Iterator[str]:
    """What else is to be said of a step, in a few words each."""
    callback = step.callback
    if callback is not None:
        yield _ROLES.get(callback.role, str(callback.role))
        seconds = interval(flow, step)
        if seconds is not None:
            yield f"every {seconds:.3g} s"
        elif callback.role == Role.TIMER:
            period = None if callback.creation is None else callback.creation.period
            yield f"every {period:.3g} s unless it is stopped" if period else "period not known"
    if step.kind in (StepKind.TOPIC, StepKind.FRAME):
        hertz = topic_rate(flow, step)
        if hertz:
            yield f"{hertz:.3g} Hz"
    if step.connection is not None:
        yield from step.connection.types or ["type not known"]
    if step.reason:
        yield step.reason
    if step.kind == StepKind.STRANGER:
        yield "its source is not here"


def doubts(link: Link | None) -> Iterator[str]:
    """Why a link is in doubt."""
    if link is None:
        return
    if link.broken:
        yield f"no message arrives: {link.broken}" if link.how == How.ARRIVE else link.broken
    if link.doubt:
        yield f"perhaps: {link.doubt}"
    if link.conditional:
        yield "only under a condition"


def place_words(place: Place) -> str:
    return f"{place.file}:{place.line}"


__all__ = ["doubts", "node_words", "notes", "place_words", "relation", "step_name", "title"]
