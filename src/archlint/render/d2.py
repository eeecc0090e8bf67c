"""A diagram in the language of D2 (d2lang.com), for documentation that is built with it.

Ids are letters, digits and underscores, and every text of the user's is in a quoted string, in which ``$`` and what
else D2 would read is escaped.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.render import look
from archlint.render.diagram.ids import ids_of
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from archlint.render.diagram.model import Badge, Diagram, Key, Line, Shape, ShapeKind

_SHAPES: Mapping[ShapeKind, str] = {
    "node": "rectangle",
    "topic": "rectangle",
    "service": "hexagon",
    "action": "step",
    "ends": "page",
    "group": "package",
}


def render(diagram: Diagram) -> str:
    ids = ids_of(diagram.shapes)
    drawn_in = diagram.frames
    frames = {title: f"g{number}" for number, title in enumerate(sorted(set(drawn_in.values())))}
    paths = {key: f"{frames[drawn_in[key]]}.{ids[key]}" if key in drawn_in else ids[key] for key in diagram.shapes}
    body = [
        "direction: right",
        *(f"{id}: {quote(title)}" for title, id in frames.items()),
        *(words for shape in diagram.shapes.values() for words in _shape(shape, paths)),
        *(words for line in diagram.lines for words in _line(line, paths)),
        *_caption(diagram),
    ]
    return "\n".join(body) + "\n"


def quote(text: str) -> str:
    """``text`` as a quoted string that D2 shows as it is; a newline becomes a line break."""
    shown = "\n".join(visible(line) for line in text.split("\n"))
    for char, escaped in (("\\", "\\\\"), ('"', '\\"'), ("$", "\\$"), ("\n", "\\n")):
        shown = shown.replace(char, escaped)
    return f'"{shown}"'


def _shape(shape: Shape, paths: Mapping[Key, str]) -> Iterator[str]:
    colours = look.PALETTE[shape.tone]
    label = "\n".join([*shape.label, *_badges(shape.badges)])
    yield f"{paths[shape.key]}: {quote(label)} {{"
    yield f"  shape: {_SHAPES[shape.kind]}"
    if shape.details:
        yield f"  tooltip: {quote(chr(10).join([*shape.details, *_told(shape.badges)]))}"
    yield f'  style: {{fill: "{colours.fill}"; stroke: "{colours.line}"; font-color: "{colours.text}"'
    if shape.kind == "node":
        yield "    border-radius: 12"
    if shape.stroke != "solid":
        yield "    stroke-dash: 4"
    if shape.remarks:
        yield "    stroke-width: 4"
    yield "  }"
    yield "}"


def _badges(badges: Iterable[Badge]) -> list[str]:
    words = [f"[{badge.text}]" for badge in badges]
    return [" ".join(words)] if words else []


def _told(badges: Iterable[Badge]) -> Iterator[str]:
    yield from (f"{badge.code}: {message}" for badge in badges for message in badge.messages)


def _line(line: Line, paths: Mapping[Key, str]) -> Iterator[str]:
    colours = look.PALETTE["wrong" if line.broken else line.tone]
    words = [*line.labels, *([f"✕ {line.broken}"] if line.broken else line.held_back), *_badges(line.badges)]
    label = f": {quote(chr(10).join(words))}" if words else ":"
    arrow = "->" if line.directed and not line.broken else "--"
    yield f"{paths[line.tail]} {arrow} {paths[line.head]}{label} {{"
    yield f'  style: {{stroke: "{colours.line}"; font-color: "{colours.line}"'
    if line.stroke != "solid":
        yield f"    stroke-dash: {4 if line.stroke == 'dashed' else 2}"
    if line.cycle or line.broken:
        yield "    stroke-width: 3"
    yield "  }"
    yield "}"


def _caption(diagram: Diagram) -> Iterator[str]:
    if diagram.caption:
        yield f"caption: {quote(chr(10).join(diagram.caption))} {{"
        yield "  shape: text"
        yield "  near: bottom-left"
        yield "}"


__all__ = ["quote", "render"]
