"""The graph in two columns, nodes and what they talk over: what the HTML page shows where there is no Graphviz.

Classes, titles and colours are those of Graphviz's drawing, which the script of the page works with.
"""

from __future__ import annotations

import html
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from archlint.render import dot, look
from archlint.render.diagram.ids import ids_of
from archlint.systems.graph import NODE, Key

if TYPE_CHECKING:
    from archlint.render.diagram.model import Diagram

SIZE = 12
"""Pixels of a letter's height; :data:`_WIDTH` is a letter's width on average."""
_WIDTH, _LINE, _PAD, _GAP, _BETWEEN = 6.6, 15, 8, 12, 220
_DASHES = {"dashed": "5 3", "dotted": "1 3"}


@dataclass(frozen=True)
class Box:
    """A vertex where it is drawn."""

    lines: Sequence[str]
    left: float
    top: float
    width: float

    @property
    def height(self) -> float:
        return len(self.lines) * _LINE + _PAD

    @property
    def middle(self) -> float:
        return self.top + self.height / 2


def svg(diagram: Diagram) -> str:
    ids = dict(ids_of(diagram.shapes))
    boxes = _boxes(diagram)
    width = max((box.left + box.width for box in boxes.values()), default=0) + _PAD
    height = max((box.top + box.height for box in boxes.values()), default=0) + _PAD
    body = [*_lines(diagram, ids, boxes), *_vertices(diagram, ids, boxes)]
    head = f'<svg width="{width:.0f}" height="{height:.0f}" viewBox="0 0 {width:.0f} {height:.0f}"'
    return "\n".join([f'{head} xmlns="http://www.w3.org/2000/svg">', *body, "</svg>"]) + "\n"


def _boxes(diagram: Diagram) -> dict[Key, Box]:
    """Nodes in their order, and each interface about where the nodes are that have it."""
    nodes = [key for key in diagram.shapes if key[0] == NODE]
    row = {key: number for number, key in enumerate(nodes)}
    ends: dict[Key, list[int]] = {}
    for line in diagram.lines:
        for interface, node in (line.ends, line.ends[::-1]):
            if node in row:
                ends.setdefault(interface, []).append(row[node])

    def height_of(interface: Key) -> tuple[float, Key]:
        around = ends.get(interface, [])
        return (sum(around) / len(around) if around else len(row), interface)

    left = _column(diagram, nodes, _PAD)
    start = max((box.left + box.width for box in left.values()), default=0) + _BETWEEN
    right = _column(diagram, sorted((key for key in diagram.shapes if key not in row), key=height_of), start)
    height = max(_bottom(left), _bottom(right))
    return _spread(left, height) | _spread(right, height)


def _column(diagram: Diagram, keys: Sequence[Key], left: float) -> dict[Key, Box]:
    labels = {key: diagram.shapes[key].label for key in keys}
    width = max((len(line) for lines in labels.values() for line in lines), default=0) * _WIDTH + 2 * _PAD
    boxes: dict[Key, Box] = {}
    top: float = _PAD
    for key, lines in labels.items():
        boxes[key] = Box(lines, left, top, width)
        top += boxes[key].height + _GAP
    return boxes


def _bottom(boxes: dict[Key, Box]) -> float:
    return max((box.top + box.height for box in boxes.values()), default=0)


def _spread(boxes: dict[Key, Box], height: float) -> dict[Key, Box]:
    """The boxes over the whole height, with the same space above and below each."""
    space = (height - _bottom(boxes)) / (len(boxes) or 1)
    return {key: replace(box, top=box.top + space * (number + 0.5)) for number, (key, box) in enumerate(boxes.items())}


def _vertices(diagram: Diagram, ids: dict[Key, str], boxes: dict[Key, Box]) -> Iterator[str]:
    for key, box in boxes.items():
        drawn = dot.vertex(diagram.shapes[key])
        yield f'<g class="node"><title>{ids[key]}</title>'
        yield (
            f'<rect x="{box.left:.1f}" y="{box.top:.1f}" width="{box.width:.1f}" height="{box.height:.1f}"'
            f' rx="{8 if key[0] == NODE else 0}" fill="{drawn["fillcolor"]}" {_stroke(drawn)}/>'
        )
        for number, line in enumerate(box.lines, 1):
            place = f'x="{box.left + box.width / 2:.1f}" y="{box.top + number * _LINE:.1f}" text-anchor="middle"'
            font = f'font-family="{look.FONT}" font-size="{SIZE}" fill="{drawn["fontcolor"]}"'
            yield f"<text {place} {font}>{html.escape(line)}</text>"
        yield "</g>"


def _lines(diagram: Diagram, ids: dict[Key, str], boxes: dict[Key, Box]) -> Iterator[str]:
    for line in diagram.lines:
        tail, head = line.ends
        attributes = dot.edge(line)
        yield f'<g class="edge"><title>{ids[tail]}-&gt;{ids[head]}</title>'
        outwards = tail[0] == NODE
        yield from _line(
            *((boxes[tail], boxes[head]) if outwards else (boxes[head], boxes[tail])), outwards, attributes
        )
        yield "</g>"


def _line(node: Box, interface: Box, outwards: bool, drawn: dict[str, str]) -> Iterator[str]:
    """From the node to the interface, or, where it is not ``outwards``, the other way round."""
    right, left = node.left + node.width, interface.left
    start, end, bend = node.middle, interface.middle, (left - right) / 2
    path = f"M{right:.1f},{start:.1f} C{right + bend:.1f},{start:.1f} {left - bend:.1f},{end:.1f} {left:.1f},{end:.1f}"
    yield f'<path fill="none" {_stroke(drawn)} d="{path}"/>'
    if "none" not in (drawn.get("arrowhead"), drawn.get("dir")):
        tip, back, height = (left, -7, end) if outwards else (right, 7, start)
        points = f"{tip:.1f},{height:.1f} {tip + back:.1f},{height - 4:.1f} {tip + back:.1f},{height + 4:.1f}"
        yield f'<polygon fill="{drawn["color"]}" points="{points}"/>'


def _stroke(drawn: dict[str, str]) -> str:
    dashes = next((pattern for style, pattern in _DASHES.items() if style in drawn["style"]), "")
    told = f'stroke="{drawn["color"]}" stroke-width="{drawn.get("penwidth", "1.2")}"'
    return f'{told} stroke-dasharray="{dashes}"' if dashes else told
