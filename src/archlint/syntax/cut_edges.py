"""Which edges of a control flow graph every way to some blocks takes, in time that grows with the graph alone."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Protocol


class Edge(Protocol):
    """A way from one block to another."""

    @property
    def source(self) -> Block: ...
    @property
    def target(self) -> Block: ...


class Block(Protocol):
    """What edges lead on from."""

    @property
    def edges(self) -> Sequence[Edge]: ...


def edges_on_every_way(entry: Block, targets: Collection[Block]) -> set[Edge] | None:
    """The edges without any one of which no way leads from the entry to one of some blocks; None where none does
    anyway.

    One way is gone along from its start.  An edge of it can be done without where the blocks before the edge lead, by
    edges off that way, to a block behind it.
    """
    way = _way(entry, targets)
    if way is None:
        return None
    position = {edge.target: number for number, edge in enumerate(way, 1)} | {entry: 0}
    own = set(way)
    seen: set[Block] = set()
    farthest = 0
    certain: set[Edge] = set()
    for number, edge in enumerate(way):
        waiting = [edge.source]
        while waiting:
            for onward in waiting.pop().edges:
                target = onward.target
                if onward in own:
                    continue
                if target in targets:
                    farthest = len(way)
                elif target in position:
                    farthest = max(farthest, position[target])
                elif target not in seen:
                    seen.add(target)
                    waiting.append(target)
        if farthest <= number:
            certain.add(edge)
    return certain


def _way(entry: Block, targets: Collection[Block]) -> list[Edge] | None:
    """A shortest way."""
    came_by: dict[Block, Edge | None] = {entry: None}
    level = [entry]
    while level:
        after: list[Block] = []
        for block in level:
            if block in targets:
                return _back(came_by, block)
            for edge in block.edges:
                if edge.target not in came_by:
                    came_by[edge.target] = edge
                    after.append(edge.target)
        level = after
    return None


def _back(came_by: dict[Block, Edge | None], block: Block) -> list[Edge]:
    way: list[Edge] = []
    edge = came_by[block]
    while edge is not None:
        way.append(edge)
        edge = came_by[edge.source]
    return way[::-1]


__all__ = ["Block", "Edge", "edges_on_every_way"]
