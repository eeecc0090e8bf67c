"""Where each shape of a picture stands and how each line runs, worked out by Graphviz when the page is written.

A small graph is laid out as a whole.  Of a large one each group is laid out by itself, and the groups and what is in
none are set in rows: ``dot`` would need minutes and put them into one column.  Without Graphviz the page arranges
itself when it is opened.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from archlint.records import dataclass
from archlint.render.drawing import layout
from archlint.render.errors import CannotDraw

Box = tuple[float, float, float, float]
"""Left, top, width and height, in pixels."""

AS_A_WHOLE = 220
"""Shapes up to which one layout is made of all."""
MOST = 3000
"""Shapes beyond which a page arranges only what is opened."""

_INCH = 72.0
_LETTER = 6.7
"""Pixels of a letter of 12 pixels' height, on average; names have few narrow ones."""
_LINE, _PAD, _SMALL = 16.0, 10.0, 10.5 / 12
_FRAME = 26.0
"""Pixels between the frame of a group and what is in it; its title is there, too."""
_COLUMN = 8
"""So many of what one line leads to stand in a column."""
_BETWEEN = 40.0
"""Pixels between groups."""


@dataclass(frozen=True)
class Shape:
    """What stands in the picture: its lines of text, and the group that it is drawn in (empty for none)."""

    is_node: bool
    label: tuple[str, ...]
    group: str

    @property
    def size(self) -> tuple[float, float]:
        """Width and height; the first line is the name, in larger letters for a node."""
        letter = _LETTER * (13 / 12 if self.is_node else 11 / 12)
        widths = [len(self.label[0]) * letter, *(len(line) * _LETTER * _SMALL for line in self.label[1:])]
        return (max(widths) + 2 * _PAD, len(self.label) * _LINE + _PAD)


@dataclass(frozen=True)
class Line:
    """A line between two shapes, by their numbers."""

    tail: int
    head: int


@dataclass(frozen=True)
class Drawing:
    """A box for each shape, and a path for each line: the points of a Bézier curve, x and y in turn, or None for a line
    that the page draws."""

    boxes: Sequence[Box]
    paths: Sequence[Sequence[float] | None]


def place(shapes: Sequence[Shape], lines: Sequence[Line]) -> Drawing | None:
    """None where Graphviz is not there, or does not get it done."""
    if not shapes or len(shapes) > MOST:
        return None
    try:
        if len(shapes) <= AS_A_WHOLE:
            return _whole(shapes, lines)
        return _in_rows(shapes, lines)
    except CannotDraw:
        return None


def _whole(shapes: Sequence[Shape], lines: Sequence[Line]) -> Drawing:
    said = _laid_out(shapes, lines, hurry=False)
    boxes = [said.box(number, shape) for number, shape in enumerate(shapes)]
    return Drawing(boxes, [said.path(number) for number in range(len(lines))])


def _in_rows(shapes: Sequence[Shape], lines: Sequence[Line]) -> Drawing:
    """The lines inside of groups are laid out with them, and the page draws those in between."""
    inner = [line if shapes[line.tail].group == shapes[line.head].group != "" else None for line in lines]
    said = _laid_out(shapes, inner, hurry=True)
    boxes = [said.box(number, shape) for number, shape in enumerate(shapes)]
    blocks = [shape.group or number for number, shape in enumerate(shapes)]
    members: dict[str | int, list[Box]] = {}
    for block, box in zip(blocks, boxes, strict=True):
        members.setdefault(block, []).append(box)
    frames = {block: _around(inside, _FRAME if isinstance(block, str) else 0) for block, inside in members.items()}
    moves = {block: (left - frames[block][0], top - frames[block][1]) for block, (left, top) in _rows(frames)}
    paths = [None if line is None else said.path(number) for number, line in enumerate(inner)]
    return Drawing(
        [_moved(box, moves[block]) for block, box in zip(blocks, boxes, strict=True)],
        [
            None if path is None else _path_moved(path, moves[blocks[line.tail]])
            for line, path in zip(lines, paths, strict=True)
        ],
    )


def _around(boxes: Sequence[Box], room: float) -> Box:
    left, top = min(box[0] for box in boxes) - room, min(box[1] for box in boxes) - room
    right = max(box[0] + box[2] for box in boxes) + room
    return (left, top, right - left, max(box[1] + box[3] for box in boxes) + room - top)


