"""The data of a page: what each system has, and where it stands in the picture.

Nodes and ends are described in the words of ``archlint graph --format json``; what is null there is left out here.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from archlint.render import look
from archlint.render.definitions import interfaces, launch_arguments
from archlint.render.diagram.findings import attached
from archlint.render.diagram.grouping import titles_of
from archlint.render.diagram.marks import marked
from archlint.render.diagram.parts import parts_of
from archlint.render.json import endpoint_data, node_data, unresolved
from archlint.render.page.found import FindingIndex, finding_data
from archlint.render.page.places import Drawing, Line, Shape, place
from archlint.render.picture import graph_of
from archlint.systems.graph import NODE, Key
from archlint.visible import visible

if TYPE_CHECKING:
    import networkx

    from archlint.render.diagram.model import Shape as DrawnShape
    from archlint.render.page.model import PageContents, PageSystem
    from archlint.systems.nodes import Node

VERSION = 1
_GROUPS = {"launch": "launched_by"}
"""What groups are made of, as the JSON of the graph calls it."""
_ENDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")


def page_data(contents: PageContents) -> dict[str, Any]:
    """All that the scripts of the page work with."""
    systems = [_system(shown, FindingIndex(contents.findings, shown)) for shown in contents.systems]
    group = None if contents.group is None else _GROUPS.get(contents.group, contents.group)
    for system in systems:
        titles = {str(vertex.get(group or "group", "")) for vertex in system["vertices"]}
        system["collapsed"] = sorted(titles_of(titles, contents.collapse))
    return {
        "version": VERSION,
        "source_link": None if contents.link is None else asdict(contents.link),
        "group": group,
        "systems": systems,
        "findings": [finding_data(finding) for finding in contents.findings],
        "interfaces": _used_interfaces(contents, systems),
    }


def _system(shown: PageSystem, index: FindingIndex) -> dict[str, Any]:
    system = shown.system
    graph = graph_of(system)
    numbers = {key: number for number, key in enumerate(graph.nodes)}
    titles = look.groups(graph)
    badges = attached(graph, index.here)
    marks = marked(parts_of(system, graph), system, badges).shapes
    vertices = [
        {**_vertex(data, index), **_marks(marks[key]), "group": titles.get(key, ""), "label": _label(data, marks[key])}
        for key, data in graph.nodes(data=True)
    ]
    for key, findings in badges.shapes.items():
        vertex = vertices[numbers[key]]
        vertex["findings"] = sorted({*vertex.get("findings", ()), *index.of_badges(findings)})
    edges = _edges(graph, numbers, index)
    for edge in edges:
        interface = vertices[edge["head"] if vertices[edge["tail"]]["kind"] == NODE else edge["tail"]]
        here = {number for end in edge["ends"] for number in end.get("findings", ())}
        if here:
            interface["findings"] = sorted(here.union(interface.get("findings", ())))
    drawing = place(
        [Shape(vertex["kind"] == NODE, tuple(vertex["label"]), vertex["group"]) for vertex in vertices],
        [Line(edge["tail"], edge["head"]) for edge in edges],
    )
    return {
        "name": system.name,
        "title": visible(shown.title),
        "caption": look.counts(graph),
        "vertices": vertices,
        "edges": edges,
        "drawing": None if drawing is None else _drawing_data(drawing),
        "launch_arguments": [*map(known_keys, launch_arguments(system))],
        "unresolved": [*map(known_keys, unresolved(system))],
        "findings": index.elsewhere(),
    }


def _vertex(data: dict[str, Any], index: FindingIndex) -> dict[str, Any]:
    if data["kind"] != NODE:
        about = {key: data[key] for key in ("name", "types", "error") if data[key]}
        resolution = {} if data["resolution"] == "exact" else {"resolution": data["resolution"]}
        return {"kind": data["kind"], **about, "matched": data["matched"], **_look_of(data), **resolution}
    node: Node = data["node"]
    described = {key: value for key, value in node_data(node).items() if key not in _ENDS}
    numbers = index.of_node(node)
    return {
        "kind": NODE,
        **known_keys(described),
        "namespace": (node.name or "").rpartition("/")[0] or "/",
        **_look_of(data),
        **({"findings": numbers} if numbers else {}),
    }


def _look_of(data: dict[str, Any]) -> dict[str, Any]:
    """Which of the colours of :data:`look.PALETTE` a vertex has, if not that of its kind."""
    if data.get("observed"):
        return {"look": data["observed"]}
    if data["error"] if data["kind"] != NODE else data["node"].error:
        return {"look": "wrong"}
    if data["kind"] != NODE:
        return {"look": "wrong"} if len(data["types"]) > 1 else {}
    return {"look": "aside"} if look.is_aside(data["node"]) or data["neighbour"] else {}


def _label(data: dict[str, Any], shape: DrawnShape) -> list[str]:
    return [*look.vertex_label(data).split("\n"), *shape.remarks]


def _marks(shape: DrawnShape) -> dict[str, Any]:
    """What other pictures say of it, too: that it is a hub, where its package lies, and in which process it runs."""
    groups = {"folder": shape.groups.get("folder", ""), "process": shape.groups.get("process", "")}
    return known_keys({"remarks": list(shape.remarks), **groups})


def _edges(graph: networkx.MultiDiGraph, numbers: dict[Key, int], index: FindingIndex) -> list[dict[str, Any]]:
    """A line for each pair of vertices in each direction, with the ends that it stands for."""
    edges: dict[tuple[int, int], list[dict[str, Any]]] = {}
    for tail, head, edge in graph.edges(data=True):
        edges.setdefault((numbers[tail], numbers[head]), []).append(_end(edge, index))
    remapped = {(numbers[tail], numbers[head]) for tail, head in graph.graph["remapped"]}
    lines = [{"tail": tail, "head": head, "ends": ends} for (tail, head), ends in edges.items()]
    return [*lines, *({"tail": tail, "head": head, "ends": []} for tail, head in sorted(remapped - edges.keys()))]


def _end(edge: dict[str, Any], index: FindingIndex) -> dict[str, Any]:
    endpoint = edge["endpoint"]
    numbers = index.of_end(endpoint)
    more = {"broken": edge["broken"], "observed": edge.get("observed"), "remark": edge.get("remark")}
    said = {key: value for key, value in more.items() if value}
    described = {key: value for key, value in known_keys(endpoint_data(endpoint)).items() if key != "name"}
    return {"kind": endpoint.kind, **described, **said, **({"findings": numbers} if numbers else {})}


def _drawing_data(drawing: Drawing) -> dict[str, Any]:
    return {
        "boxes": [[*map(_rounded, box)] for box in drawing.boxes],
        "paths": [None if path is None else [*map(_rounded, path)] for path in drawing.paths],
    }


def _rounded(number: float) -> float:
    return round(number, 1)


def known_keys(described: dict[str, Any]) -> dict[str, Any]:
    """Without what is null, empty or false: a page may have tens of thousands of such keys."""
    return {key: value for key, value in described.items() if value is not False and value not in (None, "", [], {})}


def _used_interfaces(contents: PageContents, systems: list[dict[str, Any]]) -> dict[str, Any]:
    """The definitions of the workspace's types that the systems use."""
    used = {name for system in systems for vertex in system["vertices"] for name in vertex.get("types", ())}
    rows = interfaces(contents.systems[0].system) if contents.systems else []
    return {row["name"]: row for row in rows if row["name"] in used}


__all__ = ["page_data"]
