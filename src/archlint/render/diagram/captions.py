"""What is said below a picture: what is in it, the pattern of the system, and what its marks mean."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.systems import pattern
from archlint.systems.graph import NODE
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from archlint.render.diagram.model import Diagram
    from archlint.systems.model import System

_WIDTH = 110
_BETWEEN = "  ·  "
_KINDS = ("node", "neighbour", "topic", "service", "action")


def pattern_words(system: System) -> list[str]:
    """The pattern with its figures, in lines of a readable length; nothing where none is recognised."""
    figures = pattern.figures(system)
    if figures.pattern is None:
        return []
    return _lines(visible(words) for words in pattern.words(figures))


def _lines(sentences: Iterable[str]) -> list[str]:
    """Short sentences one after the other, on lines of a length that can be read."""
    lines: list[str] = []
    for sentence in sentences:
        if lines and len(lines[-1]) + len(sentence) < _WIDTH:
            lines[-1] += f"{_BETWEEN}{sentence}"
        else:
            lines.append(sentence)
    return lines


def captioned(diagram: Diagram, whole: Diagram, words: Sequence[str], compared: bool) -> Diagram:
    """The diagram with its caption; ``whole`` is all of the system, ``words`` what is said of that."""
    caption = [_counts(diagram, whole), *words, *_legend(diagram, compared)]
    return replace(diagram, caption=tuple(filter(None, caption))) if whole.shapes else diagram


def _counts(diagram: Diagram, whole: Diagram) -> str:
    """``3 nodes, 1 topic, 2 services; not shown: 1 node``."""
    kinds, every = _kinds(diagram), _kinds(whole)
    words = [counted(kinds[kind], kind) for kind in _KINDS if kinds[kind]]
    hidden = [counted(every[kind] - kinds[kind], kind) for kind in _KINDS if every[kind] > kinds[kind]]
    left_out = f"; not shown: {', '.join(hidden)}" if hidden and kinds else ""
    return (", ".join(words) or "no nodes") + left_out


def _kinds(diagram: Diagram) -> Counter[str]:
    kinds = Counter(diagram.in_nodes)
    for shape in diagram.shapes.values():
        if not shape.helper:
            kinds.update(shape.holds or {"neighbour" if shape.neighbour else shape.kind: 1})
    if not any(shape.kind not in (NODE, "group") for shape in diagram.shapes.values()):
        del kinds["group"]
    return kinds


def _legend(diagram: Diagram, compared: bool) -> list[str]:
    """What the marks that occur mean."""
    return _lines(_meanings(diagram, compared))


def _meanings(diagram: Diagram, compared: bool) -> Iterator[str]:
    shapes, lines = diagram.shapes.values(), diagram.lines
    if any(line.broken for line in lines):
        yield "red and crossed out: QoS or type differ, nothing gets through"
    if any(shape.badges for shape in shapes) or any(line.badges for line in lines):
        yield "a code on red or yellow: an error or a warning, see archlint explain CODE"
    if any(line.cycle for line in lines):
        yield "thick: requests that lead in a circle"
    if any(shape.named for shape in shapes):
        yield "→ or ← and a name in a node: sends to it, takes from it"
    if compared:
        yield "compared with a running system: red is missing, green unexpected, teal different"
    if any(shape.neighbour for shape in shapes):
        yield "white: a neighbour outside the selection"
    if any(shape.kind == NODE and shape.tone == "aside" and not shape.neighbour for shape in shapes):
        yield "grey and dashed: test code, no node, or a node whose source is not here"
    if any(not shape.matched for shape in shapes):
        yield "a dashed topic, service or action: nothing at the other end"
    if any("*" in shape.title for shape in shapes if shape.kind not in ("node", "group")):
        yield "*: known only at run time"
    if any(not line.directed for line in lines):
        yield "dashed without an arrow: remapped; the source is not in this workspace"
    if any(line.stroke == "dotted" for line in lines):
        yield "dotted: only under a condition"


__all__ = ["captioned", "pattern_words"]
