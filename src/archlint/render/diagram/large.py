"""A picture of very many nodes: groups as boxes, as far as nobody asked to see into them."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.render.diagram.collapsing import collapsed
from archlint.render.diagram.gathering import in_tens
from archlint.render.diagram.grouping import grouped, titled
from archlint.render.look import UNOWNED
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from archlint.render.diagram.model import Diagram
    from archlint.render.view import GroupBy, View

MOST_NODES = 60
"""Nodes up to which each is drawn, unless another is asked for."""
_BY: tuple[GroupBy | None, ...] = (None, "package", "folder")
OPENED = (
    f"more than {MOST_NODES} nodes: groups are boxes, small ones first; --expand '*' draws each node, "
    "--expand GLOB those of some groups"
)
"""What the caption says of that."""


def in_groups(diagram: Diagram, view: View) -> tuple[Diagram, bool]:
    """The diagram with the frames of its view, and boxes for the groups that the view collapses.  Of more than
    :data:`MOST_NODES` nodes, what is no node is one box, and so many groups of several nodes are boxes, small ones
    first, that there are no more; never those that the view expands.  The second value says whether there is one."""
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
        asked = titled(framed, view.collapse)
        open = titled(framed, view.expand) | asked
        nodes = (key for key in framed.groups if key[0] == NODE and not framed.shapes[key].helper)
        members = Counter(framed.groups[key] for key in nodes if framed.groups[key] not in open)
        too_many = _nodes(collapsed(framed, asked)) - MOST_NODES
        no_nodes = {UNOWNED} - titled(framed, view.expand) if too_many > 0 else frozenset()
        yield collapsed(framed, asked | no_nodes | {*_smallest(members, too_many)})


def _smallest(members: Mapping[str, int], too_many: int) -> Iterator[str]:
    """Titles of groups of several nodes, until as many nodes have no shape of their own as are too many, in whole tens:
    so a node more closes or opens another group one time in ten."""
    too_many = in_tens(too_many)
    for title, number in sorted(members.items(), key=lambda item: (item[1], item[0])):
        if too_many > 0 and number > 1:
            yield title
            too_many -= number - 1


def _nodes(diagram: Diagram) -> int:
    """The nodes and boxes in it."""
    return sum(shape.kind in (NODE, "group") and not shape.helper for shape in diagram.shapes.values())


__all__ = ["MOST_NODES", "OPENED", "in_groups"]
