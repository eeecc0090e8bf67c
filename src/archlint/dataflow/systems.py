"""In which systems a name is traced: in those that launch files start, or else among all nodes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.dataflow.trace import Trace
from archlint.dataflow.traces import traces
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_LAUNCHED, _INCLUDED, _OPEN = range(3)


def traces_of(systems: Sequence[System], name: str, origin: str | None = None, end: str | None = None) -> list[Trace]:
    """The traces of all that a name means: what a launch file starts counts, where one starts it; then what files do
    that others include; and then the nodes as their code has them."""
    best: dict[tuple[int, str, str], int] = {}
    rows: list[tuple[int, Trace]] = []
    for system, rank in ranked(systems):
        for trace in traces(system, name, origin, end):
            key = _key(trace)
            best[key] = min(rank, best.get(key, rank))
            rows.append((rank, trace))
    best_traces = [trace for rank, trace in rows if rank == best[_key(trace)]]
    return [replace(trace, beside=tuple(_beside(systems, trace))) for trace in best_traces]


def _key(trace: Trace) -> tuple[int, str, str]:
    return id(trace.system.workspace), trace.subject.kind, trace.subject.name


def ranked(systems: Sequence[System]) -> Iterator[tuple[System, int]]:
    """Systems and their alternatives, each with how much it counts, the smallest most."""
    for system in systems:
        rank = _OPEN if system.name is None else _INCLUDED if system.is_included else _LAUNCHED
        yield system, rank
        yield from ((other, rank) for _, other in system.alternatives)


def _beside(systems: Sequence[System], trace: Trace) -> Iterator[Endpoint]:
    """The ends of a traced connection in nodes that no launch file starts."""
    if trace.system.name is None or trace.subject.kind in ("node", "frame"):
        return
    for system in systems:
        workspace = system.workspace
        if system.name is not None or workspace is None or workspace is not trace.system.workspace:
            continue
        of_kind = {"topic": system.topics, "service": system.services, "action": system.actions}
        connection = of_kind[trace.subject.kind].get(trace.subject.name)
        for end in () if connection is None else (*connection.providers, *connection.users):
            blueprint = end.node.blueprint
            if blueprint is not None and not end.node.test and key_of(blueprint) not in workspace.started_by_launch:
                yield end


__all__ = ["ranked", "traces_of"]
