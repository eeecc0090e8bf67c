"""Traces as pictures: callbacks in the frames of their nodes, what goes between them, and what is in doubt.

What connects two callbacks is drawn once, however many ways go through it.  The size of a picture is bounded.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.dataflow.model import How, Link, Step, StepKind
from archlint.render import look
from archlint.render.dot import quote
from archlint.render.drawing import layout, tidy_svg
from archlint.render.mermaid import escape
from archlint.render.tracing.step_notes import notes
from archlint.render.tracing.words import node_words, place_words, title

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow

MOST_STEPS = 200
"""A picture with more is not read."""
_COLOURS = {
    StepKind.TOPIC: "topic",
    StepKind.SERVICE: "service",
    StepKind.ANSWER: "service",
    StepKind.ACTION: "action",
    StepKind.RESULT: "action",
    StepKind.CALLBACK: "node",
    StepKind.FRAME: "topic",
    StepKind.KEPT: "topic",
    StepKind.UNKNOWN: "aside",
    StepKind.STRANGER: "aside",
}
_SHAPES = {
    StepKind.TOPIC: "box",
    StepKind.SERVICE: "hexagon",
    StepKind.ANSWER: "hexagon",
    StepKind.ACTION: "octagon",
    StepKind.RESULT: "octagon",
    StepKind.FRAME: "tab",
    StepKind.KEPT: "note",
}
_BRACKETS = {
    StepKind.TOPIC: ('["', '"]'),
    StepKind.SERVICE: ('{{"', '"}}'),
    StepKind.ANSWER: ('{{"', '"}}'),
    StepKind.ACTION: ('[["', '"]]'),
    StepKind.RESULT: ('[["', '"]]'),
    StepKind.FRAME: ('[/"', '"/]'),
    StepKind.KEPT: ('>"', '"]'),
}
Row = tuple["Flow", Sequence[Step], Sequence[Link], frozenset[int]]
"""Of one system: its flow, the steps and links to draw, and the steps (``id``) that were asked for."""
Rows = Sequence[Row]


def dot(rows: Rows) -> str:
    """The pictures of some systems beside each other, in Graphviz' language."""
    lines = [
        "digraph archlint {",
        f"  graph [rankdir=LR, bgcolor=white, pad=0.3, nodesep=0.28, ranksep=0.5, fontname={quote(look.FONT)}, "
        f'fontsize=10, fontcolor="#64748b", labelloc=b, labeljust=l{_caption(rows)}];',
        f'  node [fontname={quote(look.FONT)}, style="filled", fontsize=10, margin="0.14,0.07", height=0.3];',
        f"  edge [fontname={quote(look.FONT)}, fontsize=9, arrowsize=0.7, penwidth=1.2];",
    ]
    for number, (flow, steps, links, asked) in enumerate(rows):
        lines += _dot_system(f"s{number}", flow, steps[:MOST_STEPS], links, asked)
    return "\n".join([*lines, "}"]) + "\n"


def svg(rows: Rows) -> str:
    """The same, laid out.  Raises :class:`archlint.render.errors.CannotDraw`."""
    return tidy_svg(layout(dot(rows), "svg").decode("utf-8"))


def _caption(rows: Rows) -> str:
    names = [flow.system.name for flow, _, _, _ in rows if flow.system.name]
    more = sum(max(0, len(steps) - MOST_STEPS) for _, steps, _, _ in rows)
    words = [*names, *([f"{more} more steps are left out"] if more else [])]
    return f", label={quote('  ·  '.join(words))}" if words else ""


def _dot_system(
    prefix: str, flow: Flow, steps: Sequence[Step], links: Sequence[Link], asked: frozenset[int]
) -> Iterator[str]:
    ids = {id(step): f"{prefix}n{number}" for number, step in enumerate(steps)}
    for number, (frame, members) in enumerate(_frames(steps)):
        if frame:
            yield f"  subgraph cluster_{prefix}_{number} {{"
            yield (
                f'    graph [label={quote(frame)}, style="rounded,filled", fillcolor="#f8fafc", color="#cbd5e1", '
                "fontsize=11, margin=10, labelloc=t];"
            )
        yield from (f"  {'  ' if frame else ''}{ids[id(step)]} [{_dot_step(flow, step, asked)}];" for step in members)
        if frame:
            yield "  }"
    for link in links:
        if id(link.tail) in ids and id(link.head) in ids:
            yield f"  {ids[id(link.tail)]} -> {ids[id(link.head)]} [{_dot_link(link)}];"