def _rows(frames: dict[str | int, Box]) -> Iterator[tuple[str | int, tuple[float, float]]]:
    """Left and top of each frame, groups by their titles and then what is in none, in rows of about equal width that
    together have the shape of a screen: 16 to 10."""
    area = sum((width + _BETWEEN) * (height + _BETWEEN) for _, _, width, height in frames.values())
    limit = max((area * 1.6) ** 0.5, *(width for _, _, width, _ in frames.values()))
    left = top = height_of_row = 0.0
    for block in sorted(frames, key=lambda name: (isinstance(name, int), str(name), name)):
        _, _, width, height = frames[block]
        if left and left + width > limit:
            left, top, height_of_row = 0.0, top + height_of_row + _BETWEEN, 0.0
        yield block, (left, top)
        left += width + _BETWEEN
        height_of_row = max(height_of_row, height)


def _moved(box: Box, by: tuple[float, float]) -> Box:
    return (box[0] + by[0], box[1] + by[1], box[2], box[3])


def _path_moved(path: Sequence[float], by: tuple[float, float]) -> list[float]:
    return [value + by[index % 2] for index, value in enumerate(path)]


@dataclass(frozen=True)
class _Layout:
    """What Graphviz says; it counts from the bottom, and a page from the top."""

    height: float
    shapes: dict[str, dict[str, Any]]
    lines: dict[str, dict[str, Any]]

    def box(self, number: int, shape: Shape) -> Box:
        x, y = map(float, self.shapes[f"n{number}"]["pos"].split(","))
        width, height = shape.size
        return (x - width / 2, self.height - y - height / 2, width, height)

    def path(self, number: int) -> list[float] | None:
        line = self.lines.get(f"e{number}")
        if line is None or not line.get("pos"):
            return None
        words = line["pos"].split(";")[0].split()
        end = next((word[2:] for word in words if word.startswith("e,")), None)
        pairs = [word for word in words if not word.startswith(("e,", "s,"))]
        points: list[float] = []
        for pair in pairs:
            x, y = map(float, pair.split(","))
            points += [x, self.height - y]
        if end is not None:  # the tip of the arrow, where the curve ends on the page
            x, y = map(float, end.split(","))
            points[-2:] = [x, self.height - y]
        return points


def _laid_out(shapes: Sequence[Shape], lines: Sequence[Line | None], *, hurry: bool) -> _Layout:
    document = json.loads(layout("\n".join(_source(shapes, lines, hurry)), "json0"))
    named = {row["name"]: row for row in document.get("objects", ())}
    edges = {row["id"]: row for row in document.get("edges", ())}
    return _Layout(float(document["bb"].split(",")[3]), named, edges)


def _source(shapes: Sequence[Shape], lines: Sequence[Line | None], hurry: bool) -> Iterator[str]:
    """Only names made up here: no text of the user's is needed for a layout."""
    quick = ", nslimit=1, nslimit1=1, mclimit=0.1" if hurry else ""
    yield f"digraph page {{ graph [rankdir=LR, nodesep=0.22, ranksep=0.7{quick}];"
    yield 'node [shape=box, fixedsize=true, label=""]; edge [arrowsize=0.7];'
    groups: dict[str, list[int]] = {}
    for number, shape in enumerate(shapes):
        groups.setdefault(shape.group, []).append(number)
    for index, (group, numbers) in enumerate(groups.items()):
        if group:
            yield f"subgraph cluster_{index} {{ graph [margin=18];"
        for number in numbers:
            width, height = shapes[number].size
            yield f"n{number} [width={width / _INCH:.3f}, height={height / _INCH:.3f}];"
        if group:
            yield "}"
    columns = _columns(lines)
    for number, line in enumerate(lines):
        if line is not None:
            yield f"n{line.tail} -> n{line.head} [id=e{number}, minlen={columns.get(number, 1)}];"
    yield "}"


def _columns(lines: Sequence[Line | None]) -> Mapping[int, int]:
    """Of lines to what one line alone leads to, by their numbers: how many columns away it stands.  All that a node
    has so would be one long column."""
    degree = Counter(end for line in lines if line is not None for end in (line.tail, line.head))
    ends: dict[tuple[int, bool], list[int]] = {}
    for number, line in enumerate(lines):
        if line is not None and degree[line.head] == 1:
            ends.setdefault((line.tail, True), []).append(number)
        elif line is not None and degree[line.tail] == 1:
            ends.setdefault((line.head, False), []).append(number)
    return {
        number: 1 + index // _COLUMN for own in ends.values() if len(own) > _COLUMN for index, number in enumerate(own)
    }


__all__ = ["Drawing", "Line", "Shape", "place"]
