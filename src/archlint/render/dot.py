"""A diagram in Graphviz' language.

Every id is made of letters, digits and underscores, and every text of the user's is in a quoted string or escaped in an
HTML-like label, so that no name can become markup, a port or an escape of Graphviz.
"""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.render import look
from archlint.render.arranging import CAPTION
from archlint.render.diagram.ids import ids_of
from archlint.render.diagram.model import Badge, Diagram, Key, Line, Shape, Tone
from archlint.render.wrapping import SMALL, TITLE, all_wrapped, wrapped
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from archlint.architecture import ConnectionKind
    from archlint.finding import SeverityLabel
    from archlint.render.arranging import Places
    from archlint.render.diagram.model import ShapeKind

CAREFUL_LAYOUT = 300
"""Shapes that hang together up to which ``dot`` takes all the time it wants (0.2 s for 200, 27 s for 1000 on one
machine)."""
CAREFUL_LINES = 600
"""And lines, which a picture with few shapes may have in plenty."""

FEW_SHAPES = 30
"""Shapes up to which words on a line are its label.  Graphviz moves all ranks apart for each."""

_SHAPES: Mapping[ShapeKind, str] = {
    "node": "box",
    "topic": "box",
    "service": "hexagon",
    "action": "octagon",
    "ends": "note",
    "group": "box3d",
}
_ARROWS: Mapping[ConnectionKind, str] = {"topic": "normal", "service": "vee", "action": "vee"}
_PACKED = {"pack": "12", "packmode": "graph"}
"""Parts that nothing connects are laid out each by itself; Graphviz drops the labels of lines then."""
_HURRY = {"nslimit": "1", "nslimit1": "1", "mclimit": "0.1", "splines": "line"}
BADGES: Mapping[SeverityLabel, tuple[str, str]] = {
    "error": ("#b91c1c", "#ffffff"),
    "warning": ("#facc15", "#422006"),
    "info": ("#e2e8f0", "#1e293b"),
}
"""Background and letters of a badge."""
MOST_BADGES = 3
"""Badges at one thing; the others are counted."""
KINDS: tuple[Tone, ...] = ("node", "topic", "service", "action")
_FRAME = {
    "style": "rounded,filled",
    "fillcolor": "#f8fafc",
    "color": "#cbd5e1",
    "fontsize": "11",
    "margin": "14",
    "labelloc": "t",
}
_QUIET = "#64748b"
_SAID = {"fontsize": "10", "fontcolor": _QUIET}


def render(diagram: Diagram) -> str:
    return write(diagram)


def write(
    diagram: Diagram, attributes: Mapping[str, str] | None = None, hurry: bool = False, apart: bool = False
) -> str:
    """``attributes`` are those of the whole graph, such as ``dpi``; in a ``hurry`` the words on lines have no place of
    their own in the layout, and lines are straight, as in all that is large.  What is drawn in parts that are put
    together afterwards (``apart``) has its caption as a shape."""
    ids = ids_of(diagram.shapes)
    hurry = hurry or is_large(diagram)
    many = len(diagram.shapes) > FEW_SHAPES and not hurry
    attributes = {**(_HURRY if hurry else _PACKED if many else {}), **(attributes or {})}
    words = _words_on_lines(diagram, ids) if many else {}
    label = "xlabel" if hurry else "label"
    lines = [
        drawn
        for number, line in enumerate(diagram.lines)
        for drawn in (_halves(line, ids, words[number][0]) if number in words else [_edge(line, ids, label)])
    ]
    caption = _caption(diagram)
    body = [*_defaults(attributes, "" if apart else caption), *_shapes(diagram, ids, words), *lines]
    if apart and caption:
        body.append(f"  {CAPTION} {_attributes({'shape': 'plain', 'style': '', **_SAID}, caption)};")
    return "\n".join(["digraph archlint {", *body, "}"]) + "\n"


