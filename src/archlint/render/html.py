"""The graph as one page for a browser: the drawing, with search and with what is behind each line.

The page asks the network for nothing.  Its policy admits this script and this style alone, by their hashes;
the data are in a JSON block in which no ``<`` can end it.
"""

from __future__ import annotations

import base64
import hashlib
import html
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text
from archlint.render import columns, dot, drawing, look
from archlint.render.diagram.captions import captioned, pattern_words
from archlint.render.diagram.grouping import grouped
from archlint.render.diagram.ids import ids_of
from archlint.render.diagram.parts import parts_of
from archlint.render.errors import NoGraphviz
from archlint.render.html_parts import SCRIPT, STYLE
from archlint.render.picture import graph_of
from archlint.systems.graph import NODE
from archlint.systems.model import System
from archlint.visible import visible

if TYPE_CHECKING:
    import networkx

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<input id="search" type="search" placeholder="search names, types, files" aria-label="search">
<p id="counts">{counts}</p>
</header>
<main>
<div id="drawing">
{svg}</div>
<aside id="details" aria-live="polite"><p>Hover over a node or an interface, or click it to pin it.</p></aside>
</main>
<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
"""


def render(system: System) -> str:
    """Raises :class:`archlint.render.drawing.CannotDraw` where Graphviz fails; without one there are two columns."""
    graph = graph_of(system)
    diagram = grouped(parts_of(system, graph), None)
    counts = "  ·  ".join(captioned(diagram, diagram, pattern_words(system), system.compared is not None).caption)
    try:
        svg = drawing.tidy_svg(drawing.layout(dot.write(diagram), "svg").decode("utf-8"))
    except NoGraphviz:
        svg = columns.svg(diagram)
        counts += "  ·  in columns, for want of Graphviz"
    return _PAGE.format(
        policy=html.escape(_policy()),
        title=html.escape(system.name or "ROS 2 communication graph"),
        style=STYLE,
        counts=html.escape(counts),
        svg=svg[svg.index("<svg") :],
        data=embedded(_data(graph)),
        script=SCRIPT,
    )


def embedded(data: object) -> str:
    """JSON for the inside of a script element."""
    text = json_text(data, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _policy() -> str:
    nothing = "default-src 'none'; base-uri 'none'; form-action 'none'"
    return f"{nothing}; script-src '{_hash(SCRIPT)}'; style-src '{_hash(STYLE)}'"


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _details(edge: dict[str, Any]) -> str:
    return ", ".join([look.endpoint_details(edge["endpoint"], edge["broken"]), *look.remarks([edge])])


def _data(graph: networkx.MultiDiGraph) -> dict[str, Any]:
    """Vertices by the ids that the drawing gives them, and the details of each line."""
    ids = ids_of(graph.nodes)
    vertices = {}
    for key, data in graph.nodes(data=True):
        is_node = data["kind"] == NODE
        name = look.node_label(data["node"]) if is_node else visible(data["name"] or "?")
        details = look.node_details(data["node"]) if is_node else look.interface_details(data)
        observed = [f"when it runs: {data['observed']}"] if data.get("observed") else []
        vertices[ids[key]] = {"kind": data["kind"], "name": name, "details": [*details.split("\n"), *observed]}
    lines = [
        {
            "tail": ids[tail],
            "head": ids[head],
            "details": visible(_details(edge)),
        }
        for tail, head, edge in graph.edges(data=True)
    ]
    return {"vertices": vertices, "lines": lines}
