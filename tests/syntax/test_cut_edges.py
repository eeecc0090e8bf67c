"""Edges that every way takes, held against leaving out each of them in turn."""

from __future__ import annotations

import itertools

from hypothesis import given, settings
from hypothesis import strategies as st

from archlint.syntax.cut_edges import edges_on_every_way
from archlint.syntax.flow_graph import Block, Edge, Kind, reach

BLOCKS = 8


def graph(pairs: list[tuple[int, int]]) -> tuple[list[Block], list[Edge]]:
    blocks = [Block() for _ in range(BLOCKS)]
    edges = [Edge(blocks[source], blocks[target], Kind.NEXT) for source, target in pairs]
    for edge in edges:
        edge.source.edges.append(edge)
    return blocks, edges


numbers = st.integers(0, BLOCKS - 1)


@settings(max_examples=400, deadline=None)
@given(st.lists(st.tuples(numbers, numbers), max_size=20), st.sets(numbers, min_size=1, max_size=3))
def test_they_are_those_without_which_no_way_is_left(pairs: list[tuple[int, int]], ends: set[int]) -> None:
    blocks, edges = graph(pairs)
    targets = {blocks[end] for end in ends}
    certain = edges_on_every_way(blocks[0], targets)
    if reach([blocks[0]]).isdisjoint(targets):
        assert certain is None
        return
    assert certain == {
        edge for edge in edges if reach([blocks[0]], lambda other, left=edge: other is not left).isdisjoint(targets)
    }


def test_each_edge_is_looked_at_a_few_times_however_many_branches_there_are() -> None:
    looked = 0

    class Counting(Block):
        __slots__ = ("ways",)

        @property
        def edges(self) -> list[Edge]:
            nonlocal looked
            looked += len(self.ways)
            return self.ways

        @edges.setter
        def edges(self, ways: list[Edge]) -> None:
            self.ways = ways

    def of(branches: int) -> int:
        nonlocal looked
        blocks = [Counting() for _ in range(branches + 1)]
        for block, after in itertools.pairwise(blocks):
            block.ways += [Edge(block, after, Kind.NEXT), Edge(block, after, Kind.NEXT)]
        looked = 0
        assert edges_on_every_way(blocks[0], {blocks[-1]}) == set()
        return looked

    assert of(400) < 2.1 * of(200)
