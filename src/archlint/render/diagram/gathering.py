"""Topics, services and actions of one node with nothing at their other end, gathered in one shape that lists them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.diagram.model import Shape
from archlint.render.look import counted
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.architecture import ConnectionKind
    from archlint.render.diagram.model import Diagram, Key, Line, Stroke

FEWEST = 3
"""So many of one node, of one kind and in one direction, are gathered."""
MOST_NAMES = 12
"""The names that are listed; the others are counted."""


def gathered(diagram: Diagram) -> Diagram:
    """The diagram with such ends gathered.  What has a finding, or runs otherwise, stays by itself."""
    at: dict[Key, list[Line]] = {}
    for line in diagram.lines:
        for key in line.ends:
            at.setdefault(key, []).append(line)
    bundles: dict[tuple[Key, ConnectionKind, bool], list[Line]] = {}
    for key, shape in diagram.shapes.items():
        lines = at.get(key, [])
        if key[0] == NODE or shape.matched or len(lines) != 1 or not _is_plain(shape, lines[0]):
            continue
        outwards = lines[0].head == key
        node = lines[0].tail if outwards else lines[0].head
        bundles.setdefault((node, lines[0].kind, outwards), []).append(lines[0])
    shapes, kept = dict(diagram.shapes), dict.fromkeys(diagram.lines)
    groups = dict(diagram.groups)
    for (node, kind, outwards), lines in sorted(bundles.items()):
        if len(lines) < FEWEST:
            continue
        key = ("ends", f"{node[1]} {'to' if outwards else 'from'} {kind}s")
        members = [line.head if outwards else line.tail for line in lines]
        shapes[key] = _ends(key, kind, [diagram.shapes[member] for member in members])
        if node in groups:
            groups[key] = groups[node]
        for line, member in zip(lines, members, strict=True):
            del shapes[member]
            del kept[line]
        kept[_joined(lines, node, key, outwards)] = None
    return replace(diagram, shapes=shapes, lines=tuple(kept), groups=groups)


def _is_plain(shape: Shape, line: Line) -> bool:
    return not (shape.badges or shape.remarks or line.badges or line.differs or shape.tone != line.kind)


def _ends(key: Key, kind: ConnectionKind, members: Sequence[Shape]) -> Shape:
    names = [member.title for member in members]
    more = [f"and {len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return Shape(
        key,
        "ends",
        counted(len(names), kind),
        (*names[:MOST_NAMES], *more),
        tone=kind,
        stroke="dashed",
        details=tuple(f"{member.title}: {', '.join(member.details)}" for member in members),
        matched=False,
        groups=members[0].groups,
        holds={kind: len(names)},
    )


def _joined(lines: Sequence[Line], node: Key, key: Key, outwards: bool) -> Line:
    tail, head = (node, key) if outwards else (key, node)
    stroke: Stroke = "dotted" if all(line.stroke == "dotted" for line in lines) else "dashed"
    details = tuple(words for line in lines for words in line.details)
    return replace(lines[0], tail=tail, head=head, labels=(), stroke=stroke, details=details)


__all__ = ["gathered"]
