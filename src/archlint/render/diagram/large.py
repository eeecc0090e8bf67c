"""A picture of very many nodes: groups as boxes, as far as nobody asked to see into them."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.render.diagram.grouping import collapsed, grouped, titled
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterator

    from archlint.render.diagram.model import Diagram
    from archlint.render.view import GroupBy, View

MOST_NODES = 60
"""Nodes up to which each is drawn, unless another is asked for."""
_BY: tuple[GroupBy | None, ...] = (None, "package", "folder")
OPENED = (
    f"more than {MOST_NODES} nodes: groups are boxes; --expand '*' draws each node, --expand GLOB those of some groups"
)
"""What the caption says of that."""


def in_groups(diagram: Diagram, view: View) -> tuple[Diagram, bool]:
    """The diagram with the frames of its view, and boxes for the groups that the view collapses.  Of more than
    :data:`MOST_NODES` nodes, each group of several nodes is a box that the view does not expand; the second value says
    whether there is such a one."""
    framed = grouped(diagram, view.group)
    asked = collapsed(framed, titled(framed, view.collapse))
    if _nodes(asked) <= MOST_NODES:
        return asked, False
    choices = [*_boxes(diagram, view)]
    few = [boxes for boxes in choices if _nodes(boxes) <= MOST_NODES]
    boxes = few[0] if few else min(choices, key=_nodes)
    return boxes, _nodes(boxes) < _nodes(asked)


def _boxes(diagram: Diagram, view: View) -> Iterator[Diagram]:
    for by in _BY if view.group is None else (view.group,):
        framed = grouped(diagram, by)
        members = Counter(title for key, title in framed.groups.items() if key[0] == NODE)
        several = {title for title, number in members.items() if number > 1}
        yield collapsed(framed, several - titled(framed, view.expand) | titled(framed, view.collapse))


def _nodes(diagram: Diagram) -> int:
    """The nodes and boxes in it."""
    return sum(shape.kind in (NODE, "group") and not shape.helper for shape in diagram.shapes.values())


__all__ = ["MOST_NODES", "OPENED", "in_groups"]
