"""The frames of a picture, and groups that are drawn as one box."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.render.diagram.model import Line, Shape
from archlint.render.look import UNOWNED, counted
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence, Set

    from archlint.finding import SeverityLabel
    from archlint.render.diagram.model import Diagram, Key
    from archlint.render.view import GroupBy

OTHERS = "others"
"""The box of what is in no group, where all of them are collapsed."""


def grouped(diagram: Diagram, by: GroupBy | None) -> Diagram:
    """The diagram with frames around what nodes have in common; without ``by``, namespaces where there are several,
    else packages.  An interface belongs to a group if all its nodes do.  What is no node has a group of its own."""
    nodes = {key: shape for key, shape in diagram.shapes.items() if key[0] == NODE}
    real = [shape for shape in nodes.values() if not shape.helper]
    criterion = by or ("namespace" if _several(real, "namespace") else "package")
    several = by is not None or _several(real, criterion)
    titles = {
        key: UNOWNED if shape.helper else shape.groups.get(criterion, "") if several else ""
        for key, shape in nodes.items()
    }
    around: dict[Key, set[str]] = {}
    for line in diagram.lines:
        for key, other in (line.ends, line.ends[::-1]):
            if key not in nodes and other in nodes:
                around.setdefault(key, set()).add(titles[other])
    for key in diagram.shapes:
        if key not in nodes:
            own = around.get(key, set())
            titles[key] = next(iter(own)) if len(own) == 1 else ""
    return replace(diagram, groups={key: title for key, title in titles.items() if title})


def _several(shapes: Iterable[Shape], by: GroupBy) -> bool:
    return len({shape.groups.get(by, "") for shape in shapes}) > 1


def titled(diagram: Diagram, patterns: Sequence[str]) -> frozenset[str]:
    """The titles of groups that have one of the patterns."""
    return titles_of({*diagram.groups.values()}, patterns)


def titles_of(titles: Iterable[str], patterns: Sequence[str]) -> frozenset[str]:
    """Those that have one of the patterns; what is in no group has no title."""
    return frozenset(title for title in titles if title and any(fnmatchcase(title, pattern) for pattern in patterns))


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


def boxes_alone(diagram: Diagram) -> Diagram:
    """Nothing but a box for each group, and how much there is between them: for what is too large to draw."""
    groups = {key: diagram.groups.get(key, OTHERS) for key in diagram.shapes if key[0] == NODE}
    own = {key: title for key, title in diagram.groups.items() if key not in groups}
    every = replace(diagram, groups=groups | own)
    boxes = collapsed(every, {*every.groups.values()})
    kept = {key: shape for key, shape in boxes.shapes.items() if shape.kind == "group"}
    return replace(boxes, shapes=kept, lines=tuple(_between(boxes, kept)), groups={})


def _between(boxes: Diagram, kept: Mapping[Key, Shape]) -> Iterable[Line]:
    """A line from box to box with the number of topics, services and actions that it stands for."""
    into: dict[Key, list[Line]] = {}
    out: dict[Key, list[Line]] = {}
    for line in boxes.lines:
        into.setdefault(line.head, []).append(line)
        out.setdefault(line.tail, []).append(line)
    streams: dict[tuple[Key, Key], list[Line]] = {}
    for key in boxes.shapes.keys() - kept.keys():
        for source in into.get(key, []):
            for target in out.get(key, []):
                if source.tail != target.head:
                    streams.setdefault((source.tail, target.head), []).append(source)
    for (tail, head), lines in sorted(streams.items()):
        kinds = Counter(line.kind for line in lines)
        labels = tuple(counted(kinds[kind], kind) for kind in ("topic", "service", "action") if kinds[kind])
        yield Line(tail, head, "topic", labels)


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


__all__ = ["boxes_alone", "collapsed", "grouped", "titled", "titles_of"]
