"""What else is said of a step of a trace."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.dataflow.model import StepKind
from archlint.dataflow.pace import interval, topic_rate
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step


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


__all__ = ["notes"]
