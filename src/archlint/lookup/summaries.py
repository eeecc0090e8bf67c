"""What there is to know of one connection, or of one parameter with all that sets it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Union

from archlint.lookup.frames import FrameSummary
from archlint.lookup.index import Index
from archlint.lookup.mentions import Subject
from archlint.lookup.running_nodes import running_nodes
from archlint.records import dataclass

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
    nodes = [node for node in running_nodes(index) if id(node) in of_it] or list(of_it.values())
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


__all__ = [
    "ConnectionSummary",
    "FrameSummary",
    "NodeSummary",
    "ParameterSummary",
    "Summary",
    "connection_summary",
    "parameter_summary",
]
