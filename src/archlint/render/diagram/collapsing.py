"""Groups that are drawn as one box."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.diagram.model import Line, Shape
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Sequence, Set

    from archlint.finding import SeverityLabel
    from archlint.render.diagram.model import Diagram, Key


def collapsed(diagram: Diagram, titles: Set[str]) -> Diagram:
    """The diagram with one box for each group with one of these titles."""
    if not titles:
        return diagram
    place = {key: ("group", title) if title in titles else key for key, title in diagram.groups.items()}
    members: dict[Key, list[Shape]] = {}
    for key, shape in diagram.shapes.items():
        if key in place and place[key] != key:
            members.setdefault(place[key], []).append(shape)
    shapes = {key: shape for key, shape in diagram.shapes.items() if place.get(key, key) == key}
    shapes |= {key: _box(key, members[key]) for key in sorted(members)}
    lines: dict[tuple[Key, Key], list[Line]] = {}
    for line in diagram.lines:
        tail, head = (place.get(key, key) for key in line.ends)
        if tail != head:
            lines.setdefault((tail, head), []).append(replace(line, tail=tail, head=head))
    joined = tuple(_joined(several) for several in lines.values())
    groups = {key: title for key, title in diagram.groups.items() if key in shapes}
    return replace(diagram, shapes=shapes, lines=joined, groups=groups)


def _box(key: Key, members: Sequence[Shape]) -> Shape:
    holds: Counter[str] = Counter()
    for shape in members:
        holds.update(shape.holds or {"helper" if shape.helper else shape.kind: 1})
    words = [counted(holds[kind], kind) for kind in ("node", "helper", "topic", "service", "action") if holds[kind]]
    severities: Counter[SeverityLabel] = Counter()
    for badge in (badge for shape in members for badge in shape.badges):
        severities[badge.severity] += len(badge.messages)
    severity_words = [counted(severities[label], label) for label in _SEVERITIES if severities[label]]
    names = [shape.title for shape in members if shape.kind == NODE]
    return Shape(
        key,
        "group",
        key[1],
        (", ".join(words),),
        tuple(filter(None, [", ".join(severity_words)])),
        tone="group",
        details=tuple(names),
        holds=holds,
    )


_SEVERITIES: tuple[SeverityLabel, ...] = ("error", "warning")


def _joined(lines: Sequence[Line]) -> Line:
    """One line in place of those of several members of a box."""
    first = lines[0]
    if len(lines) == 1:
        return first
    broken = first.broken if all(line.broken for line in lines) else ""
    some = () if broken else tuple(dict.fromkeys(line.broken for line in lines if line.broken))
    whole = next((line for line in lines if not line.broken), first)
    return replace(
        whole,
        broken=broken,
        held_back=tuple(dict.fromkeys((*some, *(words for line in lines for words in line.held_back)))),
        labels=tuple(dict.fromkeys(label for line in lines for label in line.labels)),
        badges=tuple({badge.code: badge for line in lines for badge in line.badges}.values()),
        cycle=any(line.cycle for line in lines),
        details=tuple(words for line in lines for words in line.details),
    )


__all__ = ["collapsed"]
