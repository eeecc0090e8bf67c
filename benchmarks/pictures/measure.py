"""What can be counted of a layout: how large it is, how many lines cross, and what covers what."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Any

Point = tuple[float, float]
_STEPS = 8
"""Straight pieces that each bend of a line is taken for."""
_LETTER, _ROW = 4.0, 9.0
"""Points of a letter and a row of the words on lines, rather too little than too much."""
_PAGE = (16.5 - 1, 11.7 - 1)
"""Inches of an A3 page inside its margins."""


@dataclass(frozen=True)
class Box:
    left: float
    bottom: float
    right: float
    top: float

    def overlaps(self, other: Box) -> bool:
        return (
            self.left < other.right and other.left < self.right and self.bottom < other.top and other.bottom < self.top
        )

    def holds(self, point: Point) -> bool:
        return self.left < point[0] < self.right and self.bottom < point[1] < self.top


@dataclass(frozen=True)
class Measured:
    """Counts of a layout; ``width`` and ``height`` in inches, ``points`` the size of 10-point letters on an A3 page."""

    shapes: int
    lines: int
    width: float
    height: float
    crossings: int
    covered: int
    """Shapes and words that overlap, or that a line runs through without ending there."""

    @property
    def area(self) -> float:
        return self.width * self.height

    @property
    def points(self) -> float:
        across = min(_PAGE[0] / self.width, _PAGE[1] / self.height)
        upright = min(_PAGE[1] / self.width, _PAGE[0] / self.height)
        return min(10.0, 10 * max(across, upright))


def measure(layout: bytes) -> Measured:
    """Of Graphviz' ``json0``."""
    data = json.loads(layout)
    _, _, width, height = map(float, data["bb"].split(","))
    shapes = {item["_gvid"]: _box(item) for item in data.get("objects", []) if "pos" in item}
    edges = [edge for edge in data.get("edges", []) if "pos" in edge]
    paths = [_path(edge["pos"]) for edge in edges]
    ends = [{edge["tail"], edge["head"]} for edge in edges]
    crossings = sum(
        _cross(first, second)
        for (first, mine), (second, other) in combinations(list(zip(paths, ends, strict=True)), 2)
        if not mine & other
    )
    covered = sum(
        any(box.holds(point) for point in path)
        for path, own in zip(paths, ends, strict=True)
        for id, box in shapes.items()
        if id not in own
    )
    boxes = [*shapes.values(), *(_words(edge) for edge in edges if "lp" in edge)]
    covered += sum(first.overlaps(second) for first, second in combinations(boxes, 2))
    worded = sum(item["name"].startswith("words_") for item in data.get("objects", []) if "pos" in item)
    return Measured(len(shapes) - worded, len(paths) - worded, width / 72, height / 72, crossings, covered)


def _box(item: dict[str, Any]) -> Box:
    x, y = map(float, item["pos"].split(","))
    width, height = float(item["width"]) * 36, float(item["height"]) * 36
    return Box(x - width, y - height, x + width, y + height)


def _words(edge: dict[str, Any]) -> Box:
    """About the room that the words on a line take: Graphviz only says where their middle is."""
    rows = [re.sub(r"<[^>]*>", "", row) for row in re.split(r"</TR>|\\n", edge["label"])]
    rows = [html.unescape(row) for row in rows if row]
    x, y = map(float, edge["lp"].split(","))
    width, height = max(map(len, rows)) * _LETTER / 2, len(rows) * _ROW / 2
    return Box(x - width, y - height, x + width, y + height)


def _path(pos: str) -> list[Point]:
    """A line as points: Graphviz gives cubic Bézier curves, and where arrows end."""
    words = [word for word in pos.split() if word[:2] not in ("e,", "s,")]
    points = [(float(x), float(y)) for x, y in (word.split(",") for word in words)]
    path = [points[0]]
    for start in range(0, len(points) - 3, 3):
        path += list(_bend(points[start : start + 4]))
    return path


def _bend(points: Sequence[Point]) -> Iterator[Point]:
    for step in range(1, _STEPS + 1):
        t = step / _STEPS
        shares = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3)
        yield (
            sum(share * x for share, (x, _) in zip(shares, points, strict=True)),
            sum(share * y for share, (_, y) in zip(shares, points, strict=True)),
        )


def _cross(first: Sequence[Point], second: Sequence[Point]) -> int:
    mine, other = _extent(first), _extent(second)
    if not mine.overlaps(other):
        return 0
    pieces = list(pairwise(second))
    return sum(_meet(a, b, c, d) for a, b in pairwise(first) for c, d in pieces)


def _extent(path: Sequence[Point]) -> Box:
    xs, ys = [x for x, _ in path], [y for _, y in path]
    return Box(min(xs), min(ys), max(xs) + 0.001, max(ys) + 0.001)


def _meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    return _side(a, b, c) != _side(a, b, d) and _side(c, d, a) != _side(c, d, b)


def _side(a: Point, b: Point, c: Point) -> bool:
    return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])


__all__ = ["Measured", "measure"]
