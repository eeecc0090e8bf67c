"""What is said of the way from step to step of a trace."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.dataflow.model import How, Link, StepKind

if TYPE_CHECKING:
    from archlint.dataflow.paths import Direction


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


__all__ = ["doubts", "relation"]
