"""Which architecture pattern a system resembles, and the figures that say so.

*Hub and spoke*: most connections have one node at one end, which three others or more are tied to.
*Many-to-many*: topics tie the nodes without such a centre.  *Request clusters*: callers and the services and
actions they ask weigh more than topics; where they weigh the same, as commands and states do, a hub decides.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from archlint.ros.well_known import OF_EVERY_NODE, OF_MANY_PUBLISHERS
from archlint.systems.shape import connections, plain_graph, splits

if TYPE_CHECKING:
    import networkx

    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node

HUB = "hub and spoke"
MANY = "many-to-many"
REQUESTS = "request clusters"

SHARED = OF_MANY_PUBLISHERS | OF_EVERY_NODE
"""Topics that everybody shares; they say nothing about the architecture."""
_CENTRAL = 0.6
"""The share of all pairs of neighbours, and of all other nodes, that a hub has at least."""
_FEWEST = 3
"""With fewer connected nodes every system is all patterns at once; what has fewer spokes is a link of a chain."""
_WIDEST = 2_000
"""Names with more pairs of ends than this are left out of the count of pairs, which would be quadratic."""


@dataclass
class Figures:
    """What the shape of a system is, in numbers.  Fan-in and fan-out count other nodes."""

    pattern: str | None
    nodes: int
    connected: int
    pairs: dict[str, int]
    """Pairs of nodes that a topic, a service or an action ties, by kind."""
    hubs: list[tuple[str, int, int]] = field(default_factory=list)
    """The three nodes with most neighbours: name, fan-in, fan-out."""
    chain: list[str] = field(default_factory=list)
    """Nodes of the longest chain of requests: each asks the next."""
    components: int = 0
    """Groups of nodes that reach each other."""
    isolated: int = 0
    bridges: list[str] = field(default_factory=list)
    """Nodes without which the rest falls into parts of two and more."""


def figures(system: System) -> Figures:
    """Measure a system; linear in its endpoints, but for the pairs of nodes that one name ties."""
    import networkx

    nodes = [node for node in system.nodes if not node.test]
    graph = plain_graph(system)
    groups = [[key for key in part if not isinstance(key, tuple)] for part in networkx.connected_components(graph)]
    known = {id(node) for node in nodes}
    groups = [[key for key in group if key in known] for group in groups]
    sources: dict[int, set[int]] = {id(node): set() for node in nodes}
    targets: dict[int, set[int]] = {id(node): set() for node in nodes}
    pairs = {"topic": 0, "service": 0, "action": 0}
    for kind, source, target in _pairs(system, known):
        pairs[kind] += 1
        sources[target].add(source)
        targets[source].add(target)
    by_degree = sorted(nodes, key=lambda n: (-len(sources[id(n)] | targets[id(n)]), n.name or ""))
    figures = Figures(None, len(nodes), sum(len(group) for group in groups if len(group) > 1), pairs)
    figures.hubs = [
        (node.name or "?", len(sources[id(node)]), len(targets[id(node)]))
        for node in by_degree[:3]
        if len(sources[id(node)] | targets[id(node)]) > 1
    ]
    figures.components = sum(len(group) > 1 for group in groups)
    figures.isolated = sum(len(group) == 1 for group in groups)
    figures.chain = _longest_chain(system, nodes)
    # Where single nodes are left, the line of the hub says it.
    figures.bridges = [node.name or "?" for node, parts in splits(system) if len(parts[0]) > 1]
    figures.pattern = _pattern(figures, by_degree, sources, targets)
    return figures


def _pairs(system: System, known: set[int]) -> Iterator[tuple[str, int, int]]:
    """Kind, and the node that data or a request comes from and goes to; each pair once a kind."""
    seen: set[tuple[str, int, int]] = set()
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
            yield ends if connection.kind == "topic" else (ends[1], ends[0])


def _pattern(
    figures: Figures, by_degree: list[Node], sources: dict[int, set[int]], targets: dict[int, set[int]]
) -> str | None:
    if figures.connected < _FEWEST:
        return None
    requests = figures.pairs["service"] + figures.pairs["action"]
    around = {key: sources[key] | targets[key] for key in sources}
    ties = sum(len(others) for others in around.values()) / 2
    hub = len(around[id(by_degree[0])])
    central = hub >= max(_FEWEST, _CENTRAL * (figures.connected - 1), _CENTRAL * ties)
    if requests > figures.pairs["topic"] or (requests and requests == figures.pairs["topic"] and not central):
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
    ties = ", ".join(
        f"{figures.pairs[kind]} by {kind}s" for kind in ("topic", "service", "action") if figures.pairs[kind]
    )
    lines.append(
        f"connected: {figures.connected} of {_counted(figures.nodes, 'node')}" + (f"; pairs {ties}" if ties else "")
    )
    if figures.components > 1 or figures.isolated:
        lines.append(
            f"parts: {_counted(figures.components, 'group')} of connected nodes, "
            f"{_counted(figures.isolated, 'node')} alone"
        )
    for name, fan_in, fan_out in figures.hubs:
        lines.append(f"hub: {name}, fan-in {fan_in}, fan-out {fan_out}")
    if len(figures.chain) > 1:
        lines.append(f"longest chain of requests: {' -> '.join(figures.chain)}")
    if figures.bridges:
        lines.append(f"connects the parts: {', '.join(figures.bridges)}")
    return lines


def _counted(number: int, word: str) -> str:
    return f"{number} {word}" if number == 1 else f"{number} {word}s"
