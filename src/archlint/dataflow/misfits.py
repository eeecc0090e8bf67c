"""Where rates do not fit: callbacks that are due again before they are done, and queues that must overflow.

Only what is certain counts: timers that nothing stops, sleeps that each run comes to, publishers whose messages each
turn sends.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.dataflow.durations import shortest_time
from archlint.dataflow.model import StepKind
from archlint.dataflow.pace import rate, timer_period
from archlint.dataflow.threads import waits_for
from archlint.model import Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step


@dataclass(frozen=True)
class Misfit:
    """Something that cannot keep up, in a sentence."""

    step: Step
    words: str


def misfits(flow: Flow, among: Collection[int]) -> list[Misfit]:
    """What does not fit among some steps (``id``), in the order of the graph."""
    return [misfit for step in flow.steps if id(step) in among for misfit in _of(flow, step)]


def _of(flow: Flow, step: Step) -> Iterator[Misfit]:
    if step.kind != StepKind.CALLBACK or step.callback is None:
        return
    seconds, due = shortest_time(flow.system, step), rate(flow, step)
    if step.callback.role == Role.TIMER:
        period = timer_period(flow.system, step)
        if period is not None and seconds > period:
            yield Misfit(step, f"it sleeps for {seconds:g} s each time, and is due every {period:g} s")
    elif due * seconds > 1:
        yield Misfit(step, f"{due:g} messages a second arrive, and it sleeps for {seconds:g} s with each{_loss(step)}")
    elif due:
        yield from _overflow(flow, step, due)


def _loss(step: Step) -> str:
    depth = queue_depth(step)
    if depth is None:
        return ""
    return f": its queue keeps the last {depth}, and all others are lost"


def _overflow(flow: Flow, step: Step, due: float) -> Iterator[Misfit]:
    """A queue that is too short for the time in which another callback keeps the thread."""
    depth = queue_depth(step)
    for other in waits_for(flow, step) if depth is not None else ():
        seconds = shortest_time(flow.system, other)
        if depth is not None and due * seconds >= depth + 1:
            words = (
                f"{other.name} keeps its thread for {seconds:g} s each time, in which {due * seconds:.3g} messages "
                f"arrive; its queue keeps the last {depth}, and the others are lost"
            )
            yield Misfit(step, words)


def queue_depth(step: Step) -> int | None:
    """How many messages the queue of a subscription keeps; None where that is not known, or no number is set."""
    creation = None if step.callback is None else step.callback.creation
    qos = None if creation is None else creation.qos
    return qos.depth if qos is not None and qos.history == "keep_last" else None


__all__ = ["Misfit", "misfits", "queue_depth"]