def placed(source: str, places: Places) -> str:
    """What :func:`write` has written with where everything is."""
    rest = {name: [*several] for name, several in places.items()}
    frame = ""
    lines: list[str] = []
    for line in source.splitlines():
        head, bracket, attributes = line.partition(" [")
        name = head.strip()
        if name.startswith("subgraph "):
            frame = name.split()[1]
        elif name == "graph":
            name = frame
        if bracket and rest.get(name):
            where = ", ".join(f'{key}="{value}"' for key, value in rest[name].pop(0).items())
            line = f"{head} [{where}, {attributes}"
        lines.append(line)
    return "\n".join(lines) + "\n"


def is_large(diagram: Diagram) -> bool:
    """Whether a careful layout would take too long: each part that nothing ties to others has its own."""
    return len(diagram.lines) > CAREFUL_LINES or _largest_part(diagram) > CAREFUL_LAYOUT


def _largest_part(diagram: Diagram) -> int:
    """Shapes that lines or frames hold together."""
    frames = diagram.frames
    if len(diagram.shapes) <= CAREFUL_LAYOUT:
        return len(diagram.shapes)
    around: dict[Key, list[Key]] = {key: [("frame", frames[key])] if key in frames else [] for key in diagram.shapes}
    for key, title in frames.items():
        around.setdefault(("frame", title), []).append(key)
    for line in diagram.lines:
        around[line.tail].append(line.head)
        around[line.head].append(line.tail)
    largest, seen = 0, set[Key]()
    for start in around:
        part, todo = 0, [start]
        while todo:
            key = todo.pop()
            if key not in seen:
                seen.add(key)
                part += key in diagram.shapes
                todo += around[key]
        largest = max(largest, part)
    return largest


def quote(text: str) -> str:
    """``text`` as a quoted string that Graphviz shows as it is."""
    shown = "\n".join(visible(line) for line in text.split("\n"))
    escaped = shown.replace("\\", "\\\\").replace('"', '\\"').replace("&", "&amp;").replace("\n", "\\n")
    return f'"{escaped}"'


