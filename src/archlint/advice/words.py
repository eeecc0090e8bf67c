"""How often something happens, and what makes it happen, in words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.advice.model import Evidence
from archlint.dataflow.model import StepKind
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.dataflow.model import Link
    from archlint.execution.request_paces import PaceKind, RequestPace
    from archlint.model import ApiCall, Callback
    from archlint.systems.nodes import Node

_OCCASIONS = {
    Role.SUBSCRIPTION: "when a message arrives",
    Role.FILTER: "when messages arrive",
    Role.TIMER: "in a timer",
    Role.SERVICE: "when its own service is called",
    Role.EXECUTE: "while it works on a goal",
    Role.DONE: "when an answer arrives",
    Role.FEEDBACK: "when feedback arrives",
    Role.PARAMETER: "when a parameter is set",
    Role.INIT: "once, when it starts",
    Role.MAIN: "in its main program",
    Role.MODULE: "in its main program",
    Role.THREAD: "in a thread",
    Role.METHOD: "in a method that nothing here calls",
    Role.LIFECYCLE: "in a transition of its life cycle",
}


def node_name(node: Node | None) -> str:
    """A node by its name, or by its class."""
    if node is None:
        return "a node"
    cls = None if node.blueprint is None else node.blueprint.class_name
    return node.name or cls or "a node whose name is not known"


def occasion_words(callback: Callback | None) -> str:
    """When a callback runs."""
    if callback is None:
        return "on an occasion"
    period = None if callback.creation is None else callback.creation.period
    if callback.role == Role.TIMER and period:
        return f"in a timer of {period:.3g} s"
    return _OCCASIONS.get(callback.role, "on an occasion")


_PACES: Mapping[PaceKind, str] = {
    "timer": "the timer is made here",
    "loop": "the loop begins here",
    "message": "with each message that arrives here",
    "answer": "each answer sends the next request from here",
}


def pace_evidence(pace: RequestPace | None, call: ApiCall) -> Iterator[Evidence]:
    """What sets the pace of a call, if that is written elsewhere."""
    if pace is not None and pace.place != call.place:
        yield Evidence(pace.place, _PACES[pace.kind])


def why_unknown(links: Sequence[Link], verb: str, nobody: str) -> str:
    """Why it is not known how a connection is used: nobody uses it, who does is not here, or is not followed."""
    strangers = (link.doubt for link in links if link.tail.kind == StepKind.STRANGER)
    return next(strangers, f"the code that {verb} it is not followed" if links else nobody)


def asked_words(pace: RequestPace | None, seconds: float | None) -> str:
    """How often something is sent; empty where that is not known."""
    if pace is not None:
        return pace.words
    return "" if seconds is None else f"every {seconds:.3g} s"


def rate_of(seconds: float | None) -> float | None:
    """How often a second."""
    return None if not seconds else 1 / seconds


__all__ = ["asked_words", "node_name", "occasion_words", "pace_evidence", "rate_of", "why_unknown"]
