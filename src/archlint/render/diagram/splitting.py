"""A picture that is too large for one, as several: one for each group, and one that shows how the groups are tied."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.diagram.boxes import boxes_alone
from archlint.render.diagram.choosing import only
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from archlint.render.diagram.model import Diagram, Key

OVERVIEW = "All groups"


def split(diagram: Diagram, fits: Callable[[Diagram], bool]) -> list[tuple[str, Diagram]]:
    """The pictures with their titles.  Each shows some nodes, with all that they have; a group that is too large is
    halved until it fits, down to a single node."""
    parts = [(OVERVIEW, replace(boxes_alone(diagram), caption=diagram.caption))] if diagram.groups else []
    for title in sorted({diagram.groups.get(key, "") for key in diagram.shapes if key[0] == NODE}):
        nodes = [key for key in diagram.shapes if key[0] == NODE and diagram.groups.get(key, "") == title]
        pieces = list(_fitting(diagram, nodes, fits))
        for number, piece in enumerate(pieces, 1):
            more = f" ({number} of {len(pieces)})" if len(pieces) > 1 else ""
            parts.append((f"{title or 'Nodes'}{more}", piece))
    return parts


def _fitting(diagram: Diagram, nodes: list[Key], fits: Callable[[Diagram], bool]) -> Iterator[Diagram]:
    piece = _with_ends(diagram, nodes)
    if len(nodes) < 2 or fits(piece):
        yield piece
        return
    half = (len(nodes) + 1) // 2
    yield from _fitting(diagram, nodes[:half], fits)
    yield from _fitting(diagram, nodes[half:], fits)


def _with_ends(diagram: Diagram, nodes: list[Key]) -> Diagram:
    """Some nodes with their lines, and what these lead to."""
    own = set(nodes)
    lines = tuple(line for line in diagram.lines if own & {*line.ends})
    shown = own | {key for line in lines for key in line.ends}
    return replace(only(diagram, shown), lines=lines, caption=())


__all__ = ["split"]
