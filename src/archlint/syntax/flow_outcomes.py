"""How conditions have come out where a block of a control flow graph runs."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import islice

from archlint.syntax.dominators import immediate_dominators
from archlint.syntax.flow_blocks import Block, Edge, reach

MOST = 100
"""As many conditions are told of a place, the nearest ones."""


class Outcomes:
    """The conditions of a graph whose outcome is not known beforehand."""

    def __init__(self, entry: Block, blocks: Sequence[Block]) -> None:
        self._entry = entry
        self._edges: list[Edge] = []
        """One for each condition and outcome, in the order of the source."""
        copies: dict[tuple[int, bool], list[Edge]] = {}
        for block in blocks:
            for edge in block.edges:
                if edge.test is not None and edge.test.truth is None:
                    copies.setdefault((id(edge.test), edge.holds), []).append(edge)
        groups = list(copies.values())
        self._order = {group[0]: number for number, group in enumerate(groups)}
        self._several = [group for group in groups if len(group) > 1]
        """What a ``finally`` asks, once for each place that it may lead on to."""
        single = {group[0] for group in groups if len(group) == 1}
        start: Block | Edge = entry
        self._above: dict[Block | Edge, Edge | None] = {start: None}
        """The last of these edges that every way to a block takes; of an edge, that before it."""
        for place, before in immediate_dominators(start, _onward).items():
            self._above[place] = before if isinstance(before, Edge) and before in single else self._above[before]

    def at(self, targets: Collection[Block]) -> list[Edge]:
        """Those that every way to some blocks takes."""
        reached = [block for block in targets if block in self._above]
        if not reached:  # no way leads there, so all that is said of every way is true
            return list(self._order) if targets else []
        first, *others = ([*islice(self._upwards(block), MOST)] for block in reached)
        edges = set(first).intersection(*others)
        for group in self._several[:MOST]:
            if reach([self._entry], lambda edge, group=group: edge not in group).isdisjoint(targets):  # type: ignore[misc]
                edges.add(group[0])
        return sorted(edges, key=self._order.__getitem__)[-MOST:]

    def _upwards(self, block: Block) -> Iterator[Edge]:
        edge = self._above[block]
        while edge is not None:
            yield edge
            edge = self._above[edge]


def _onward(place: Block | Edge) -> Iterator[Block | Edge]:
    """The places behind one: a condition that comes out so is one of its own."""
    if isinstance(place, Edge):
        yield place.target
    else:
        yield from (edge.target if edge.test is None else edge for edge in place.edges)


__all__ = ["MOST", "Outcomes"]
