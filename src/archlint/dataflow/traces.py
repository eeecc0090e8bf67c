"""Traces of a name: what leads to it and on from it, how long that takes and what does not fit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.dataflow.graph import flow_of
from archlint.dataflow.latency import terms
from archlint.dataflow.misfits import misfits
from archlint.dataflow.paths import reached, tree
from archlint.dataflow.subjects import Subject, subjects
from archlint.dataflow.trace import Trace, Way, steps_of
from archlint.dataflow.ways import shortest_ways

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow
    from archlint.systems.model import System


def traces(system: System, name: str, origin: str | None = None, end: str | None = None) -> list[Trace]:
    """The traces of all that a name means in a system; ``origin`` and ``end`` limit them to the ways from one name
    and to another."""
    flow = flow_of(system)
    return [
        trace
        for subject in subjects(flow, name)
        if (trace := _trace(flow, subject, _named(flow, origin), _named(flow, end))) is not None
    ]


def _named(flow: Flow, name: str | None) -> list[Subject] | None:
    return None if name is None else subjects(flow, name)


def _trace(flow: Flow, subject: Subject, origin: list[Subject] | None, end: list[Subject] | None) -> Trace | None:
    """None where no way leads from the origin, or to the end."""
    first = None if origin is None else [step for each in origin for step in each.leaving]
    last = None if end is None else [step for each in end for step in each.arriving]
    is_limited = first is not None or last is not None
    back = on = None
    if first is not None:
        back = reached(flow, first, "on", True) & reached(flow, subject.arriving, "back", True)
        if not back & set(map(id, subject.arriving)) or not back & set(map(id, first)):
            return None
    if last is not None:
        on = reached(flow, last, "back", True) & reached(flow, subject.leaving, "on", True)
        if not on & set(map(id, last)):
            return None
    behind = tree(flow, subject.arriving, "back", back) if first is not None or not is_limited else []
    ahead = tree(flow, subject.leaving, "on", on) if last is not None or not is_limited else []
    ways = list(shortest_ways(flow, subject, behind, ahead, first, last))
    steps = {id(step) for step in steps_of((*behind, *ahead))}
    shown = tuple(Way(tuple(way), tuple(terms(flow, way))) for way in ways if way is not None)
    return Trace(flow, subject, tuple(behind), tuple(ahead), shown, tuple(misfits(flow, steps)), ways.count(None))


__all__ = ["traces"]