def escape(text: str) -> str:
    """``text`` for the inside of an HTML-like label."""
    shown = visible(text)
    for char, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;"), ("[", "&#91;"), ("]", "&#93;")):
        shown = shown.replace(char, entity)
    return shown


def _attributes(values: Mapping[str, str], label: str = "", name: str = "label") -> str:
    """``label`` is an HTML-like one, whole, and ``name`` the attribute that it is."""
    every = [f"{name}=<{label}>"] if label else []
    return "[" + ", ".join([*every, *(f"{key}={quote(value)}" for key, value in values.items())]) + "]"


def _defaults(attributes: Mapping[str, str], caption: str) -> Iterator[str]:
    defaults = {
        "rankdir": "LR",
        "bgcolor": "white",
        "pad": "0.3",
        "nodesep": "0.14",
        "ranksep": "0.4",
        "fontname": look.FONT,
        **_SAID,
        "labelloc": "b",
        "labeljust": "l",
    }
    yield f"  graph {_attributes({**defaults, **attributes}, caption)};"
    shape = {"fontname": look.FONT, "style": "filled", "margin": "0.12,0.06", "height": "0.3"}
    yield f"  node {_attributes(shape)};"
    line = {"fontname": look.FONT, "fontsize": "9", "arrowsize": "0.7", "penwidth": "1.2"}
    yield f"  edge {_attributes(line)};"


def _caption(diagram: Diagram) -> str:
    """What is said below the picture, with a sample of each kind of shape that is in it."""
    rows = [escape(words) for words in diagram.caption]
    tones = {shape.tone for shape in diagram.shapes.values()}
    samples = [
        (kind, f'BGCOLOR="{look.PALETTE[kind].fill}" COLOR="{look.PALETTE[kind].line}" BORDER="1"')
        for kind in KINDS
        if kind in tones
    ]
    if samples:
        rows.append(_cells([(kind, drawn, look.PALETTE[kind].text) for kind, drawn in samples], "LEFT"))
    return _table(_rows(rows, "LEFT")) if rows else ""


def _words_on_lines(diagram: Diagram, ids: Mapping[Key, str]) -> dict[int, tuple[str, str]]:
    """The words on lines with their ids, by the numbers of the lines.  An id comes from the ends of the line, so that
    another line elsewhere changes none."""
    words: dict[int, tuple[str, str]] = {}
    lines = Counter[str]()
    for number, line in enumerate(diagram.lines):
        id = f"words_{ids[line.tail]}_{ids[line.head]}"
        lines[id] += 1
        if label := _line_label(line):
            words[number] = (id if lines[id] == 1 else f"{id}_{lines[id]}", label)
    return words


def _shapes(diagram: Diagram, ids: Mapping[Key, str], words: Mapping[int, tuple[str, str]]) -> Iterator[str]:
    """All shapes in their frames, and the words on lines that are shapes of their own, by the numbers of the lines."""
    drawn_in = diagram.frames
    members: dict[str, list[str]] = {}
    for key, shape in diagram.shapes.items():
        members.setdefault(drawn_in.get(key, ""), []).append(_shape(shape, ids))
    for number, (id, label) in words.items():
        line = diagram.lines[number]
        frames = {drawn_in.get(key, "") for key in line.ends}
        members.setdefault(frames.pop() if len(frames) == 1 else "", []).append(_words(line, id, label))
    frames_of = ids_of(("cluster", title) for title in members.keys() - {""})
    for (_, title), frame in frames_of.items():
        yield f"  subgraph {frame} {{"
        yield f"    graph {_attributes({'label': title, **_FRAME})};"
        yield from (f"  {shape}" for shape in members[title])
        yield "  }"
    yield from members.get("", ())


def _shape(shape: Shape, ids: Mapping[Key, str]) -> str:
    return f"  {ids[shape.key]} {_attributes(vertex(shape), _label(shape))};"


def vertex(shape: Shape) -> dict[str, str]:
    """How a shape is drawn, as attributes of Graphviz, its label aside."""
    colours = look.PALETTE[shape.tone]
    drawn = {
        "tooltip": "\n".join([*shape.details, *_told(shape.badges)]),
        "shape": _SHAPES[shape.kind],
        "style": ("rounded," if shape.kind == "node" else "") + f"filled{'' if shape.stroke == 'solid' else ',dashed'}",
        "fillcolor": colours.fill if shape.matched else "#ffffff",
        "color": colours.line,
        "fontcolor": colours.text,
        "fontsize": "13" if shape.kind in ("node", "group") else "10",
    }
    if shape.kind in ("node", "group"):
        drawn |= {"penwidth": "2.6" if shape.remarks else "1.6", "margin": "0.18,0.1"}
    elif shape.kind in ("service", "action"):
        drawn |= {"margin": "0,0", "height": "0"}
    return drawn


def _told(badges: Iterable[Badge]) -> Iterator[str]:
    yield from (f"{badge.code}: {message}" for badge in badges for message in badge.messages)


def _label(shape: Shape) -> str:
    """The title, what is said of it, what it is tied to without a line, and its badges."""
    rows = [*map(escape, wrapped(shape.title, TITLE)), *map(_small, all_wrapped(shape.lines, SMALL))]
    named = [*map(_small, all_wrapped(shape.named, SMALL))]
    last = [f"<I>{words}</I>" for words in map(_small, all_wrapped(shape.remarks, SMALL))]
    if shape.badges:
        last.append(_badges(shape.badges))
    if len(rows) == 1 and not named and not last:
        return rows[0]
    align = "LEFT" if shape.kind == "ends" else "CENTER"
    return _table("".join((_rows(rows, align), _rows(named, "LEFT"), _rows(last, align))))


def _small(words: str) -> str:
    return f'<FONT POINT-SIZE="9">{escape(words)}</FONT>'


def _rows(rows: Iterable[str], align: str = "CENTER") -> str:
    return "".join(f'<TR><TD ALIGN="{align}">{row}</TD></TR>' for row in rows)


def _table(rows: str) -> str:
    return f'<TABLE BORDER="0" CELLSPACING="0" CELLPADDING="0">{rows}</TABLE>'


def _badges(badges: Sequence[Badge]) -> str:
    shown = [(badge.text, *BADGES[badge.severity]) for badge in badges[:MOST_BADGES]]
    if len(badges) > MOST_BADGES:
        shown.append((f"+{len(badges) - MOST_BADGES}", *BADGES["info"]))
    return _cells([(text, f'BGCOLOR="{fill}"', letters) for text, fill, letters in shown])


def _cells(cells: Sequence[tuple[str, str, str]], align: str = "CENTER") -> str:
    """Coloured words side by side: text, attributes of its cell, and the colour of its letters.  Graphviz would widen
    them to what they are in, so that they say how large they are."""
    widths = [round(5.6 * len(text)) + 6 for text, _, _ in cells]
    row = "".join(
        f'<TD {look} WIDTH="{width}" HEIGHT="14"><FONT COLOR="{letters}" POINT-SIZE="8">{escape(text)}</FONT></TD>'
        for (text, look, letters), width in zip(cells, widths, strict=True)
    )
    size = f'FIXEDSIZE="TRUE" WIDTH="{sum(widths) + 2 * len(cells) + 4}" HEIGHT="18"'
    return f'<TABLE BORDER="0" CELLSPACING="2" CELLPADDING="0" ALIGN="{align}" {size}><TR>{row}</TR></TABLE>'


def _edge(line: Line, ids: Mapping[Key, str], label: str) -> str:
    return f"  {ids[line.tail]} -> {ids[line.head]} {_attributes(edge(line), _line_label(line), label)};"


def _words(line: Line, id: str, label: str) -> str:
    """The words on a line as a shape in the middle of it."""
    drawn = {"shape": "plain", "style": "", "fontsize": "9", "tooltip": edge(line)["tooltip"]}
    return f"  {id} {_attributes(drawn, label)};"


def _halves(line: Line, ids: Mapping[Key, str], words: str) -> Iterator[str]:
    drawn = edge(line)
    yield f"  {ids[line.tail]} -> {words} {_attributes({**drawn, 'arrowhead': 'none'})};"
    yield f"  {words} -> {ids[line.head]} {_attributes(drawn)};"


def edge(line: Line) -> dict[str, str]:
    """How a line is drawn, as attributes of Graphviz, its label aside."""
    colours = look.PALETTE["wrong" if line.broken else line.tone]
    drawn = {
        "color": colours.line,
        "arrowhead": "none" if line.broken else _ARROWS[line.kind],
        "style": line.stroke,
        "tooltip": "\n".join([*line.details, *_told(line.badges)]),
    }
    if not line.directed:
        drawn["dir"] = "none"
    if line.broken or line.differs:
        drawn["penwidth"] = "1.8"
    elif line.cycle:
        drawn["penwidth"] = "2.6"
    return drawn


def _line_label(line: Line) -> str:
    wrong = look.PALETTE["wrong"].line
    red = f"✕ {line.broken}".split(", ") if line.broken else [*line.held_back]
    text = look.PALETTE[line.tone].text
    rows = [f'<FONT COLOR="{text}">{escape(words)}</FONT>' for words in all_wrapped(line.labels, SMALL)]
    rows += [f'<FONT COLOR="{wrong}">{escape(words)}</FONT>' for words in all_wrapped(red, SMALL)]
    if line.badges:
        rows.append(_badges(line.badges))
    return _table(_rows(rows)) if rows else ""


__all__ = ["BADGES", "CAREFUL_LAYOUT", "edge", "escape", "is_large", "placed", "quote", "render", "vertex", "write"]
