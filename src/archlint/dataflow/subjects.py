"""Which steps of a graph of data a name means: a topic, service, action or node, in full, as written, or by class."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

from archlint.analysis.transforms import looked_up_transforms, sent_transforms
from archlint.dataflow.model import NOT_KNOWN, StepKind
from archlint.model import NAMED
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Step
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

SubjectKind = Literal["topic", "service", "action", "frame", "node"]


@dataclass(frozen=True, eq=False)
class Subject:
    """What a name means in one system.  ``arriving`` are the steps through which data comes to it, ``leaving`` those
    through which it goes on."""

    kind: SubjectKind
    name: str
    arriving: tuple[Step, ...]
    leaving: tuple[Step, ...]
    node: Node | None = None


_REQUESTS: dict[StepKind, SubjectKind] = {
    StepKind.TOPIC: "topic",
    StepKind.SERVICE: "service",
    StepKind.ACTION: "action",
}


def subjects(flow: Flow, name: str) -> list[Subject]:
    """All that a name means in a system, connections first."""
    full = name if name.startswith("/") else f"/{name}"
    wanted = {step.name for step in flow.steps if step.kind in _REQUESTS and step.name in (full, name)}
    wanted = wanted or _written(flow.system, name)
    meant = [_connection(flow, step) for step in flow.steps if step.kind in _REQUESTS and step.name in wanted]
    meant += _frame(flow, name)
    nodes = [node for node in flow.system.entries if node.name == full or name in (node.name, _class_of(node))]
    meant += [_node(flow, node) for node in nodes]
    return sorted(meant, key=lambda subject: (_ORDER.index(subject.kind), subject.name))


_ORDER: list[SubjectKind] = ["topic", "service", "action", "frame", "node"]


def known_names(system: System) -> Iterator[str]:
    """All names that :func:`subjects` knows."""
    for connections in (system.topics, system.services, system.actions):
        yield from connections
    for node in system.entries:
        yield from (name for name in (node.name, _class_of(node)) if name)
    for transform in (*sent_transforms(system), *looked_up_transforms(system)):
        yield from (frame for frame in (transform.parent, transform.child) if frame is not None)


def _written(system: System, name: str) -> set[str]:
    """The full names of what is created under a name."""
    ends = (end for end in system.endpoints if end.written == name and end.resolved)
    return {end.name for end in ends if end.name is not None and end.kind in NAMED}


def _connection(flow: Flow, step: Step) -> Subject:
    back = [other for other in flow.steps if other.kind in _BACK and other.connection is step.connection]
    answered = [other for other in back if step.connection is not None and flow.out_of(other)]
    frames = [other for other in flow.steps if other.kind == StepKind.FRAME and other.topic == step.name]
    return Subject(_REQUESTS[step.kind], step.name, (step, *frames), (step, *answered, *frames))


def _frame(flow: Flow, name: str) -> Iterator[Subject]:
    """The coordinate frame of a name, on whatever topics its transforms are."""
    steps = tuple(step for step in flow.steps if step.kind == StepKind.FRAME and step.name == name != NOT_KNOWN)
    if steps:
        yield Subject("frame", name, steps, steps)


_BACK = frozenset({StepKind.ANSWER, StepKind.RESULT})


def _node(flow: Flow, node: Node) -> Subject:
    own = tuple(step for step in flow.steps if step.node is node and step.kind != StepKind.KEPT)
    return Subject("node", node.name or _class_of(node), own, own, node)


def _class_of(node: Node) -> str:
    return "" if node.blueprint is None else node.blueprint.class_name


__all__ = ["Subject", "SubjectKind", "known_names", "subjects"]
