"""Where the parts of a picture go: those that nothing connects side by side, in the shape of a page.

``dot`` puts them into rows, of which one large part makes a wide picture with much white.  So ``dot`` lays out each
part, and here they are put close together.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from archlint.records import dataclass
from archlint.render.packing import packed

ROOM = 18.0
"""Points between parts."""
Places = Mapping[str, list[dict[str, str]]]
"""Attributes of Graphviz that say where things are, by the id of a shape or a frame, or by ``tail -> head``: several
where there are several such lines, in their order."""
_WORDS = 45.0
"""About half the width of words on a line."""
_STEP = 36.0
"""Points that heights are told apart by, so that a small edit changes no order."""
_POINT = re.compile(r"(-?[\d.]+(?:e[+-]\d+)?),(-?[\d.]+(?:e[+-]\d+)?)")


@dataclass
class _Part:
    """What hangs together, and how far it goes."""

    name: str = ""
    left: float = float("inf")
    bottom: float = float("inf")
    right: float = float("-inf")
    top: float = float("-inf")
    moved: tuple[float, float] = (0.0, 0.0)
    """How far it goes to the right and up to its place."""

    @property
    def size(self) -> tuple[float, float]:
        return self.right - self.left, self.top - self.bottom

    @property
    def middle(self) -> str:
        """Of its place, as Graphviz writes a point."""
        width, height = self.size
        return f"{self.left + self.moved[0] + width / 2:.2f},{self.bottom + self.moved[1] + height / 2:.2f}"

    @property
    def order(self) -> tuple[bool, float, str]:
        """High ones first, and what is said of the picture last."""
        return self.name == CAPTION, -((self.top - self.bottom) // _STEP), self.name

    def reach(self, left: float, bottom: float, right: float, top: float) -> None:
        self.left, self.bottom = min(self.left, left), min(self.bottom, bottom)
        self.right, self.top = max(self.right, right), max(self.top, top)


CAPTION = "caption"
"""The id of what is said below a picture, which is a shape here."""


def places(laid_out: bytes) -> Places:
    """Of Graphviz' ``json0``."""
    data = json.loads(laid_out)
    objects, edges = data.get("objects", []), data.get("edges", [])
    shapes = {item["_gvid"]: item for item in objects if "pos" in item}
    frames = [item for item in objects if "bb" in item and "nodes" in item]
    parts = _parts(shapes, frames, edges)
    caption = _caption(data)
    _put_together([*{id(part): part for part in parts.values()}.values(), *caption])
    where: dict[str, list[dict[str, str]]] = {part.name: [{"pos": part.middle}] for part in caption}
    for id_, item in shapes.items():
        where[item["name"]] = [_moved(item, ("pos",), parts[id_])]
    for frame in frames:
        where[frame["name"]] = [_moved(frame, ("bb", "lp"), parts[frame["nodes"][0]])]
    for edge in edges:
        name = f"{shapes[edge['tail']]['name']} -> {shapes[edge['head']]['name']}"
        where.setdefault(name, []).append(_moved(edge, ("pos", "lp"), parts[edge["tail"]]))
    return where


def _caption(data: Mapping[str, Any]) -> list[_Part]:
    """What is said below the picture, which is the label of all of it there: as a shape it would make room for itself
    among the others."""
    if "lwidth" not in data:
        return []
    return [_Part(CAPTION, 0.0, 0.0, float(data["lwidth"]) * 72, float(data["lheight"]) * 72)]


def _parts(
    shapes: Mapping[int, Any], frames: Iterable[Mapping[str, Any]], edges: Iterable[Mapping[str, Any]]
) -> dict[int, _Part]:
    """The part of each shape, with the extent of all that is in it."""
    import networkx

    ties = networkx.Graph()
    ties.add_nodes_from(shapes)
    ties.add_edges_from((edge["tail"], edge["head"]) for edge in edges)
    for frame in frames:
        networkx.add_path(ties, frame["nodes"])
    parts: dict[int, _Part] = {}
    for members in networkx.connected_components(ties):
        part = _Part(min(shapes[id_]["name"] for id_ in members))
        parts |= dict.fromkeys(members, part)
    for id_, item in shapes.items():
        x, y = map(float, item["pos"].split(","))
        width, height = float(item["width"]) * 36, float(item["height"]) * 36
        parts[id_].reach(x - width, y - height, x + width, y + height)
    for frame in frames:
        left, bottom, right, top = map(float, frame["bb"].split(","))
        parts[frame["nodes"][0]].reach(left, bottom, right, top)
    for edge in edges:
        for x, y in _points(edge.get("pos", "")):
            parts[edge["tail"]].reach(x, y, x, y)
        for x, y in _points(edge.get("lp", "")):  # the middle of words, whose width is not told
            parts[edge["tail"]].reach(x - _WORDS, y, x + _WORDS, y)
    return parts


def _put_together(parts: Iterable[_Part]) -> None:
    ordered = sorted(parts, key=lambda part: part.order)
    page = packed([part.size for part in ordered], ROOM)
    for part, (left, top) in zip(ordered, page.corners, strict=True):
        part.moved = left - part.left, page.height - top - part.top


def _points(pos: str) -> Iterable[tuple[float, float]]:
    return ((float(x), float(y)) for x, y in _POINT.findall(pos))


def _moved(item: Mapping[str, Any], names: Iterable[str], part: _Part) -> dict[str, str]:
    right, up = part.moved

    def moved(point: re.Match[str]) -> str:
        return f"{float(point[1]) + right:.2f},{float(point[2]) + up:.2f}"

    return {name: _POINT.sub(moved, item[name]) for name in names if name in item}


__all__ = ["CAPTION", "Places", "places"]
