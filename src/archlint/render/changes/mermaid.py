"""A picture of what changed, and of nothing else, as a Mermaid flowchart for Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from archlint.comparing.sketch import Line, Mark, Sketch
from archlint.render.changes.choosing import Vertex, drawn_of, short, word_of
from archlint.render.mermaid import escape

_SHAPES = {"node": ('(["', '"])'), "topic": ('["', '"]'), "service": ('{{"', '"}}'), "action": ('[["', '"]]')}
_ARROWS: dict[Mark, str] = {"removed": "-.-x", "changed": "==>", "added": "==>", "same": "-->"}
_STYLES: dict[Mark, str] = {
    "removed": "fill:#ffebe9,stroke:#cf222e,color:#82071e,stroke-dasharray:4",
    "changed": "fill:#fff8c5,stroke:#9a6700,color:#4d2d00",
    "added": "fill:#dafbe1,stroke:#1a7f37,color:#0a3622",
    "same": "fill:#f6f8fa,stroke:#6e7781,color:#24292f",
}
_COLOURS: dict[Mark, str] = {"removed": "#cf222e", "changed": "#9a6700", "added": "#1a7f37", "same": "#6e7781"}


def render(sketch: Sketch) -> str:
    """The picture; empty where there is nothing to draw."""
    drawn = drawn_of(sketch)
    if not drawn.vertices:
        return ""
    ids = {vertex: f"n{number}" for number, vertex in enumerate(drawn.vertices)}
    written = [
        "flowchart LR",
        *(_vertex(vertex, ids[vertex]) for vertex in drawn.vertices),
        *(_line(line, sketch, ids) for line in drawn.lines),
        *_classes(drawn.vertices, ids),
        *_coloured(drawn.lines, sketch),
    ]
    if drawn.left > 0:
        written.append(f'  more["… and {drawn.left} more connections"]')
    return "\n".join(written) + "\n"


def _vertex(vertex: Vertex, id: str) -> str:
    kind, name = vertex
    before, after = _SHAPES[kind]
    return f"  {id}{before}{escape(short(name))}{after}"


def _line(line: Line, sketch: Sketch, ids: dict[Vertex, str]) -> str:
    mark = sketch.lines[line]
    node, interface = ids["node", line.node], ids[line.family, line.name]
    tail, head = (node, interface) if line.outwards else (interface, node)
    words = word_of(line, sketch)
    return f"  {tail} {_ARROWS[mark]}{f'|{words}|' if words else ''} {head}"


def _classes(vertices: Mapping[Vertex, Mark], ids: dict[Vertex, str]) -> Iterator[str]:
    for mark, style in _STYLES.items():
        members = [ids[vertex] for vertex, of in vertices.items() if of == mark]
        if members:
            yield f"  classDef {mark} {style}"
            yield f"  class {','.join(members)} {mark}"


def _coloured(lines: Sequence[Line], sketch: Sketch) -> Iterator[str]:
    """Mermaid styles a line by its number."""
    for mark, colour in _COLOURS.items():
        numbers = [str(number) for number, line in enumerate(lines) if sketch.lines[line] == mark]
        if numbers:
            yield f"  linkStyle {','.join(numbers)} stroke:{colour},color:{colour}"
