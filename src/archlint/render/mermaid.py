"""A diagram as a Mermaid flowchart, for Markdown that is shown on GitHub or GitLab.

Ids are letters, digits and underscores; ``"`` and ``#`` are written as Mermaid's own entities, so that no name ends a
label.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render import look
from archlint.render.diagram.boxes import boxes_alone
from archlint.render.diagram.ids import ids_of
from archlint.render.diagram.splitting import split
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from archlint.render.diagram.model import Badge, Diagram, Key, Line, Shape, ShapeKind

EDGE_LIMIT = 500
"""Mermaid draws no more edges than this unless its site says so (``maxEdges``)."""

TEXT_LIMIT = 50_000
"""Nor does it read more characters (``maxTextSize``)."""

_SHAPES: Mapping[ShapeKind, tuple[str, str]] = {
    "node": ('(["', '"])'),
    "topic": ('["', '"]'),
    "service": ('{{"', '"}}'),
    "action": ('[["', '"]]'),
    "ends": ('["', '"]'),
    "group": ('[("', '")]'),
}
_SETTINGS = '%%{init: {"flowchart": {"wrappingWidth": 800}}}%%'
"""Lines of a label are as we break them: Mermaid would at 200 pixels."""
_SIGNS = {"error": "✖", "warning": "⚠", "info": "·"}


def render(diagram: Diagram) -> str:
    """One flowchart; of groups alone, where one of all nodes would be more than Mermaid takes."""
    whole = chart(diagram)
    if fits(whole):
        return whole
    groups = replace(boxes_alone(diagram), caption=diagram.caption)
    overview = chart(groups)
    if len(groups.shapes) > 1 and fits(overview):
        return f"%% too large for Mermaid: these are the groups; --format markdown draws each\n{overview}"
    return f"%% larger than Mermaid takes: --format markdown draws it in parts\n{whole}"


def markdown(diagram: Diagram) -> str:
    """A page for GitHub: the flowchart, or several under headings where one would be more than Mermaid takes."""
    parts = [("", diagram)] if fits(chart(diagram)) else split(diagram, lambda part: fits(chart(part)))
    return "\n".join(_section(title, chart(part)) for title, part in parts)


def _section(title: str, text: str) -> str:
    heading = f"### {_markdown(title)}\n\n" if title else ""
    return f"{heading}```mermaid\n{text}```\n"


def _markdown(text: str) -> str:
    """A title in which nothing is markup."""
    shown = re.sub(r"([\\`*_\[\]|#~$!])", r"\\\1", visible(text))
    return shown.replace("&", "&amp;").replace("<", "&lt;").replace("@", "&#64;")


def fits(text: str) -> bool:
    """Whether Mermaid draws a flowchart as it is."""
    return len(text) <= TEXT_LIMIT and sum(1 for line in text.splitlines() if _is_edge(line)) <= EDGE_LIMIT


def _is_edge(line: str) -> bool:
    return any(f" {arrow}" in line for arrow in ("-->", "-.->", "--x", "-.-", "==>"))


def chart(diagram: Diagram) -> str:
    ids = ids_of(diagram.shapes)
    lines = [
        _SETTINGS,
        "flowchart LR",
        *_vertices(diagram, ids),
        *(_edge(line, ids) for line in diagram.lines),
        *_caption(diagram),
        *_styles(diagram, ids),
        *_coloured_lines(diagram),
    ]
    return "\n".join(lines) + "\n"


def escape(text: str) -> str:
    """``text`` for the inside of a quoted label; a newline becomes a line break."""
    shown = "\n".join(visible(line) for line in text.split("\n"))
    for char, entity in (("#", "#35;"), ("&", "#amp;"), ('"', "#quot;"), ("<", "#lt;"), (">", "#gt;")):
        shown = shown.replace(char, entity)
    return shown.replace("`", "#96;").replace("\n", "<br>")


def _vertices(diagram: Diagram, ids: Mapping[Key, str]) -> Iterator[str]:
    drawn_in = diagram.frames
    for number, title in enumerate(sorted(set(drawn_in.values()))):
        yield f'  subgraph g{number}["{escape(title)}"]'
        yield from (f"  {_vertex(shape, ids)}" for key, shape in diagram.shapes.items() if drawn_in.get(key) == title)
        yield "  end"
    yield from (_vertex(shape, ids) for key, shape in diagram.shapes.items() if key not in drawn_in)


def _vertex(shape: Shape, ids: Mapping[Key, str]) -> str:
    before, after = _SHAPES[shape.kind]
    return f"  {ids[shape.key]}{before}{escape(_text([*shape.label, *_badges(shape.badges)]))}{after}"


def _text(lines: Iterable[str]) -> str:
    return "\n".join(lines)


def _badges(badges: Iterable[Badge]) -> list[str]:
    """A line with the codes of findings, with a sign for how severe they are."""
    words = [f"{_SIGNS[badge.severity]} {badge.text}" for badge in badges]
    return [" ".join(words)] if words else []


def _edge(line: Line, ids: Mapping[Key, str]) -> str:
    words = [*line.labels, *([line.broken] if line.broken else line.held_back), *_badges(line.badges)]
    label = f'|"{escape(_text(words))}"|' if words else ""
    return f"  {ids[line.tail]} {_arrow(line)}{label} {ids[line.head]}"


def _arrow(line: Line) -> str:
    if not line.directed:
        return "-.-"
    if line.broken:
        return "--x"
    if line.cycle:
        return "==>"
    return "-->" if line.stroke == "solid" else "-.->"


def _caption(diagram: Diagram) -> Iterator[str]:
    if diagram.caption:
        yield f'  caption["{escape(_text(diagram.caption))}"]'


def _coloured_lines(diagram: Diagram) -> Iterator[str]:
    """Mermaid styles a line by its number."""
    numbers: dict[str, list[str]] = {}
    for number, line in enumerate(diagram.lines):
        tone = "wrong" if line.broken else line.tone if line.differs else ""
        numbers.setdefault(tone, []).append(str(number))
    for style, colours in look.PALETTE.items():
        if style in numbers:
            yield f"  linkStyle {','.join(numbers[style])} stroke:{colours.line},color:{colours.line}"


def _styles(diagram: Diagram, ids: Mapping[Key, str]) -> Iterator[str]:
    members: dict[str, list[str]] = {}
    for key, shape in diagram.shapes.items():
        members.setdefault(shape.tone, []).append(ids[key])
    if diagram.caption:
        members["note"] = ["caption"]
    for name, colours in look.PALETTE.items():
        if name in members:
            align = ",text-align:left" if name == "note" else ""
            yield f"  classDef {name} fill:{colours.fill},stroke:{colours.line},color:{colours.text}{align}"
            yield f"  class {','.join(members[name])} {name}"
    dashed = [ids[key] for key, shape in diagram.shapes.items() if shape.stroke != "solid"]
    if dashed:
        yield "  classDef unmatched stroke-dasharray:4"
        yield f"  class {','.join(dashed)} unmatched"


__all__ = ["EDGE_LIMIT", "TEXT_LIMIT", "chart", "escape", "fits", "markdown", "render"]
