"""Marks in a graph that is drawn how the running system differs from it, and adds what only that has.

A vertex or an edge that differs has ``observed`` (``missing``, ``unexpected`` or ``different``); ``remark`` is what to
write at an edge.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from archlint.model import Blueprint, Creation, EntityKind, ExecutorKind, Text
from archlint.observed.model import DIFFERENT, MISSING, UNEXPECTED, Comparison, Difference, SeenEnd, SeenNode
from archlint.ros.names import is_hidden
from archlint.systems.graph import INTERFACE_OF, NODE, TOPIC, Key, interface_key
from archlint.systems.implicit import implicit_names
from archlint.systems.nodes import Endpoint, NamedCreation, Node
from archlint.systems.resolution import FinalName

if TYPE_CHECKING:
    import networkx

    from archlint.finding import Place
    from archlint.observed.model import Status
    from archlint.systems.model import System

_PACKAGE = re.compile(r"^\w+/(msg|srv|action)/")
"""What a picture leaves out of a type."""
_TOWARDS_NODE = (EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.ACTION_SERVER)


def mark(graph: networkx.MultiDiGraph, system: System, compared: Comparison) -> None:
    graph.graph["compared"] = compared.observed.file
    for difference in compared.differences:
        if difference.kind == NODE:
            _mark_node(graph, system, difference)
        elif difference.kind == TOPIC:
            _interface(graph, (TOPIC, difference.name), difference.observed or None)
        else:
            _mark_end(graph, difference)


def _mark_node(graph: networkx.MultiDiGraph, system: System, difference: Difference) -> None:
    key = (NODE, difference.name)
    if isinstance(difference.seen, SeenNode):
        _add_node(graph, system, difference.seen)
    elif key in graph:
        graph.nodes[key]["observed"] = MISSING if difference.status == MISSING else DIFFERENT
        for *_, edge in _edges_at(graph, key) if difference.status == MISSING else ():
            edge["observed"], edge["remark"] = MISSING, ""  # the node says it


def _mark_end(graph: networkx.MultiDiGraph, difference: Difference) -> None:
    key = (NODE, difference.node or "")
    if key not in graph:  # not shown
        return
    for *_, edge in _edges_at(graph, key):
        if edge["kind"] == difference.kind and edge["endpoint"].name == difference.name:
            edge["observed"], edge["remark"] = difference.status, _remark(difference)
    seen = difference.seen
    if isinstance(seen, SeenEnd) and (difference.status == UNEXPECTED or seen.name != difference.name):
        _add_end(graph, key, graph.nodes[key]["node"], seen, difference.status, difference.place, difference.status)


def _edges_at(graph: networkx.MultiDiGraph, key: Key) -> list[tuple[Key, Key, dict[str, Any]]]:
    return [*graph.in_edges(key, data=True), *graph.out_edges(key, data=True)]


def _remark(difference: Difference) -> str:
    short = _PACKAGE.sub("", difference.observed)
    return f"{difference.status}: {short}" if difference.status == DIFFERENT else difference.status


def _add_node(graph: networkx.MultiDiGraph, system: System, seen: SeenNode) -> None:
    """A node that runs and that the source does not have, with what it is an end of."""
    node = Node(seen.name, None, None, None, ExecutorKind.UNKNOWN, external=True, launch_place=seen.place)
    key = (NODE, seen.name)
    graph.add_node(key, kind=NODE, name=seen.name, resolution="exact", node=node, neighbour=False, observed=UNEXPECTED)
    of_ros = implicit_names(system)
    for end in seen.ends:
        if not is_hidden(end.name) and end.name not in of_ros and not end.name.startswith(f"{seen.name}/"):
            _add_end(graph, key, node, end, UNEXPECTED, seen.place, "")  # the node says it


def _add_end(
    graph: networkx.MultiDiGraph, key: Key, node: Node, seen: SeenEnd, status: Status, place: Place, remark: str
) -> None:
    blueprint = node.blueprint or Blueprint("", Text(node.name, "exact"), Text("/", "exact"), place, None)
    creation = Creation(seen.kind, "observed", blueprint, place, Text(seen.name, "exact"), seen.type, qos=seen.qos)
    endpoint = Endpoint(node, NamedCreation(creation, FinalName(seen.name)))
    interface = interface_key(endpoint)
    _interface(graph, interface, seen.type)
    ends = (interface, key) if seen.kind in _TOWARDS_NODE else (key, interface)
    graph.add_edge(
        *ends,
        kind=seen.kind,
        type=seen.type,
        file=place.file,
        line=place.line,
        endpoint=endpoint,
        broken="",
        observed=status,
        remark=remark,
    )


def _interface(graph: networkx.MultiDiGraph, key: Key, type_: str | None) -> None:
    """A topic, service or action that is only there when the system runs; one that is in the graph stays as it is."""
    assert key[0] in INTERFACE_OF.values()
    if key in graph:
        return
    types = [type_] if type_ else []
    graph.add_node(
        key, kind=key[0], name=key[1], resolution="exact", types=types, matched=True, error=None, observed=UNEXPECTED
    )
