"""The form in which rqt_graph hands a graph to Graphviz, as far as it bears on the layout.

Facts, of ``dotcode.py`` and ``ros_graph.py`` of rqt_graph and ``pydotfactory.py`` of qt_dotgraph (ROS 2): laid out from
left to right with ``rank=same`` and ``ranksep`` 0.2; nodes are ellipses and topics boxes with their names; with nodes
alone each topic is a labelled line; each namespace of two levels and more is a frame.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from archlint.render.dot import quote


def write(graph: Mapping[str, Any], style: str, matched: bool) -> str:
    """The graph of ``archlint graph --format json`` as rqt_graph would write it: nodes and topics, with ``matched``
    those with both ends alone, or, with the style ``nodes``, nodes alone."""
    topics = [t for t in graph["topics"] if not matched or (t["publishers"] and t["subscribers"])]
    names = sorted({node["name"] for node in graph["nodes"] if node["name"]})
    lines = [*(_between(topics) if style == "nodes" else _over(topics))]
    body = [*_shapes(names, "ellipse", "n_")]
    if style != "nodes":
        body += _shapes([topic["name"] for topic in topics], "box", "t_")
    head = 'graph [rank=same, rankdir=LR, ranksep="0.2", compound=True];'
    return "\n".join(["digraph graphname {", head, *body, *lines, "}"]) + "\n"


def _shapes(names: Sequence[str], shape: str, prefix: str) -> Iterator[str]:
    frames: dict[str, list[str]] = {}
    for name in names:
        namespace = name.rpartition("/")[0]
        frames.setdefault(namespace if prefix == "n_" else "", []).append(name)
    for number, (namespace, members) in enumerate(sorted(frames.items())):
        rows = [f"{quote(prefix + name)} [shape={shape}, label={quote(name)}];" for name in members]
        if namespace:
            rows = [f"subgraph cluster_{number} {{ label={quote(namespace)};", *rows, "}"]
        yield from rows


def _over(topics: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    for topic in topics:
        place = quote("t_" + topic["name"])
        yield from (f"{quote('n_' + name)} -> {place};" for name in topic["publishers"] if name)
        yield from (f"{place} -> {quote('n_' + name)};" for name in topic["subscribers"] if name)


def _between(topics: Sequence[Mapping[str, Any]]) -> Iterator[str]:
    for topic in topics:
        for tail in filter(None, topic["publishers"]):
            for head in filter(None, topic["subscribers"]):
                yield f"{quote('n_' + tail)} -> {quote('n_' + head)} [label={quote(topic['name'])}];"


__all__ = ["write"]
