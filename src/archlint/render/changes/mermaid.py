"""A picture of what changed, and of nothing else: a Mermaid flowchart for Markdown.

Its size is bounded: what breaks something comes first, then what changed, then who else is at these ends.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

from archlint.comparing.sketch import Line, Mark, Sketch
from archlint.render.mermaid import escape

MOST_LINES: Final = 60
"""A picture with more lines is not read."""
_LONGEST: Final = 80
"""Characters of a name in the picture."""
_SHAPES = {"node": ('(["', '"])'), "topic": ('["', '"]'), "service": ('{{"', '"}}'), "action": ('[["', '"]]')}
_RANKS: dict[Mark, int] = {"removed": 1, "changed": 2, "added": 3, "same": 4}
_WORDS: dict[Mark, str] = {"removed": "removed", "changed": "changed", "added": "new", "same": ""}
_ARROWS: dict[Mark, str] = {"removed": "-.-x", "changed": "==>", "added": "==>", "same": "-->"}
_STYLES: dict[Mark, str] = {
    "removed": "fill:#ffebe9,stroke:#cf222e,color:#82071e,stroke-dasharray:4",
    "changed": "fill:#fff8c5,stroke:#9a6700,color:#4d2d00",
    "added": "fill:#dafbe1,stroke:#1a7f37,color:#0a3622",
    "same": "fill:#f6f8fa,stroke:#6e7781,color:#24292f",
}
_COLOURS: dict[Mark, str] = {"removed": "#cf222e", "changed": "#9a6700", "added": "#1a7f37", "same": "#6e7781"}

Vertex = tuple[str, str]
"""What it is, and its name."""


def render(sketch: Sketch, most: int = MOST_LINES) -> str:
    """The picture; empty where there is nothing to draw."""
    lines = sorted(sketch.lines, key=lambda line: (line not in sketch.breaking, _RANKS[sketch.lines[line]], line))
    shown, left = lines[:most], len(lines) - most
    alone = [name for name in sketch.nodes if all(line.node != name for line in shown)][: max(0, most - len(shown))]
    if not shown and not alone:
        return ""
    vertices = _vertices(sketch, shown, alone)
    ids = {vertex: f"n{number}" for number, vertex in enumerate(vertices)}
    drawn = [
        "flowchart LR",
        *(_vertex(vertex, ids[vertex]) for vertex in vertices),
        *(_line(line, sketch, ids) for line in shown),
        *_classes(vertices, ids),
        *_coloured(shown, sketch),
    ]
    if left > 0:
        drawn.append(f'  more["… and {left} more connections"]')
    return "\n".join(drawn) + "\n"


def _vertices(sketch: Sketch, lines: Sequence[Line], alone: Sequence[str]) -> dict[Vertex, Mark]:
    """What is drawn, each with how it changed."""
    vertices: dict[Vertex, Mark] = {}
    for line in lines:
        vertices.setdefault(("node", line.node), sketch.nodes.get(line.node, "same"))
        vertices.setdefault((line.family, line.name), _of_interface(line, sketch))
    return vertices | {("node", name): sketch.nodes[name] for name in alone}


def _of_interface(line: Line, sketch: Sketch) -> Mark:
    """A topic is new where all of its ends are, and gone where all are."""
    marks = {mark for other, mark in sketch.lines.items() if (other.family, other.name) == (line.family, line.name)}
    return marks.pop() if len(marks) == 1 and not marks & {"changed"} else "same"


def _vertex(vertex: Vertex, id: str) -> str:
    kind, name = vertex
    before, after = _SHAPES[kind]
    shown = name if len(name) <= _LONGEST else f"{name[:_LONGEST]}…"
    return f"  {id}{before}{escape(shown)}{after}"


def _line(line: Line, sketch: Sketch, ids: dict[Vertex, str]) -> str:
    mark = sketch.lines[line]
    node, interface = ids["node", line.node], ids[line.family, line.name]
    tail, head = (node, interface) if line.outwards else (interface, node)
    words = "breaking" if line in sketch.breaking else _WORDS[mark]
    return f"  {tail} {_ARROWS[mark]}{f'|{words}|' if words else ''} {head}"


def _classes(vertices: dict[Vertex, Mark], ids: dict[Vertex, str]) -> Iterator[str]:
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
