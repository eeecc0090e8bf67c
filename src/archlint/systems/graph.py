"""A system as a networkx graph: nodes on one side, topics, services and actions on the other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model as program
from archlint.systems.externals import connections_of_externals
from archlint.systems.implicit import implicit_names
from archlint.systems.model import System
from archlint.systems.nodes import Endpoint, Node

if TYPE_CHECKING:
    import networkx

NODE = "node"
TOPIC = "topic"
SERVICE = "service"
ACTION = "action"

INTERFACE_OF = {
    program.EntityKind.PUBLISHER: TOPIC,
    program.EntityKind.SUBSCRIBER: TOPIC,
    program.EntityKind.SERVICE: SERVICE,
    program.EntityKind.CLIENT: SERVICE,
    program.EntityKind.ACTION_SERVER: ACTION,
    program.EntityKind.ACTION_CLIENT: ACTION,
}
"""What each kind of endpoint is an end of."""

PROVIDERS = (program.EntityKind.PUBLISHER, program.EntityKind.SERVICE, program.EntityKind.ACTION_SERVER)
_TOWARDS_NODE = (program.EntityKind.SUBSCRIBER, program.EntityKind.SERVICE, program.EntityKind.ACTION_SERVER)

Key = tuple[str, str]
"""``(kind, name)``; what has no name goes by its class or kind and its place."""


def to_networkx(system: System) -> networkx.MultiDiGraph:
    """Edges run with the data (publisher → topic → subscriber) or the request (client → service → server).

    Vertices are :data:`Key`; each has ``kind``, ``name`` and ``resolution``, those of interfaces also
    ``types``, ``matched`` (somebody at either end, be it without saying so) and ``error``, those of nodes
    ``node``, which may also be an entry that is none (:attr:`Node.is_node`), and ``neighbour`` (not asked for).
    Each edge has its ``endpoint``.  ``graph.graph["remapped"]`` are the lines between external nodes and the names
    that they are remapped to.  Vertices and edges are in the order of names, the same on every run.
    """
    import networkx

    graph = networkx.MultiDiGraph(name=system.name or "")
    keys = node_keys(system)
    neighbours = {id(node) for node in system.neighbours}
    for node in system.drawn:
        graph.add_node(
            keys[id(node)],
            kind=NODE,
            name=node.name,
            resolution=node.resolution,
            node=node,
            neighbour=id(node) in neighbours,
        )
    implicit = implicit_names(system)
    for key, endpoints in sorted(_interfaces(system).items()):
        attributes = _interface_attributes(key, endpoints)
        attributes["matched"] = attributes["matched"] or attributes["name"] in implicit
        graph.add_node(key, **attributes)
    for node in system.drawn:
        for endpoint in node.endpoints:
            ends = (keys[id(node)], interface_key(endpoint))
            graph.add_edge(
                *(reversed(ends) if endpoint.kind in _TOWARDS_NODE else ends),
                kind=endpoint.kind,
                type=endpoint.type,
                file=endpoint.place.file,
                line=endpoint.place.line,
                endpoint=endpoint,
            )
    graph.graph["remapped"] = _remapped(system, graph, keys)
    return graph


def _remapped(system: System, graph: networkx.MultiDiGraph, keys: dict[int, Key]) -> list[tuple[Key, Key]]:
    """External nodes and the interfaces that a launch file remaps them to: lines without a direction."""
    lines = []
    for node, name in connections_of_externals(system):
        interfaces = [key for key in ((kind, name) for kind in (TOPIC, SERVICE, ACTION)) if key in graph]
        if not interfaces:
            interfaces = [(TOPIC, name)]
            graph.add_node((TOPIC, name), kind=TOPIC, name=name, resolution="exact", types=[], matched=True, error=None)
        for key in interfaces:
            graph.nodes[key]["matched"] = True  # the external node may be its other end
            lines.append((keys[id(node)], key))
    return lines


def node_keys(system: System) -> dict[int, Key]:
    """The vertex of each node, by ``id(node)``; more nodes of one name are numbered."""
    keys: dict[int, Key] = {}
    taken: set[Key] = set()
    for node in system.drawn:
        key: Key = (NODE, node.name or _where(node))
        number = 2
        while key in taken:
            key = (NODE, f"{node.name or _where(node)} #{number}")
            number += 1
        taken.add(key)
        keys[id(node)] = key
    return keys


def _where(node: Node) -> str:
    if node.blueprint is None:
        return f"{node.package or ''}/{node.executable or ''}"
    return f"{node.blueprint.class_name} ({node.blueprint.place.file}:{node.blueprint.place.line})"


def interface_key(endpoint: Endpoint) -> Key:
    """The vertex that an endpoint is connected to; without a known name it has one of its own."""
    place = endpoint.place
    name = endpoint.name or f"? ({place.file}:{place.line}:{place.column} {endpoint.kind})"
    return (INTERFACE_OF[endpoint.kind], name)


def _interfaces(system: System) -> dict[Key, list[Endpoint]]:
    ends: dict[Key, list[Endpoint]] = {}
    for endpoint in (end for node in system.drawn for end in node.endpoints):
        ends.setdefault(interface_key(endpoint), []).append(endpoint)
    return ends


def _interface_attributes(key: Key, endpoints: list[Endpoint]) -> dict[str, object]:
    first = endpoints[0]
    provided = any(endpoint.kind in PROVIDERS for endpoint in endpoints)
    used = any(endpoint.kind not in PROVIDERS for endpoint in endpoints)
    return {
        "kind": key[0],
        "name": first.name,
        "resolution": first.resolution,
        "types": sorted({endpoint.type for endpoint in endpoints if endpoint.type is not None}),
        "matched": provided and used,
        "error": next((endpoint.error for endpoint in endpoints if endpoint.error), None),
    }
