"""What there is to know of one name: both ends of a connection, a node, or a parameter with all that sets it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Union

from archlint.analysis.kept import once
from archlint.lookup.frames import FrameSummary, frame_summary, known_frames
from archlint.lookup.index import Index
from archlint.lookup.mentions import Subject
from archlint.model import NAMED

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.model import ParameterDeclaration
    from archlint.place import Place
    from archlint.systems.nodes import Endpoint, Node


@dataclass(frozen=True, eq=False)
class ConnectionSummary:
    """A topic, service or action with its publishers or servers (``providers``) and its subscriptions or clients.

    ``rates`` are the messages a second of each provider, None where no timer decides it.  ``undelivered`` says why
    publishers and subscriptions do not connect."""

    kind: ConnectionKind
    name: str
    types: tuple[str, ...]
    providers: tuple[Endpoint, ...]
    users: tuple[Endpoint, ...]
    rates: tuple[float | None, ...]
    undelivered: tuple[str, ...]
    mentioned: tuple[Place, ...]


@dataclass(frozen=True, eq=False)
class ParameterSummary:
    """A parameter of one node class.  ``values`` are those that launches set, by node and launch file."""

    name: str
    nodes: tuple[Node, ...]
    declarations: tuple[ParameterDeclaration, ...]
    values: tuple[tuple[Node, object], ...]
    set_at: tuple[Place, ...]
    read_at: tuple[Place, ...]


@dataclass(frozen=True, eq=False)
class NodeSummary:
    node: Node


Summary = Union[ConnectionSummary, ParameterSummary, NodeSummary, FrameSummary]


def connection_summary(index: Index, kind: ConnectionKind, name: str) -> ConnectionSummary:
    """What is known of a full name of a topic, service or action."""
    subject = Subject(kind, name)
    providers, users = ([row.end for row in rows if row.end is not None] for rows in index.ends_of(subject))
    types = sorted({end.type for end in (*providers, *users) if end.type is not None})
    rates = tuple(index.rates.get(id(end.creation)) for end in providers)
    mentioned = sorted({mention.place for mention in index.of(subject) if mention.role != "call"})
    undelivered = tuple(index.undelivered(subject))
    return ConnectionSummary(
        kind, name, tuple(types), tuple(providers), tuple(users), rates, undelivered, tuple(mentioned)
    )


def parameter_summary(index: Index, subject: Subject) -> ParameterSummary:
    """What is known of a parameter of one node class."""
    every, name = index.of(subject), subject.name
    of_it = {id(mention.node): mention.node for mention in every if mention.node is not None}
    nodes = [node for node in _nodes(index) if id(node) in of_it] or list(of_it.values())
    declarations = {d.place: d for node in nodes for d in node.parameters if d.name.text == name}
    values = {
        (n.name or "", n.launched_by or "", repr(v)): (n, v) for n in nodes for k, v in n.overrides.items() if k == name
    }
    read, set_ = (sorted({m.place for m in every if m.role == role}) for role in ("get", "set"))
    return ParameterSummary(
        name,
        tuple(sorted(nodes, key=lambda node: (node.name or "", node.launched_by or ""))),
        tuple(declarations[place] for place in sorted(declarations)),
        tuple(values[key] for key in sorted(values)),
        tuple(set_),
        tuple(read),
    )


def summaries(index: Index, name: str) -> list[Summary]:
    """All that has a name: topics, services and actions by their full names (the first slash may be missing) or else as
    the code writes them, nodes by their names or the names of their classes, coordinate frames and parameters by
    theirs."""
    full = name if name.startswith("/") else f"/{name}"
    connected = {key for key in _connected(index) if key[1] == full} or _written(index, name)
    answers: list[Summary] = [connection_summary(index, *key) for key in sorted(connected)]
    answers += [NodeSummary(node) for node in _nodes(index) if name in _names_of(node) or node.name == full]
    frame = frame_summary(index, name)
    answers += [frame] if frame is not None else []
    parameters = sorted(s for s in index.subjects() if s.kind == "parameter" and s.name == name)
    return [*answers, *(parameter_summary(index, subject) for subject in parameters)]


def known_names(index: Index) -> list[str]:
    """All names that :func:`summaries` knows, sorted."""
    names = {name for _, name in _connected(index)}
    names.update(name for node in _nodes(index) for name in (*_names_of(node), node.name or "") if name)
    return sorted(
        names | known_frames(index) | {subject.name for subject in index.subjects() if subject.kind == "parameter"}
    )


@once
def _connected(index: Index) -> Sequence[tuple[ConnectionKind, str]]:
    ends = (end for system, _ in index.systems for end in system.endpoints if end.resolved and not end.error)
    rows = dict.fromkeys((NAMED[end.kind], end.name) for end in ends if end.name is not None)
    return [(kind, name) for kind, name in rows if any(index.ends_of(Subject(kind, name)))]


def _written(index: Index, name: str) -> set[tuple[ConnectionKind, str]]:
    """The full names of what is created under a name."""
    known = set(_connected(index))
    ends = (end for system, _ in index.systems for end in system.endpoints if end.written == name)
    return known & {(NAMED[end.kind], end.name or "") for end in ends}


def _nodes(index: Index) -> list[Node]:
    """The nodes as they run: as a launch file starts them, or else as the code alone has them."""
    best: dict[object, int] = {}
    for system, rank in index.systems:
        for node in system.nodes:
            best[_class(node)] = min(rank, best.get(_class(node), rank))
    rows = [(node, rank) for system, rank in index.systems for node in system.nodes]
    nodes = {(n.name, n.launched_by, _class(n)): n for n, rank in rows if best[_class(n)] == rank}
    return sorted(nodes.values(), key=lambda node: (node.name or "", node.launched_by or ""))


def _class(node: Node) -> object:
    return (
        (node.package, node.executable) if node.blueprint is None else (node.blueprint.place, node.blueprint.class_name)
    )


def _names_of(node: Node) -> Iterable[str]:
    """By what else a node is known."""
    return () if node.blueprint is None else (node.blueprint.class_name,)


__all__ = [
    "ConnectionSummary",
    "FrameSummary",
    "NodeSummary",
    "ParameterSummary",
    "Summary",
    "connection_summary",
    "known_names",
    "parameter_summary",
    "summaries",
]
