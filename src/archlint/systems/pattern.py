"""Which architecture pattern a system resembles, and the figures that say so.

*Hub and spoke*: most connections have one node at one end, which three others or more are tied to.
*Many-to-many*: topics tie the nodes without such a centre.  *Request clusters*: callers and the services and
actions they ask weigh more than topics; where they weigh the same, as commands and states do, a hub decides.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, Final, Literal

from archlint.architecture import ACTION, CONNECTIONS, SERVICE, TOPIC, ConnectionKind
from archlint.counted import counted
from archlint.records import dataclass
from archlint.ros.well_known import OF_EVERY_NODE, OF_MANY_PUBLISHERS
from archlint.systems.shape import components, connections, plain_graph, splits

if TYPE_CHECKING:
    import networkx

    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node

Pattern = Literal["hub and spoke", "many-to-many", "request clusters"]
HUB: Final = "hub and spoke"
MANY: Final = "many-to-many"
REQUESTS: Final = "request clusters"

SHARED = OF_MANY_PUBLISHERS | OF_EVERY_NODE
"""Topics that everybody shares; they say nothing about the architecture."""
_CENTRAL = 0.6
"""The share of all pairs of neighbours, and of all other nodes, that a hub has at least."""
_FEWEST = 3
"""With fewer connected nodes every system is all patterns at once; what has fewer spokes is a link of a chain."""
_WIDEST = 2_000
"""Names with more pairs of ends than this are left out of the count of pairs, which would be quadratic."""


@dataclass(frozen=True)
class Hub:
    """A node with how many other nodes send it something, and how many it sends something to."""

    node: str
    fan_in: int
    fan_out: int


@dataclass(frozen=True)
class Figures:
    """What the shape of a system is, in numbers."""

    pattern: Pattern | None
    nodes: int
    connected: int
    pairs: Mapping[ConnectionKind, int]
    """Pairs of nodes that a topic, a service or an action ties."""
    hubs: tuple[Hub, ...]
    """The three nodes with most neighbours."""
    chain: tuple[str, ...]
    """Nodes of the longest chain of requests: each asks the next."""
    components: int
    """Groups of nodes that reach each other."""
    isolated: int
    bridges: tuple[str, ...]
    """Nodes without which the rest falls into parts of two and more."""


def figures(system: System) -> Figures:
    """Measure a system; linear in its endpoints, but for the pairs of nodes that one name ties."""
    nodes = [node for node in system.nodes if not node.test]
    groups = _groups(system, nodes)
    sources: dict[int, set[int]] = {id(node): set() for node in nodes}
    targets: dict[int, set[int]] = {id(node): set() for node in nodes}
    pairs = dict.fromkeys(CONNECTIONS, 0)
    for kind, source, target in _pairs(system, sources.keys()):
        pairs[kind] += 1
        sources[target].add(source)
        targets[source].add(target)
    around = {key: sources[key] | targets[key] for key in sources}
    by_degree = sorted(nodes, key=lambda n: (-len(around[id(n)]), n.name or ""))
    connected = sum(size for size in groups if size > 1)
    return Figures(
        _pattern(connected, pairs, [len(around[id(node)]) for node in by_degree]),
        len(nodes),
        connected,
        pairs,
        tuple(
            Hub(node.name or "?", len(sources[id(node)]), len(targets[id(node)]))
            for node in by_degree[:3]
            if len(around[id(node)]) > 1
        ),
        tuple(_longest_chain(system, nodes)),
        components=sum(size > 1 for size in groups),
        isolated=sum(size == 1 for size in groups),
        # Where single nodes are left, the line of the hub says it.
        bridges=tuple(node.name or "?" for node, parts in splits(system) if len(parts[0]) > 1),
    )


def _groups(system: System, nodes: list[Node]) -> list[int]:
    """How many of ``nodes`` each group has whose nodes reach each other."""
    known = {id(node) for node in nodes}
    return [len(known & part) for part in components(plain_graph(system))]


def _pairs(system: System, known: Collection[int]) -> Iterator[tuple[ConnectionKind, int, int]]:
    """Kind, and the node that data or a request comes from and goes to; each pair once a kind."""
    seen: set[tuple[ConnectionKind, int, int]] = set()
    for connection in connections(system):
        if connection.name in SHARED or len(connection.providers) * len(connection.users) > _WIDEST:
            continue
        for source, target in _directed(connection):
            pair = (connection.kind, source, target)
            if source != target and source in known and target in known and pair not in seen:
                seen.add(pair)
                yield pair


def _directed(connection: Connection) -> Iterator[tuple[int, int]]:
    for provider in connection.providers:
        for user in connection.users:
            ends = (id(provider.node), id(user.node))
            yield ends if connection.kind == TOPIC else (ends[1], ends[0])


def _pattern(connected: int, pairs: Mapping[ConnectionKind, int], degrees: list[int]) -> Pattern | None:
    """The pattern of a system by the numbers of its nodes' neighbours, most first."""
    if connected < _FEWEST:
        return None
    requests = pairs[SERVICE] + pairs[ACTION]
    ties = sum(degrees) / 2
    central = degrees[0] >= max(_FEWEST, _CENTRAL * (connected - 1), _CENTRAL * ties)
    if requests > pairs[TOPIC] or (requests and requests == pairs[TOPIC] and not central):
        return REQUESTS
    return HUB if central else MANY


def _longest_chain(system: System, nodes: list[Node]) -> list[str]:
    """The longest way from request to request; nodes that ask each other in a circle count as one."""
    import networkx

    graph = networkx.DiGraph()
    names = {id(node): node.name or "?" for node in nodes}
    for connection in (*system.services.values(), *system.actions.values()):
        if len(connection.providers) * len(connection.users) <= _WIDEST:
            graph.add_edges_from(
                (source, other)
                for source, other in _directed(connection)
                if source != other and {source, other} <= names.keys()
            )
    if not graph:
        return []
    condensed = networkx.condensation(graph)
    return [_members(condensed, part, names) for part in networkx.dag_longest_path(condensed)]


def _members(condensed: networkx.DiGraph, part: int, names: dict[int, str]) -> str:
    return "/".join(sorted(names[key] for key in condensed.nodes[part]["members"])).replace("//", " and /")


def words(figures: Figures) -> list[str]:
    """The figures for people, a line each."""
    lines = [f"pattern: {figures.pattern or 'none: fewer than three nodes are connected'}"]
    ties = ", ".join(f"{figures.pairs[kind]} by {kind}s" for kind in CONNECTIONS if figures.pairs[kind])
    lines.append(
        f"connected: {figures.connected} of {counted(figures.nodes, 'node')}" + (f"; pairs {ties}" if ties else "")
    )
    if figures.components > 1 or figures.isolated:
        lines.append(
            f"parts: {counted(figures.components, 'group')} of connected nodes, "
            f"{counted(figures.isolated, 'node')} alone"
        )
    for hub in figures.hubs:
        lines.append(f"hub: {hub.node}, fan-in {hub.fan_in}, fan-out {hub.fan_out}")
    if len(figures.chain) > 1:
        lines.append(f"longest chain of requests: {' -> '.join(figures.chain)}")
    if figures.bridges:
        lines.append(f"connects the parts: {', '.join(figures.bridges)}")
    return lines