def _dot_step(flow: Flow, step: Step, asked: frozenset[int]) -> str:
    colours = look.PALETTE[_COLOURS[step.kind]]
    shape, is_open = _SHAPES.get(step.kind, "box"), step.kind in (StepKind.UNKNOWN, StepKind.STRANGER)
    style = "filled" + (",rounded" if step.kind == StepKind.CALLBACK else "") + (",dashed" if is_open else "")
    tooltip = "" if step.place is None else f", tooltip={quote(place_words(step.place))}"
    width = ", penwidth=2.6" if id(step) in asked else ""
    width += ', margin="0,0", height=0' if shape in ("hexagon", "octagon") else ""  # Graphviz adds enough
    return (
        f'label={quote(_label(flow, step))}, shape={shape}, style="{style}", fillcolor="{colours.fill}", '
        f'color="{colours.line}", fontcolor="{colours.text}"{width}{tooltip}'
    )


def _dot_link(link: Link) -> str:
    colour = look.PALETTE["wrong" if link.broken else _COLOURS[_colour_of(link)]].line
    style = "dashed" if link.doubt or link.broken else "dotted" if link.conditional else "solid"
    label = f', label={quote(f"✕ {link.broken}")}, fontcolor="{colour}"' if link.broken else ""
    tip = link.doubt or ("only under a condition" if link.conditional else "")
    place = "" if link.place is None else place_words(link.place)
    tooltip = ", ".join(filter(None, [place, tip]))
    return f'color="{colour}", style={style}{label}' + (f", tooltip={quote(tooltip)}" if tooltip else "")


def _colour_of(link: Link) -> StepKind:
    """A line has the colour of the connection that it goes to or comes from."""
    return link.head.kind if link.how == How.SEND else link.tail.kind


def _label(flow: Flow, step: Step) -> str:
    """Its name, and what decides when it runs."""
    name = title(step)
    remarks = [note for note in notes(flow, step) if step.kind != StepKind.STRANGER]
    if step.connection is not None:
        remarks = [note.rpartition("/")[2] for note in remarks]
    return "\n".join([name, ", ".join(remarks)]) if remarks else name


def _frames(steps: Sequence[Step]) -> list[tuple[str, list[Step]]]:
    """Steps by the nodes that they are of; connections and strangers are in no frame."""
    frames: dict[int, tuple[str, list[Step]]] = {}
    for step in steps:
        is_inside = step.node is not None and step.kind != StepKind.STRANGER
        key = id(step.node) if is_inside else 0
        frames.setdefault(key, (node_words(step.node) if is_inside else "", []))[1].append(step)
    return list(frames.values())


# ---------------------------------------------------------------------------------------------------- Mermaid


def mermaid(rows: Rows) -> str:
    """The same as a Mermaid flowchart."""
    lines = ["flowchart LR"]
    styles: dict[str, list[str]] = {}
    for number, (flow, steps, links, _) in enumerate(rows):
        shown = steps[:MOST_STEPS]
        ids = {id(step): f"s{number}n{position}" for position, step in enumerate(shown)}
        for position, (frame, members) in enumerate(_frames(shown)):
            inside = [f"  {ids[id(step)]}{_mermaid_step(flow, step)}" for step in members]
            around = [f'  subgraph s{number}g{position}["{escape(frame)}"]', *inside, "  end"]
            lines += around if frame else inside
        for step in shown:
            styles.setdefault(_COLOURS[step.kind], []).append(ids[id(step)])
        drawn = [link for link in links if id(link.tail) in ids and id(link.head) in ids]
        lines += [f"  {ids[id(link.tail)]} {_mermaid_arrow(link)} {ids[id(link.head)]}" for link in drawn]
        if len(steps) > MOST_STEPS:
            lines.append(f'  s{number}more["… and {len(steps) - MOST_STEPS} more steps"]')
    return "\n".join([*lines, *_classes(styles)]) + "\n"


def _classes(styles: dict[str, list[str]]) -> Iterator[str]:
    for name, colours in look.PALETTE.items():
        if name in styles:
            yield f"  classDef {name} fill:{colours.fill},stroke:{colours.line},color:{colours.text}"
            yield f"  class {','.join(styles[name])} {name}"


def _mermaid_step(flow: Flow, step: Step) -> str:
    before, after = _BRACKETS.get(step.kind, ('(["', '"])'))
    return f"{before}{escape(_label(flow, step))}{after}"


def _mermaid_arrow(link: Link) -> str:
    if link.broken:
        return f'--x|"{escape(link.broken)}"|'
    return "-.->" if link.doubt or link.conditional else "-->"


__all__ = ["MOST_STEPS", "Row", "Rows", "dot", "mermaid", "svg"]
