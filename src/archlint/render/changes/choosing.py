"""What a picture of a comparison shows.

Its size is bounded: what breaks something comes first, then what changed, then who else is at these ends.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from archlint.comparing.sketch import Line, Mark, Sketch
from archlint.records import dataclass

MOST_LINES: Final = 60
"""A picture with more lines is not read."""
_LONGEST: Final = 80
"""Characters of a name in the picture."""
_RANKS: dict[Mark, int] = {"removed": 1, "changed": 2, "added": 3, "same": 4}
_WORDS: dict[Mark, str] = {"removed": "removed", "changed": "changed", "added": "new", "same": ""}

Vertex = tuple[str, str]
"""What it is, and its name."""


@dataclass(frozen=True)
class Drawn:
    """What is drawn, each with how it changed; ``left`` lines are not."""

    vertices: Mapping[Vertex, Mark]
    lines: Sequence[Line]
    left: int


def drawn_of(sketch: Sketch) -> Drawn:
    lines = sorted(sketch.lines, key=lambda line: (line not in sketch.breaking, _RANKS[sketch.lines[line]], line))
    shown, left = lines[:MOST_LINES], max(0, len(lines) - MOST_LINES)
    alone = [name for name in sketch.nodes if all(line.node != name for line in shown)]
    return Drawn(_vertices(sketch, shown, alone[: max(0, MOST_LINES - len(shown))]), shown, left)


def word_of(line: Line, sketch: Sketch) -> str:
    """How a line changed, in a word; empty where it has not."""
    return "breaking" if line in sketch.breaking else _WORDS[sketch.lines[line]]


def short(name: str) -> str:
    return name if len(name) <= _LONGEST else f"{name[:_LONGEST]}…"


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


__all__ = ["MOST_LINES", "Drawn", "Vertex", "drawn_of", "short", "word_of"]
