"""Who uses a topic, a service, an action or a node, and who depends on these users through callbacks."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.dataflow.model import Step, StepKind
from archlint.dataflow.paths import reached
from archlint.model import EntityKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow
    from archlint.dataflow.subjects import Subject
    from archlint.place import Place
    from archlint.systems.nodes import Connection, Endpoint, Node

_LOSES = {
    EntityKind.PUBLISHER: "publishes on it",
    EntityKind.SUBSCRIBER: "gets no message any more",
    EntityKind.SERVICE: "serves it",
    EntityKind.CLIENT: "gets no answer any more",
    EntityKind.ACTION_SERVER: "serves it",
    EntityKind.ACTION_CLIENT: "gets no result any more",
}
"""What becomes of each end of a connection that is taken away."""
_USES = {"topic": "message", "service": "answer", "action": "result"}


@dataclass(frozen=True)
class Effect:
    """Something that a change reaches: ``name`` is what (a connection, a callback), ``words`` how.  ``perhaps`` says
    that some link of the way to it is in doubt."""

    node: str | None
    name: str
    place: Place | None
    words: str
    package: str | None = None
    perhaps: bool = False

    @property
    def sort_key(self) -> tuple[object, ...]:
        place = self.place
        where = ("", 0, 0) if place is None else (place.file, place.line, place.column)
        return self.perhaps, self.node or "", where, self.name, self.words


def effects_of(flow: Flow, subject: Subject) -> tuple[list[Effect], list[Effect], list[Step]]:
    """The direct effects of taking a subject away, the further ones, and the steps that depend on it."""
    starts = list(subject.leaving)
    every, surely = reached(flow, starts, "on"), _surely(flow, starts)
    steps = [step for step in flow.steps if id(step) in every]
    own = {id(step) for step in (*subject.leaving, *subject.arriving)}
    direct = list(_of_node(flow, subject.node) if subject.node is not None else _of_connection(subject))
    return direct, [*_further(steps, own, surely, subject.node)], steps


def _surely(flow: Flow, starts: Sequence[Step]) -> set[int]:
    """The steps (``id``) to which a way without any doubt leads."""
    seen, left = {id(step) for step in starts}, list(starts)
    while left:
        for link in flow.out_of(left.pop()):
            if not link.broken and not link.doubt and id(link.head) not in seen:
                seen.add(id(link.head))
                left.append(link.head)
    return seen


def _of_connection(subject: Subject) -> Iterator[Effect]:
    connection = subject.leaving[0].connection
    for end in () if connection is None else (*connection.users, *connection.providers):
        yield Effect(end.node.name, subject.name, end.place, _LOSES[end.kind], end.node.package)


def _of_node(flow: Flow, node: Node) -> Iterator[Effect]:
    """The users of what a node publishes and serves."""
    system = flow.system
    strangers: dict[int, list[str]] = {}
    for link in flow.links:
        if link.tail.kind == StepKind.STRANGER and link.head.connection is not None:
            strangers.setdefault(id(link.head.connection), []).append(link.tail.name)
    for connection in (*system.topics.values(), *system.services.values(), *system.actions.values()):
        if any(end.node is node for end in connection.providers):
            yield from _of_provider(connection, node, strangers.get(id(connection), []))
        elif any(end.node is node for end in connection.users) and _is_last(connection.users, node):
            noun = "subscribes to" if connection.kind == "topic" else "calls"
            for end in connection.providers:
                words = f"nobody else {noun} {connection.name}"
                yield Effect(end.node.name, connection.name, end.place, words, end.node.package)


def _of_provider(connection: Connection, node: Node, strangers: Sequence[str]) -> Iterator[Effect]:
    others = list(dict.fromkeys(end.node.name or "?" for end in connection.providers if end.node is not node))
    others += [f"perhaps {name}" for name in dict.fromkeys(strangers)]
    noun = _USES[connection.kind]
    for end in connection.users:
        if end.node is node:
            continue
        words = f"gets no {noun} of {connection.name} any more"
        if others:
            words = f"gets no {noun} of {connection.name} from it, but from {', '.join(others)}"
        yield Effect(end.node.name, connection.name, end.place, words, end.node.package)


def _is_last(ends: Collection[Endpoint], node: Node) -> bool:
    return all(end.node is node for end in ends)


def _further(
    steps: Sequence[Step], own: Collection[int], surely: Collection[int], node: Node | None
) -> Iterator[Effect]:
    """What depends on it through callbacks: connections, and callbacks of nodes."""
    for step in steps:
        if (
            id(step) in own
            or step.kind in (StepKind.KEPT, StepKind.UNKNOWN)
            or (node is not None and step.node is node)
        ):
            continue
        perhaps = id(step) not in surely
        package = None if step.node is None else step.node.package
        if step.kind == StepKind.CALLBACK:
            name = None if step.node is None else step.node.name
            yield Effect(name, step.name, step.place, "depends on it", package, perhaps)
        elif step.kind == StepKind.STRANGER:
            yield Effect(step.name, step.name, step.place, "may depend on it: its source is not here", package, True)
        elif step.kind in (StepKind.TOPIC, StepKind.SERVICE, StepKind.ACTION):
            yield Effect(None, step.name, None, f"{step.kind}: what is sent there depends on it", None, perhaps)


__all__ = ["Effect", "effects_of"]
