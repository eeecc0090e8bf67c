"""The graph in Graphviz' language.

Every id is made up here and every text of the user's is in a quoted string, so that no name can become
markup, a port or an escape of Graphviz.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from archlint.observed.model import MISSING
from archlint.render import look, overview
from archlint.render.picture import graph_of
from archlint.systems.graph import NODE, Key
from archlint.systems.model import System
from archlint.visible import visible

if TYPE_CHECKING:
    import networkx

CAREFUL_LAYOUT = 300
"""Vertices up to which ``dot`` takes all the time it wants (0.2 s for 200, 27 s for 1000 on one machine)."""

_SHAPES = {"topic": "box", "service": "hexagon", "action": "octagon"}
_ARROWS = {"topic": "normal", "service": "vee", "action": "vee"}
_HURRY = {"nslimit": "1", "nslimit1": "1", "mclimit": "0.1", "splines": "line"}

REMAPPED = {
    "color": look.PALETTE["aside"].line,
    "dir": "none",
    "style": "dashed",
    "tooltip": "remapped by the launch file; without the source the direction is unknown",
}
"""How the line from a node to a name is drawn of which no more is known."""


def render(system: System) -> str:
    return write(graph_of(system))


def write(graph: networkx.MultiDiGraph, **attributes: str) -> str:
    """``attributes`` are those of the whole graph, such as ``dpi``."""
    ids = {key: f"n{number}" for number, key in enumerate(graph.nodes)}
    attributes = {
        **(_HURRY if len(graph) > CAREFUL_LAYOUT else {}),
        "label": look.caption(graph),
        **attributes,
    }
    return _digraph(attributes, [*_vertices(graph, ids), *_edges(graph, ids)])


def write_overview(graph: networkx.MultiDiGraph, **attributes: str) -> str:
    """As :func:`write`, with one box for each group of nodes."""
    attributes = {"label": f"{look.counts(graph)}  ·  too many to draw each", **attributes}
    return _digraph(attributes, [*_boxes(graph)])


def _digraph(attributes: dict[str, str], body: list[str]) -> str:
    return "\n".join(["digraph archlint {", *_defaults(attributes), *body, "}"]) + "\n"


def _boxes(graph: networkx.MultiDiGraph) -> Iterator[str]:
    colours = look.PALETTE["node"]
    ids: dict[str, str] = {}
    for title, size in overview.box_sizes(graph).items():
        ids[title] = f"n{len(ids)}"
        box = {
            "label": f"{title or 'others'}\n{look.counted(size, 'helper' if title == look.UNOWNED else 'node')}",
            "shape": "box",
            "style": "rounded,filled",
            "fillcolor": colours.fill,
            "color": colours.line,
            "fontcolor": colours.text,
            "margin": "0.2,0.11",
        }
        yield f"  {ids[title]} {_attributes(box)};"
    for (tail, head), kinds in overview.streams(graph).items():
        stream = {"label": overview.words(kinds), "fontsize": "9", "color": look.PALETTE["topic"].line}
        yield f"  {ids[tail]} -> {ids[head]} {_attributes(stream)};"


def quote(text: str) -> str:
    """``text`` as a quoted string that Graphviz shows as it is."""
    shown = "\n".join(visible(line) for line in text.split("\n"))
    escaped = shown.replace("\\", "\\\\").replace('"', '\\"').replace("&", "&amp;").replace("\n", "\\n")
    return f'"{escaped}"'


def _attributes(values: dict[str, str]) -> str:
    return "[" + ", ".join(f"{name}={quote(value)}" for name, value in values.items()) + "]"


def _defaults(attributes: dict[str, str]) -> Iterator[str]:
    defaults = {
        "rankdir": "LR",
        "bgcolor": "white",
        "pad": "0.3",
        "nodesep": "0.28",
        "ranksep": "0.6",
        "fontname": look.FONT,
        "fontsize": "10",
        "fontcolor": "#64748b",
        "labelloc": "b",
        "labeljust": "l",
    }
    yield f"  graph {_attributes(defaults | attributes)};"
    shape = {"fontname": look.FONT, "style": "filled", "margin": "0.14,0.07", "height": "0.3"}
    yield f"  node {_attributes(shape)};"
    yield f"  edge {_attributes({'fontname': look.FONT, 'arrowsize': '0.7', 'penwidth': '1.2'})};"


def _vertices(graph: networkx.MultiDiGraph, ids: dict[Key, str]) -> Iterator[str]:
    groups = look.groups(graph)
    titles = sorted(set(groups.values()))
    for number, title in enumerate(titles):
        frame = {
            "label": title,
            "style": "rounded,filled",
            "fillcolor": "#f8fafc",
            "color": "#cbd5e1",
            "fontsize": "11",
            "margin": "14",
            "labelloc": "t",
        }
        yield f"  subgraph cluster_{number} {{"
        yield f"    graph {_attributes(frame)};"
        yield from (f"  {_vertex(graph, key, ids)}" for key in graph.nodes if groups.get(key) == title)
        yield "  }"
    yield from (_vertex(graph, key, ids) for key in graph.nodes if key not in groups)


def _vertex(graph: networkx.MultiDiGraph, key: Key, ids: dict[Key, str]) -> str:
    return f"  {ids[key]} {_attributes(vertex(graph.nodes[key]))};"


def vertex(data: dict[str, Any]) -> dict[str, str]:
    """How a vertex is drawn, as attributes of Graphviz."""
    return _observed(_node(data) if data["kind"] == NODE else _interface(data), data)


def _observed(drawn: dict[str, str], data: dict[str, Any]) -> dict[str, str]:
    """A vertex that is otherwise when the system runs, in the colours that say so."""
    status = data.get("observed")
    if not status:
        return drawn
    colours = look.PALETTE[status]
    return drawn | {
        "style": drawn["style"].replace(",dashed", "") + (",dashed" if status == "missing" else ""),
        "fillcolor": colours.fill,
        "color": colours.line,
        "fontcolor": colours.text,
    }


def _node(data: dict[str, Any]) -> dict[str, str]:
    node = data["node"]
    aside = look.is_aside(node) or data["neighbour"]
    colours = look.PALETTE["wrong" if node.error else "aside" if aside else "node"]
    return {
        "label": look.vertex_label(data),
        "tooltip": look.node_details(node),
        "shape": "box",
        "style": "rounded,filled" + (",dashed" if aside else ""),
        "fillcolor": colours.fill,
        "color": colours.line,
        "fontcolor": colours.text,
        "fontsize": "13",
        "penwidth": "1.6",
        "margin": "0.2,0.11",
    }


def _interface(data: dict[str, Any]) -> dict[str, str]:
    kind = data["kind"]
    wrong = data["error"] or len(data["types"]) > 1
    colours = look.PALETTE["wrong" if wrong else kind]
    drawn = {
        "label": look.vertex_label(data),
        "tooltip": look.interface_details(data),
        "shape": _SHAPES[kind],
        "style": "filled" if data["matched"] else "filled,dashed",
        "fillcolor": colours.fill if data["matched"] else "#ffffff",
        "color": colours.line,
        "fontcolor": colours.text,
        "fontsize": "10",
    }
    return drawn if kind == "topic" else {**drawn, "margin": "0,0", "height": "0"}


def _observed_line(bundle: look.Bundle) -> dict[str, str]:
    colour = look.PALETTE[bundle.observed].line
    drawn = {"color": colour, "penwidth": "1.8", "style": "dashed" if bundle.observed == MISSING else "solid"}
    return drawn | ({"label": bundle.remark, "fontsize": "9", "fontcolor": colour} if bundle.remark else {})


def _edges(graph: networkx.MultiDiGraph, ids: dict[Key, str]) -> Iterator[str]:
    """One line between two vertices for each direction, however many endpoints it stands for."""
    for bundle in look.bundles(graph):
        yield f"  {ids[bundle.tail]} -> {ids[bundle.head]} {_attributes(line(graph, bundle))};"
    for node, interface in graph.graph["remapped"]:
        yield f"  {ids[node]} -> {ids[interface]} {_attributes(REMAPPED)};"


def line(graph: networkx.MultiDiGraph, bundle: look.Bundle) -> dict[str, str]:
    """How the line of some endpoints is drawn, as attributes of Graphviz."""
    interface = bundle.tail if bundle.tail[0] != NODE else bundle.head
    colours = look.PALETTE["wrong" if bundle.broken else interface[0]]
    matched = graph.nodes[interface]["matched"]
    drawn = {
        "color": colours.line,
        "arrowhead": "none" if bundle.broken else _ARROWS[interface[0]],
        "style": "dotted" if bundle.conditional else "solid" if matched and not bundle.broken else "dashed",
        "tooltip": bundle.details,
    }
    if bundle.broken:
        drawn |= {"label": f"✕ {bundle.broken}", "fontsize": "9", "fontcolor": colours.line, "penwidth": "1.8"}
    return drawn | (_observed_line(bundle) if bundle.observed else {})
