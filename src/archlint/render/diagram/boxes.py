"""Nothing but the boxes of groups, and how much there is between them."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.diagram.collapsing import collapsed
from archlint.render.diagram.model import Line, Shape
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from archlint.render.diagram.model import Diagram, Key


OTHERS = "others"
"""The box of what is in no group, where all of them are collapsed."""


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


__all__ = ["boxes_alone"]
