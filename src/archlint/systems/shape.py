"""The shape of a system's graph: who is tied to whom, and which nodes hold the parts together."""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node

Graph = Mapping[Hashable, Collection[Hashable]]
"""An undirected graph: each vertex with those beside it, both ways."""


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


def plain_graph(system: System) -> Graph:
    """Nodes (by ``id``) and the names that have both ends, undirected: linear in the endpoints, where an edge
    for each pair of nodes would be quadratic."""
    graph: dict[Hashable, dict[Hashable, None]] = {id(node): {} for node in system.nodes}
    for connection in connections(system):
        providers, users = ([e for e in ends if e.node.is_node] for ends in (connection.providers, connection.users))
        if providers and users:
            key = (connection.kind, connection.name)
            for end in (*providers, *users):
                graph.setdefault(key, {})[id(end.node)] = None
                graph.setdefault(id(end.node), {})[key] = None
    return graph


def components(graph: Graph) -> Iterator[frozenset[Hashable]]:
    """The parts of a graph whose vertices reach each other."""
    seen: set[Hashable] = set()
    for vertex in graph:
        if vertex not in seen:
            part = closure([vertex], graph.__getitem__)
            seen |= part
            yield part


def splits(system: System) -> list[tuple[Node, list[list[Node]]]]:
    """The nodes without which others fall into parts, with the parts.

    Parts of two nodes and more count, and there are two of them at least; or nobody is left connected at all, as
    in the smallest system, where one node stands between two.
    """
    graph = plain_graph(system)
    nodes: dict[Hashable, Node] = {id(node): node for node in system.nodes}
    points = []
    cuts = _cut_vertices(graph)
    for key in (key for key in nodes if key in cuts):
        parts = [[nodes[member] for member in part if member in nodes] for part in _parts_without(graph, key)]
        parts = [part for part in parts if part]
        counted = [part for part in parts if len(part) > 1] or parts
        if len(counted) > 1:
            points.append((nodes[key], counted))
    return sorted(points, key=lambda entry: entry[0].name or "")


def _parts_without(graph: Graph, cut: Hashable) -> Iterator[frozenset[Hashable]]:
    """What is left of the part of a graph that a vertex is in, in parts that nothing joins."""
    seen: set[Hashable] = set()
    for vertex in graph[cut]:
        if vertex not in seen:
            part = closure([vertex], lambda other_vertex: (other for other in graph[other_vertex] if other != cut))
            seen |= part
            yield part


def _cut_vertices(graph: Graph) -> set[Hashable]:
    """The vertices without which a part of the graph falls apart: those from which a search goes on to something that
    leads to nothing it met before."""
    cuts: set[Hashable] = set()
    order: dict[Hashable, int] = {}
    lowest: dict[Hashable, int] = {}  # the earliest vertex that each one leads to, past the one that was before it
    for start in graph:
        if start in order:
            continue
        order[start] = lowest[start] = len(order)
        branches = 0
        path = [(start, start, iter(graph[start]))]
        while path:
            vertex, before, rest = path[-1]
            other = next(rest, None)
            if other is None:
                path.pop()
                lowest[before] = min(lowest[before], lowest[vertex])
                if before == start:
                    branches += vertex != start
                elif lowest[vertex] >= order[before]:
                    cuts.add(before)
            elif other not in order:
                order[other] = lowest[other] = len(order)
                path.append((other, vertex, iter(graph[other])))
            elif other != before:
                lowest[vertex] = min(lowest[vertex], order[other])
        if branches > 1:
            cuts.add(start)
    return cuts


__all__ = ["Graph", "components", "connected", "connections", "plain_graph", "splits"]
