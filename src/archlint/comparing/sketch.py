"""What a picture of a comparison shows: the ends that changed, and who is at the other end of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Literal

from archlint.comparing.changes import Change, Impact, Status
from archlint.comparing.ends import Ends, Placed
from archlint.comparing.graphs import KINDS, EndKind, Family, Graph
from archlint.records import dataclass

Mark = Literal["added", "removed", "changed", "same"]
_MARKS: dict[Status, Mark] = {
    Status.ADDED: "added",
    Status.REMOVED: "removed",
    Status.CHANGED: "changed",
    Status.RENAMED: "changed",
}


@dataclass(frozen=True, order=True)
class Line:
    """Between a node and a topic, service or action; ``outwards`` from the node."""

    node: str
    family: Family
    name: str
    outwards: bool


@dataclass
class Sketch:
    """The nodes that changed themselves, and the lines, each with how it changed; ``breaking`` are those that break
    something."""

    nodes: dict[str, Mark] = field(default_factory=dict)
    lines: dict[Line, Mark] = field(default_factory=dict)
    breaking: set[Line] = field(default_factory=set)


def sketch_of(
    changes: Sequence[Change], before: Mapping[str | None, Graph], after: Mapping[str | None, Graph]
) -> Sketch:
    """Of what changed, in the first system in which it did."""
    sketch = Sketch()
    context: dict[str | None, dict[tuple[EndKind, str], None]] = {}
    for change in changes:
        if change.subject == "node":
            sketch.nodes.setdefault(change.name, _MARKS[change.status])
        kind = _KINDS.get(change.subject)
        if kind is None or change.owner is None:
            kind = _FAMILIES.get(change.subject)
            if kind is not None:
                for name in (change.before, change.after):
                    if name is not None:
                        context.setdefault(change.systems[0], {})[kind, name] = None
            continue
        _add(sketch, change, kind)
        for name in dict.fromkeys((change.name, change.before if change.aspect == "name" else None)):
            if name is not None and change.systems:
                context.setdefault(change.systems[0], {})[kind, name] = None
    for system, wanted in context.items():
        _surround(sketch, wanted, Ends(before[system]), Ends(after[system]))
    return sketch


_KINDS: dict[str, EndKind] = {kind: kind for kind in KINDS}
_FAMILIES: dict[str, EndKind] = {"topic": "publisher", "service": "service", "action": "action_server"}


def _add(sketch: Sketch, change: Change, kind: EndKind) -> None:
    assert change.owner is not None
    family, outwards = KINDS[kind].family, _outwards(kind)
    line = Line(change.owner, family, change.name, outwards)
    if change.aspect == "name" and change.before is not None:
        sketch.lines.setdefault(Line(change.owner, family, change.before, outwards), "removed")
        sketch.lines.setdefault(line, "added")
    else:
        sketch.lines.setdefault(line, _MARKS[change.status])
    if change.impact == Impact.BREAKING:
        sketch.breaking.add(line)


def _outwards(kind: EndKind) -> bool:
    """In the direction of data or request."""
    return KINDS[kind].provides == (KINDS[kind].family == "topic")


def _surround(sketch: Sketch, wanted: Mapping[tuple[EndKind, str], None], before: Ends, after: Ends) -> None:
    for kind, name in wanted:
        old = {_line(placed) for placed in (*before.at(kind, name), *before.opposite(kind, name))}
        new = {_line(placed) for placed in (*after.at(kind, name), *after.opposite(kind, name))}
        for line in sorted(old | new):
            mark: Mark = "same" if line in old and line in new else "added" if line in new else "removed"
            sketch.lines.setdefault(line, mark)


def _line(placed: Placed) -> Line:
    return Line(placed.node.shown, KINDS[placed.kind].family, placed.end.name or "", _outwards(placed.kind))
