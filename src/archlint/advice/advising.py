"""What is advised for the connections of some systems."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.advice.actions import judge_action
from archlint.advice.model import Advice, Judged
from archlint.advice.services import judge_service
from archlint.advice.topics import judge_topic
from archlint.analysis.coexistence import named_by_library
from archlint.dataflow.graph import flow_of
from archlint.dataflow.model import StepKind
from archlint.dataflow.systems import ranked

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.dataflow.model import Flow, Step
    from archlint.systems.model import System

_KINDS: dict[StepKind, ConnectionKind] = {
    StepKind.TOPIC: "topic",
    StepKind.SERVICE: "service",
    StepKind.ACTION: "action",
}
_ORDER: tuple[ConnectionKind, ...] = ("topic", "service", "action")
_Key = tuple[int, str, str]


def advice_of(systems: Sequence[System], distros: Sequence[str]) -> list[Advice]:
    """What is advised for each connection: as launch files connect it, where one does, or else among all nodes.  Equal
    advice of several launch files is one.  ``distros`` are the distributions of ROS to judge for."""
    best: dict[_Key, int] = {}
    rows: list[tuple[_Key, int, Advice]] = []
    for system, rank in ranked(systems):
        for advice in _of_system(system, distros):
            key: _Key = (id(system.workspace), advice.kind, advice.name)
            best[key] = min(rank, best.get(key, rank))
            rows.append((key, rank, advice))
    merged: dict[tuple[int, Advice], Advice] = {}
    for key, rank, advice in rows:
        if rank == best[key]:
            same = key[0], replace(advice, systems=())
            known = merged.get(same, same[1])
            merged[same] = replace(known, systems=tuple(dict.fromkeys((*known.systems, *advice.systems))))
    return sorted(merged.values(), key=lambda advice: (_ORDER.index(advice.kind), advice.name, advice.systems))


def _of_system(system: System, distros: Sequence[str]) -> Iterator[Advice]:
    flow = flow_of(system)
    for step in flow.steps:
        if step.kind in _KINDS and step.connection is not None and _is_judged(step):
            types = tuple(step.connection.types)
            launch = () if system.name is None else (system.name,)
            yield Advice(_KINDS[step.kind], step.name, types, _judged(flow, step, distros), launch)


def _judged(flow: Flow, step: Step, distros: Sequence[str]) -> Judged:
    match step.kind:
        case StepKind.TOPIC:
            return judge_topic(flow, step)
        case StepKind.SERVICE:
            return judge_service(flow, step, distros)
    return judge_action(flow, step)


def _is_judged(step: Step) -> bool:
    """Whether a connection is the workspace's own: not one of a library, or of its tests."""
    assert step.connection is not None
    ends = [*step.connection.providers, *step.connection.users]
    return not all(named_by_library(end) or end.node.test for end in ends)


__all__ = ["advice_of"]
