"""Several shapes as one that lists them: what one node or the same nodes have in the same way, and nodes alone."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from archlint.counted import counted
from archlint.render.diagram.model import Shape
from archlint.render.look import UNOWNED
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping, Sequence

    from archlint.render.diagram.model import Diagram, Key, Line, Stroke

FEWEST = 3
"""So many loose ends of one node, of one kind and in one direction, are gathered; as many nodes of one frame."""
FEWEST_SHARED = 2
"""And so many topics, services or actions that the same nodes have."""
MOST_NAMES = 12
"""The names that are listed; the others are counted."""

_Name = TypeVar("_Name", str, tuple[str, str])

Tie = tuple["Key", bool, "Stroke", tuple[str, ...]]
"""How a node is tied to something: the node, whether it sends, and how that is drawn and worded."""


def gathered(diagram: Diagram) -> Diagram:
    """The diagram with the ends of one node gathered that have nothing at their other end."""
    at = lines_at(diagram)
    bundles: dict[tuple[Key, str, bool], list[Key]] = {}
    for key, shape in diagram.shapes.items():
        lines = at.get(key, [])
        if key[0] != NODE and not shape.matched and len(lines) == 1 and is_plain(shape, lines):
            outwards = lines[0].head == key
            node = lines[0].tail if outwards else lines[0].head
            bundles.setdefault((node, lines[0].kind, outwards), []).append(key)
    named = {
        ("ends", f"{node[1]} {'to' if outwards else 'from'} {kind}s"): members
        for (node, kind, outwards), members in sorted(bundles.items())
        if len(members) >= FEWEST
    }
    return _bundled(diagram, at, named)


def shared(diagram: Diagram, most: int) -> Diagram:
    """The diagram with ``most`` lines less, or as many as can be saved by one shape for all topics, services or actions
    that the same nodes have in the same way."""
    at = lines_at(diagram)
    bundles: dict[tuple[str, bool, frozenset[Tie]], list[Key]] = {}
    for key, shape in diagram.shapes.items():
        lines = at.get(key, [])
        if lines and shape.kind in ("topic", "service", "action") and is_plain(shape, lines):
            ties = frozenset(_tie(line, key) for line in lines)
            bundles.setdefault((shape.kind, shape.matched, ties), []).append(key)
    several = {members[0]: members for members in bundles.values() if len(members) >= FEWEST_SHARED}
    savings = {first: (len(members) - 1) * len(at[first]) for first, members in several.items()}
    chosen = {first: several[first] for first in sorted(enough(savings, most))}
    named: dict[Key, Sequence[Key]] = {("ends", f"{key[1]} and other {key[0]}s"): chosen[key] for key in chosen}
    return _bundled(diagram, at, named)


def enough(savings: Mapping[_Name, int], most: int) -> Iterator[_Name]:
    """What saves most lines, one after the other, until ``most`` are saved, in whole tens: so a line more changes
    something elsewhere one time in ten."""
    most = in_tens(most)
    for key in sorted(savings, key=lambda key: (-savings[key], key)):
        if most <= 0:
            return
        yield key
        most -= savings[key]


def in_tens(number: int) -> int:
    """The next ten that is no smaller; 0 for nothing and less."""
    return max(0, -(-number // 10) * 10)


def without_single_nodes(diagram: Diagram) -> Diagram:
    """The diagram with one shape for the nodes of a frame that no line ties to others, and in which the same is named;
    another for what is no node.  What has a finding stays."""
    tied = {key for line in diagram.lines for key in line.ends}
    single: dict[tuple[str, tuple[str, ...]], list[Key]] = {}
    frames = diagram.frames
    for key, shape in diagram.shapes.items():
        marked = shape.badges or shape.remarks or shape.tone != ("aside" if shape.helper else "node")
        if key[0] == NODE and shape.kind == "node" and key not in tied and not marked:
            place = (UNOWNED, ()) if shape.helper else (frames.get(key, ""), shape.named)
            single.setdefault(place, []).append(key)
    shapes, groups = dict(diagram.shapes), dict(diagram.groups)
    for (title, named), members in sorted(single.items()):
        if len(members) < FEWEST:
            continue
        key = ("ends", f"{title} single nodes{', '.join(['', *named])}")
        listed = [shapes.pop(member) for member in members]
        shapes[key] = _helpers(key, listed) if title == UNOWNED else _single_nodes(key, listed)
        if title:
            groups[key] = title
    return replace(diagram, shapes=shapes, groups={key: title for key, title in groups.items() if key in shapes})


def lines_at(diagram: Diagram) -> dict[Key, list[Line]]:
    at: dict[Key, list[Line]] = {}
    for line in diagram.lines:
        for key in dict.fromkeys(line.ends):
            at.setdefault(key, []).append(line)
    return at


def is_plain_line(line: Line) -> bool:
    """Whether there is nothing to be said of a line but that it is there."""
    return line.directed and not (line.broken or line.held_back or line.badges or line.differs or line.cycle)


def is_plain(shape: Shape, lines: Iterable[Line]) -> bool:
    return not (shape.badges or shape.remarks or shape.tone != shape.kind) and all(map(is_plain_line, lines))


def _tie(line: Line, key: Key) -> Tie:
    sends = line.head == key
    return line.tail if sends else line.head, sends, line.stroke, line.labels


def _bundled(diagram: Diagram, at: Mapping[Key, Sequence[Line]], bundles: Mapping[Key, Sequence[Key]]) -> Diagram:
    """The diagram with a shape in place of each bundle's members, whose lines lead to the same nodes."""
    shapes, lines = dict(diagram.shapes), dict.fromkeys(diagram.lines)
    groups = dict(diagram.groups)
    for key, members in bundles.items():
        shapes[key] = _ends(key, [shapes.pop(member) for member in members])
        if members[0] in groups:
            groups[key] = groups[members[0]]
        for member in members:
            for line in at[member]:
                del lines[line]
        lines |= dict.fromkeys(_joined(key, members, at))
    return replace(
        diagram,
        shapes=shapes,
        lines=tuple(lines),
        groups={key: title for key, title in groups.items() if key in shapes},
    )


