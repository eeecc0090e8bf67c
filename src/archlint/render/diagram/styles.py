"""Nodes alone: what connects two of them is written on the line between them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.architecture import CONNECTIONS
from archlint.render.diagram.model import Badge, Line
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from archlint.render.diagram.model import Diagram, Key, Shape

MOST_PAIRS = 12
"""What ties more pairs of nodes than this stays a shape of its own: lines between all of them show nothing."""
MOST_NAMES = 3
"""The names on one line."""


def nodes_alone(diagram: Diagram) -> Diagram:
    """The diagram with lines from node to node in place of topics, services and actions."""
    kept: set[Key] = {key for key in diagram.shapes if key[0] == NODE}
    direct: dict[tuple[Key, Key, str, bool], list[Line]] = {}
    lines: list[Line] = []
    around = _lines_by_interface(diagram)
    for key, shape in diagram.shapes.items():
        if key in kept:
            continue
        pairs = list(_pairs(diagram, shape, around.get(key, [])))
        if len(pairs) > MOST_PAIRS or any(not line.directed for line in around.get(key, [])):
            kept.add(key)
            lines += around.get(key, [])
            continue
        for line in pairs:
            direct.setdefault((line.tail, line.head, line.kind, bool(line.broken)), []).append(line)
    order = sorted(direct, key=lambda k: (k[0], k[1], CONNECTIONS.index(direct[k][0].kind), k[3]))
    lines += [_joined(direct[key]) for key in order]
    return replace(
        diagram,
        shapes={key: shape for key, shape in diagram.shapes.items() if key in kept},
        lines=tuple(lines),
    )


def _lines_by_interface(diagram: Diagram) -> dict[Key, list[Line]]:
    around: dict[Key, list[Line]] = {}
    for line in diagram.lines:
        around.setdefault(line.head if line.tail[0] == NODE else line.tail, []).append(line)
    return around


def _pairs(diagram: Diagram, shape: Shape, lines: Sequence[Line]) -> Iterator[Line]:
    """From each node that sends over an interface to each that takes."""
    for sent in (line for line in lines if line.head == shape.key):
        for taken in (line for line in lines if line.tail == shape.key):
            if sent.tail == taken.head and len(lines) > 2:
                continue  # among others a node's own message is no news
            yield _pair(diagram, shape, sent, taken)


def _pair(diagram: Diagram, shape: Shape, sent: Line, taken: Line) -> Line:
    reason = diagram.cut.get((sent.tail, shape.key, taken.head), "")
    badges = {badge.code: badge for badge in (*taken.badges, *sent.badges, *shape.badges)}
    differs = next((line for line in (sent, taken) if line.differs), None)
    stroke = next((s for s in ("dotted", "dashed") if s in (sent.stroke, taken.stroke)), "solid")
    return replace(
        sent,
        head=taken.head,
        labels=(shape.title,),
        broken=reason,
        held_back=(),
        badges=tuple(badges[code] for code in sorted(badges)),
        tone=differs.tone if differs else "wrong" if reason else sent.kind,
        stroke="dashed" if reason else "dotted" if stroke == "dotted" else "dashed" if differs else "solid",
        cycle=sent.cycle and taken.cycle,
        details=(shape.title, *shape.details, *sent.details, *taken.details),
        differs=differs is not None,
    )


def _joined(lines: Sequence[Line]) -> Line:
    """One line for what connects two nodes in one way."""
    first = lines[0]
    names = [name for line in lines for name in line.labels]
    more = [f"and {len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    badges: dict[str, Badge] = {}
    for badge in (badge for line in lines for badge in line.badges):
        known = badges.get(badge.code)
        messages = tuple(dict.fromkeys((*(known.messages if known else ()), *badge.messages)))
        badges[badge.code] = replace(badge, messages=messages)
    return replace(
        first,
        labels=(*names[:MOST_NAMES], *more),
        badges=tuple(badges[code] for code in sorted(badges)),
        stroke=next((line.stroke for line in lines if line.stroke == "solid"), first.stroke),
        cycle=any(line.cycle for line in lines),
        details=tuple(dict.fromkeys(words for line in lines for words in line.details)),
    )


__all__ = ["nodes_alone"]
