"""The parts of a picture of a whole system: a shape for each node and interface, a line for each bundle of ends."""

from __future__ import annotations

import posixpath
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.observed.model import MISSING
from archlint.render import look
from archlint.render.diagram.model import Diagram, Key, Line, Shape, Stroke, Tone
from archlint.render.diagram.namesakes import told_apart
from archlint.render.diagram.traffic import qos_of_users, qos_offered, traffic_words
from archlint.systems.graph import NODE, TOPIC
from archlint.systems.rates import rates

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    import networkx

    from archlint.render.view import GroupBy
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node


def parts_of(system: System, graph: networkx.MultiDiGraph) -> Diagram:
    """Of :func:`archlint.render.picture.graph_of`."""
    frequency = rates(system)
    shapes: dict[Key, Shape] = {}
    offered: dict[Key, Sequence[str]] = {}
    for key, data in graph.nodes(data=True):
        ends = [edge["endpoint"] for edge in _edges_at(graph, key)]
        shapes[key] = _node(key, data) if data["kind"] == NODE else _interface(key, data, ends, frequency)
        if key[0] == TOPIC:
            offered[key] = qos_offered(ends)
    shapes |= told_apart(shapes, {key: graph.nodes[key]["node"] for key in shapes if key[0] == NODE})
    lines = [_line(graph, bundle, offered) for bundle in look.bundles(graph)]
    lines += [_remapped(node, interface) for node, interface in graph.graph["remapped"]]
    return Diagram(_from_common_folder(shapes), tuple(lines), cut=graph.graph["cut"])


def _edges_at(graph: networkx.MultiDiGraph, key: Key) -> Iterable[dict[str, Any]]:
    yield from (edge for _, _, edge in graph.in_edges(key, data=True))
    yield from (edge for _, _, edge in graph.out_edges(key, data=True))


def _node(key: Key, data: dict[str, Any]) -> Shape:
    node: Node = data["node"]
    title, *lines = look.vertex_label(data).split("\n")
    aside = look.is_aside(node) or data["neighbour"]
    tone: Tone = "wrong" if node.error else "aside" if aside else "node"
    stroke: Stroke = "dashed" if aside else "solid"
    return Shape(
        key,
        "node",
        title,
        tuple(lines),
        tone=data.get("observed") or tone,
        stroke=_stroke(data, stroke),
        details=tuple(look.node_details(node).split("\n")),
        neighbour=data["neighbour"],
        helper=not node.is_node,
        groups=_groups(node),
    )


def _groups(node: Node) -> Mapping[GroupBy, str]:
    container = node.started.container if node.started is not None else None
    process = container.text if container is not None and container.text else node.executable
    return {
        "namespace": (node.name or "").rpartition("/")[0],
        "package": node.package or "",
        "folder": _folder(node),
        "launch": node.launched_by or "",
        "process": f"{node.package}/{process}" if node.package and process and container is None else process or "",
    }


def _folder(node: Node) -> str:
    """The folder that its package lies in, where the package's own folder is called as it is."""
    parts = node.blueprint.place.file.split("/") if node.blueprint is not None else []
    return "/".join(parts[: parts.index(node.package)]) if node.package in parts else ""


def _from_common_folder(shapes: Mapping[Key, Shape]) -> dict[Key, Shape]:
    """The shapes with the folders of nodes as they are seen from the one that all of these are in."""
    folders = {shape.groups["folder"] for shape in shapes.values() if shape.groups.get("folder")}
    common = posixpath.commonpath(folders) if len(folders) > 1 else ""
    if not common:
        return {**shapes}
    return {
        key: replace(shape, groups={**shape.groups, "folder": posixpath.relpath(shape.groups["folder"], common)})
        if shape.groups.get("folder")
        else shape
        for key, shape in shapes.items()
    }


def _interface(key: Key, data: dict[str, Any], ends: list[Endpoint], frequency: Mapping[int, float]) -> Shape:
    title, *lines = look.vertex_label(data).split("\n")
    if data["kind"] == TOPIC:
        lines += traffic_words(ends, frequency)
    wrong = data["error"] or len(data["types"]) > 1
    return Shape(
        key,
        data["kind"],
        title,
        tuple(lines),
        tone=data.get("observed") or ("wrong" if wrong else data["kind"]),
        stroke=_stroke(data, "solid" if data["matched"] else "dashed"),
        details=tuple(look.interface_details(data).split("\n")),
        matched=data["matched"],
    )


def _stroke(data: dict[str, Any], otherwise: Stroke) -> Stroke:
    if not data.get("observed"):
        return otherwise
    return "dashed" if data["observed"] == MISSING else "solid"


def _line(graph: networkx.MultiDiGraph, bundle: look.Bundle, offered: Mapping[Key, Sequence[str]]) -> Line:
    interface = bundle.tail if bundle.tail[0] != NODE else bundle.head
    matched = graph.nodes[interface]["matched"]
    stroke: Stroke = "dotted" if bundle.conditional else "solid" if matched and not bundle.broken else "dashed"
    if bundle.observed:
        stroke = "dashed" if bundle.observed == MISSING else "solid"
    labels = [bundle.remark] if bundle.remark else []
    if interface[0] == TOPIC and bundle.tail == interface and not bundle.broken:
        users = [edge["endpoint"] for edge in graph.get_edge_data(bundle.tail, bundle.head).values()]
        labels += qos_of_users(offered[interface], users)
    return Line(
        bundle.tail,
        bundle.head,
        graph.nodes[interface]["kind"],
        tuple(labels),
        broken=bundle.broken,
        held_back=bundle.held_back,
        tone=bundle.observed or ("wrong" if bundle.broken else graph.nodes[interface]["kind"]),
        stroke=stroke,
        details=tuple(bundle.details.split("\n")),
        differs=bool(bundle.observed),
    )


def _remapped(node: Key, interface: Key) -> Line:
    return Line(
        node,
        interface,
        interface[0],  # type: ignore[arg-type]  # a key's first part is its kind
        tone="aside",
        stroke="dashed",
        directed=False,
        details=("remapped by the launch file; without the source the direction is unknown",),
    )


__all__ = ["parts_of"]