def _ends(key: Key, members: Sequence[Shape]) -> Shape:
    kind = members[0].kind
    names = [member.title for member in members]
    return Shape(
        key,
        "ends",
        counted(len(names), kind),
        _listed(names),
        tone=members[0].tone,
        stroke=members[0].stroke,
        details=tuple(f"{member.title}: {', '.join(member.details)}" for member in members),
        matched=members[0].matched,
        groups=members[0].groups,
        holds={kind: len(names)},
    )


def _single_nodes(key: Key, members: Sequence[Shape]) -> Shape:
    names = [f"{member.title} ({', '.join(member.lines)})" if member.lines else member.title for member in members]
    named = members[0].named
    return Shape(
        key,
        "ends",
        f"{counted(len(names), 'node')}, {'each with' if named else 'each alone'}",
        _listed(names),
        named,
        details=tuple(f"{member.title}: {', '.join(member.details)}" for member in members),
        groups=members[0].groups,
        holds={NODE: len(names)},
    )


def _helpers(key: Key, members: Sequence[Shape]) -> Shape:
    """Each with what is named in it."""
    rows = [row for member in members for row in (member.title, *(f"   {words}" for words in member.named))]
    return Shape(
        key,
        "ends",
        f"{len(members)} that are no nodes, each alone",
        tuple(rows),
        tone="aside",
        stroke="dashed",
        details=tuple(f"{member.title}: {', '.join(member.details)}" for member in members),
        groups=members[0].groups,
        helper=True,
    )


def _listed(names: Sequence[str]) -> tuple[str, ...]:
    more = [f"and {len(names) - MOST_NAMES} more"] if len(names) > MOST_NAMES else []
    return (*names[:MOST_NAMES], *more)


def _joined(key: Key, members: Sequence[Key], at: Mapping[Key, Sequence[Line]]) -> Iterator[Line]:
    """A line for each node that the members have in common, in each direction."""
    ties: dict[tuple[Key, bool], list[Line]] = {}
    for member in members:
        for line in at[member]:
            sends = line.head == member
            ties.setdefault((line.tail if sends else line.head, sends), []).append(line)
    for (node, sends), lines in ties.items():
        labels, strokes = ({line.labels for line in lines}, {line.stroke for line in lines})
        yield replace(
            lines[0],
            tail=node if sends else key,
            head=key if sends else node,
            labels=lines[0].labels if len(labels) == 1 else (),
            stroke=lines[0].stroke if len(strokes) == 1 else "dashed",
            details=tuple(words for line in lines for words in line.details),
        )


__all__ = ["enough", "gathered", "in_tens", "is_plain", "is_plain_line", "lines_at", "shared", "without_single_nodes"]
