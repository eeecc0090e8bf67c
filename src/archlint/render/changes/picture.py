"""What changed as a diagram, which Graphviz draws: new, gone and otherwise in the colours of a comparison."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, cast

from archlint.render.changes.choosing import Drawn, Vertex, drawn_of, short, word_of
from archlint.render.changes.words import counted
from archlint.render.diagram.model import Diagram, Line, Shape, ShapeKind, Tone
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.comparing.sketch import Line as SketchLine
    from archlint.comparing.sketch import Mark, Sketch
    from archlint.render.changes.model import Difference

_TONES: Mapping[Mark, Tone] = {"removed": "missing", "changed": "different", "added": "unexpected"}
_MEANINGS: Mapping[Tone, str] = {
    "wrong": "red: breaks what others use",
    "missing": "red and dashed: gone",
    "different": "teal: changed",
    "unexpected": "green: new",
    "aside": "grey: as it was",
}


def diagram_of(difference: Difference) -> Diagram:
    """Only what changed, and who else is at these ends."""
    sketch = difference.sketch
    drawn = drawn_of(sketch)
    shapes = {vertex: _shape(vertex, mark) for vertex, mark in drawn.vertices.items()}
    lines = tuple(_line(line, sketch) for line in drawn.lines)
    diagram = Diagram(shapes, lines)
    return replace(diagram, caption=tuple(_caption(difference, drawn, diagram)))


def _shape(vertex: Vertex, mark: Mark) -> Shape:
    kind, name = vertex
    return Shape(
        vertex,
        cast("ShapeKind", kind),
        visible(short(name)),
        tone=_TONES.get(mark, "aside"),
        stroke="dashed" if mark == "removed" else "solid",
    )


def _line(line: SketchLine, sketch: Sketch) -> Line:
    mark = sketch.lines[line]
    node, interface = ("node", line.node), (str(line.family), line.name)
    word = word_of(line, sketch)
    tail, head = (node, interface) if line.outwards else (interface, node)
    return Line(
        tail,
        head,
        line.family,
        (word,) if word else (),
        tone="wrong" if line in sketch.breaking else _TONES.get(mark, "aside"),
        stroke="dashed" if mark == "removed" else "solid",
        differs=mark != "same",
    )


def _caption(difference: Difference, drawn: Drawn, diagram: Diagram) -> Iterator[str]:
    yield visible(f"{difference.base.words} → {difference.head.words}: {counted(difference)}")
    if difference.changes and not diagram.shapes:
        yield "all of them are about what is no node and no connection: archlint diff says them in words"
    if drawn.left:
        yield f"{drawn.left} more connections are not drawn"
    tones = {*(shape.tone for shape in diagram.shapes.values()), *(line.tone for line in diagram.lines)}
    yield "  ·  ".join(words for tone, words in _MEANINGS.items() if tone in tones)


__all__ = ["diagram_of"]
