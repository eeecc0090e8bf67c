"""Traces as data.  A key is always there, null where nothing is known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from archlint.dataflow.durations import longest_time, pauses
from archlint.dataflow.latency import ASSUMED, total
from archlint.dataflow.model import NOT_KNOWN, StepKind
from archlint.dataflow.pace import interval, topic_rate
from archlint.json_text import json_text
from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step
    from archlint.dataflow.paths import Branch
    from archlint.dataflow.trace import Trace, Way
    from archlint.place import Place
    from archlint.systems.nodes import Endpoint

VERSION = 1


def render(name: str, traces: Sequence[Trace]) -> str:
    """All traces of a name, each with a graph of its own."""
    document = {
        "version": VERSION,
        "name": name,
        "assumptions": list(ASSUMED),
        "traces": [_trace(trace) for trace in traces],
    }
    return json_text(document, indent=2) + "\n"


def _trace(trace: Trace) -> dict[str, Any]:
    numbers = {id(step): number for number, step in enumerate(trace.steps)}
    return {
        "system": trace.system.name,
        "kind": trace.subject.kind,
        "name": trace.subject.name,
        "steps": [step_data(trace.flow, step, numbers[id(step)]) for step in trace.steps],
        "links": [link_data(link, numbers) for link in trace.links],
        "comes_from": _members(trace.back, numbers),
        "goes_to": _members(trace.on, numbers),
        "ways": [_way(way, numbers) for way in trace.ways],
        "more_ways": trace.more_ways,
        "misfits": [{"step": numbers[id(misfit.step)], "message": misfit.words} for misfit in trace.misfits],
        "not_launched": [_end(end) for end in trace.beside],
    }


def _members(branches: Sequence[Branch], numbers: Mapping[int, int]) -> list[int]:
    """The steps of some trees by their numbers, the nearest first."""
    rows = list(branches)
    for branch in rows:
        rows += branch.branches
    return list(dict.fromkeys(numbers[id(branch.step)] for branch in rows))


def step_data(flow: Flow, step: Step, number: int) -> dict[str, Any]:
    """A step as data; ``id`` is how links and ways refer to it."""
    is_callback = step.kind == StepKind.CALLBACK
    return {
        "id": number,
        "kind": str(step.kind),
        "name": None if step.kind == StepKind.UNKNOWN or step.name == NOT_KNOWN else step.name,
        "node": None if step.node is None else step.node.name,
        "role": None if step.callback is None else str(step.callback.role),
        "types": [] if step.connection is None else step.connection.types,
        "period_s": interval(flow, step),
        "rate_hz": (topic_rate(flow, step) or None) if step.kind in (StepKind.TOPIC, StepKind.FRAME) else None,
        "pauses": [
            {"message": pause.words, "most_s": pause.most, "least_s": pause.least, **_place(pause.place)}
            for pause in pauses(flow.system, step)
        ],
        "stands_still_s": longest_time(flow.system, step) if is_callback else None,
        "reason": step.reason or None,
        **_place(step.place),
    }


def link_data(link: Link, numbers: Mapping[int, int]) -> dict[str, Any]:
    """A link between two steps as data."""
    return {
        "from": numbers[id(link.tail)],
        "to": numbers[id(link.head)],
        "kind": str(link.how),
        "certain": not link.doubt and not link.broken,
        "doubt": link.doubt or None,
        "broken": link.broken or None,
        "conditional": link.conditional,
        **_place(link.place),
    }


def _way(way: Way, numbers: Mapping[int, int]) -> dict[str, Any]:
    steps = [way.links[0].tail, *(link.head for link in way.links)]
    return {
        "steps": [numbers[id(step)] for step in steps],
        "known_s": total(way.terms),
        "complete": all(term.seconds is not None for term in way.terms),
        "terms": [
            {"seconds": term.seconds, "message": term.words, "step": numbers[id(term.step)]} for term in way.terms
        ],
    }


def _end(end: Endpoint) -> dict[str, Any]:
    return {"kind": str(end.kind), "node": end.node.name, **_place(end.place)}


def _place(place: Place | None) -> dict[str, Any]:
    if place is None:
        return {"file": None, "line": None, "column": None}
    return {"file": shown_file(place.file), "line": place.line, "column": place.column}


__all__ = ["link_data", "render", "step_data"]
