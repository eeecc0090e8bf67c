"""The shape of a system's graph: who is tied to whom, and which nodes hold the parts together."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import networkx

    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node


def connections(system: System) -> list[Connection]:
    return [*system.topics.values(), *system.services.values(), *system.actions.values()]


def connected(system: System) -> set[int]:
    """``id`` of the nodes that share a name with another node, be it one that is not known."""
    talking: set[int] = set()
    for connection in connections(system):
        nodes = {id(end.node) for end in (*connection.providers, *connection.users)}
        if len(nodes) > 1:
            talking |= nodes
    return talking


def plain_graph(system: System) -> networkx.Graph:
    """Nodes (by ``id``) and the names that have both ends, undirected: linear in the endpoints, where an edge
    for each pair of nodes would be quadratic."""
    import networkx

    graph = networkx.Graph()
    graph.add_nodes_from(id(node) for node in system.nodes)
    for connection in connections(system):
        providers, users = ([e for e in ends if e.node.is_node] for ends in (connection.providers, connection.users))
        if providers and users:
            key = (connection.kind, connection.name)
            graph.add_edges_from((key, id(end.node)) for end in (*providers, *users))
    return graph


def splits(system: System) -> list[tuple[Node, list[list[Node]]]]:
    """The nodes without which others fall into parts, with the parts.

    Parts of two nodes and more count, and there are two of them at least; or nobody is left connected at all, as
    in the smallest system, where one node stands between two.
    """
    import networkx

    graph = plain_graph(system)
    nodes = {id(node): node for node in system.nodes}
    points = []
    for key in set(networkx.articulation_points(graph)) & nodes.keys():
        around = networkx.node_connected_component(graph, key) - {key}
        parts = [
            [nodes[member] for member in part if member in nodes]
            for part in networkx.connected_components(graph.subgraph(around))
        ]
        parts = [part for part in parts if part]
        counted = [part for part in parts if len(part) > 1] or parts
        if len(counted) > 1:
            points.append((nodes[key], counted))
    return sorted(points, key=lambda entry: entry[0].name or "")
