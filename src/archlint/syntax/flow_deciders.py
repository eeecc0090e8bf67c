"""Which blocks of a control flow graph decide whether another one runs, as long as nothing raises.

One way on from such a block leads there for certain, another may not.  Inside a loop each round counts by itself: where
it ends, the loop ends as far as its own blocks are concerned.
"""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax.dominators import immediate_dominators
from archlint.syntax.flow_blocks import Block, Edge, Kind, Loop, without_exceptions

MOST = 100
"""As many are told of a block, the nearest ones."""


class Deciders:
    """The deciders of a graph in which each block is there once, as no ``finally`` has copies."""

    def __init__(self, blocks: Sequence[Block]) -> None:
        self._blocks = blocks
        self._regions: dict[Loop | None, dict[Block, list[Block]]] = {}

    def of(self, target: Block) -> set[Block]:
        """What decides about a block, and what decides about these."""
        deciders: set[Block] = set()
        inner: Loop | None = None
        for loop in (*reversed(target.loops), None):
            region = self._region(loop)
            waiting = [target]
            for block in waiting:
                for decider in region.get(block, ()):
                    if decider not in deciders and inner not in decider.loops and len(deciders) < MOST:
                        deciders.add(decider)
                        waiting.append(decider)
            if loop is not None:
                inner, target = loop, loop.head
        return deciders

    def _region(self, loop: Loop | None) -> dict[Block, list[Block]]:
        """For each block of a loop, or of the whole graph, what decides whether it runs in one round of it."""
        if loop not in self._regions:
            blocks = self._blocks if loop is None else loop.blocks
            self._regions[loop] = _Region(loop, blocks).deciders()
        return self._regions[loop]


class _Region:
    """One round of a loop, or the whole graph once."""

    def __init__(self, loop: Loop | None, blocks: Sequence[Block]) -> None:
        self._end = Block()
        self._blocks = blocks
        inside = set(blocks)
        self._onward = {block: self._ways(block, loop, inside) for block in blocks}
        self._back: dict[Block, list[Block]] = {self._end: []}
        for block, targets in self._onward.items():
            for target in targets:
                self._back.setdefault(target, []).append(block)
        self._let_circles_end()

    def _ways(self, block: Block, loop: Loop | None, inside: set[Block]) -> list[Block]:
        onward = [edge for edge in block.edges if without_exceptions(edge)]
        targets = [self._end if _leaves(edge, loop, inside) else edge.target for edge in onward]
        return list(dict.fromkeys(targets or [self._end]))

    def _let_circles_end(self) -> None:
        """An endless loop counts as an end: what is behind it never runs."""
        ending = self._reaching_end()
        for block in self._blocks:
            if block not in ending and any(edge.kind is Kind.BACK for edge in block.edges):
                self._onward[block].append(self._end)
                self._back[self._end].append(block)

    def _reaching_end(self) -> set[Block]:
        waiting, reached = [self._end], {self._end}
        while waiting:
            for source in self._back.get(waiting.pop(), ()):
                if source not in reached:
                    reached.add(source)
                    waiting.append(source)
        return reached

    def deciders(self) -> dict[Block, list[Block]]:
        """Where the ways on from a block part: it decides about all that comes before they meet again."""
        meets = immediate_dominators(self._end, lambda block: self._back.get(block, ()))
        deciders: dict[Block, list[Block]] = {}
        for block in self._blocks:
            if len(self._onward[block]) > 1:
                for target in self._onward[block]:
                    while target is not meets.get(block):
                        deciders.setdefault(target, []).append(block)
                        target = meets[target]
        return deciders


def _leaves(edge: Edge, loop: Loop | None, inside: set[Block]) -> bool:
    return edge.target not in inside or (loop is not None and edge.target is loop.head and edge.kind is Kind.BACK)


__all__ = ["MOST", "Deciders"]
