"""The graph as a Mermaid flowchart, for Markdown that is shown on GitHub or GitLab.

Ids are made up; ``"`` and ``#`` are written as Mermaid's own entities, so that no name ends a label.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from archlint.observed.model import MISSING
from archlint.render import look
from archlint.render.picture import graph_of
from archlint.systems.graph import NODE, Key
from archlint.systems.model import System
from archlint.visible import visible

if TYPE_CHECKING:
    import networkx

EDGE_LIMIT = 500
"""Mermaid draws no more edges than this unless its site says so (``maxEdges``)."""

TEXT_LIMIT = 50_000
"""Nor does it read more characters (``maxTextSize``)."""

_ADVICE = "draw one package, or use svg"
_SHAPES = {"node": ('(["', '"])'), "topic": ('["', '"]'), "service": ('{{"', '"}}'), "action": ('[["', '"]]')}


def render(system: System) -> str:
    graph = graph_of(system)
    ids = {key: f"n{number}" for number, key in enumerate(graph.nodes)}
    edges = list(_edges(graph, ids))
    lines = ["flowchart LR", *_vertices(graph, ids), *edges, *_styles(graph, ids), *_coloured_lines(graph)]
    text = "\n".join(lines) + "\n"
    if len(edges) > EDGE_LIMIT:
        return f"%% {len(edges)} edges, and Mermaid draws {EDGE_LIMIT}: {_ADVICE}\n{text}"
    if len(text) > TEXT_LIMIT:
        return f"%% {len(text)} characters, and Mermaid reads {TEXT_LIMIT}: {_ADVICE}\n{text}"
    return text


def escape(text: str) -> str:
    """``text`` for the inside of a quoted label; a newline becomes a line break."""
    shown = "\n".join(visible(line) for line in text.split("\n"))
    for char, entity in (("#", "#35;"), ("&", "#amp;"), ('"', "#quot;"), ("<", "#lt;"), (">", "#gt;")):
        shown = shown.replace(char, entity)
    return shown.replace("`", "#96;").replace("\n", "<br>")


def _vertices(graph: networkx.MultiDiGraph, ids: dict[Key, str]) -> Iterator[str]:
    groups = look.groups(graph)
    for number, title in enumerate(sorted(set(groups.values()))):
        yield f'  subgraph g{number}["{escape(title)}"]'
        yield from (f"  {_vertex(graph, key, ids)}" for key in graph.nodes if groups.get(key) == title)
        yield "  end"
    yield from (_vertex(graph, key, ids) for key in graph.nodes if key not in groups)


def _vertex(graph: networkx.MultiDiGraph, key: Key, ids: dict[Key, str]) -> str:
    data = graph.nodes[key]
    label = look.vertex_label(data)
    before, after = _SHAPES[data["kind"]]
    return f"  {ids[key]}{before}{escape(label)}{after}"


def _edges(graph: networkx.MultiDiGraph, ids: dict[Key, str]) -> Iterator[str]:
    for bundle in look.bundles(graph):
        interface = graph.nodes[bundle.tail if bundle.tail[0] != NODE else bundle.head]
        arrow = "-->" if interface["matched"] and not bundle.conditional else "-.->"
        if bundle.broken:
            arrow = f'--x|"{escape(bundle.broken)}"|'
        if bundle.observed:
            line = "-.->" if bundle.observed == MISSING else "-->"
            arrow = f'{line}|"{escape(bundle.remark)}"|' if bundle.remark else line
        yield f"  {ids[bundle.tail]} {arrow} {ids[bundle.head]}"
    for node, interface in graph.graph["remapped"]:
        yield f"  {ids[node]} -.- {ids[interface]}"


def _coloured_lines(graph: networkx.MultiDiGraph) -> Iterator[str]:
    """Mermaid styles a line by its number."""
    numbers: dict[str, list[str]] = {}
    for number, bundle in enumerate(look.bundles(graph)):
        mark = bundle.observed or ("wrong" if bundle.broken else "")
        numbers.setdefault(mark, []).append(str(number))
    for style, colours in look.PALETTE.items():
        if style in numbers:
            yield f"  linkStyle {','.join(numbers[style])} stroke:{colours.line},color:{colours.line}"


def _styles(graph: networkx.MultiDiGraph, ids: dict[Key, str]) -> Iterator[str]:
    members: dict[str, list[str]] = {}
    for key, data in graph.nodes(data=True):
        members.setdefault(_style(data), []).append(ids[key])
    for name, colours in look.PALETTE.items():
        if name in members:
            yield f"  classDef {name} fill:{colours.fill},stroke:{colours.line},color:{colours.text}"
            yield f"  class {','.join(members[name])} {name}"


def _style(data: dict[str, Any]) -> str:
    if data.get("observed"):
        return str(data["observed"])
    if data["kind"] == NODE:
        node = data["node"]
        return "wrong" if node.error else "aside" if look.is_aside(node) or data["neighbour"] else "node"
    return "wrong" if data["error"] or len(data["types"]) > 1 else str(data["kind"])
