"""Dominators, held against leaving out each place in turn."""

from __future__ import annotations

from collections.abc import Iterable

from hypothesis import given, settings
from hypothesis import strategies as st

from archlint.syntax.dominators import immediate_dominators

PLACES = 9
numbers = st.integers(0, PLACES - 1)


def reached(edges: Iterable[tuple[int, int]], without: int | None = None) -> set[int]:
    seen = {0} - {without}
    while more := {target for source, target in edges if source in seen and target != without} - seen:
        seen |= more  # type: ignore[arg-type]
    return seen  # type: ignore[return-value]


@settings(max_examples=400, deadline=None)
@given(st.lists(st.tuples(numbers, numbers), max_size=24))
def test_each_place_stands_behind_the_last_one_that_every_way_comes_by(edges: list[tuple[int, int]]) -> None:
    above = immediate_dominators(0, lambda place: [target for source, target in edges if source == place])
    assert set(above) == reached(edges) - {0}
    for place in above:
        chain = [place]
        while chain[-1]:
            chain.append(above[chain[-1]])
        assert set(chain[1:]) == {other for other in range(PLACES) if place not in reached(edges, other)} - {place}


def test_a_place_with_as_many_ways_to_it_as_there_are_others_takes_no_longer_than_the_rest() -> None:
    looked = 0

    def of(many: int) -> int:
        """A row of places, each of which may lead to the last one, too: where all exceptions go, say."""
        nonlocal looked
        looked = 0

        def onward(place: int) -> list[int]:
            nonlocal looked
            looked += 1
            return [] if place == many else [place + 1, many]

        assert immediate_dominators(0, onward)[many] == 0
        return looked

    assert of(4000) < 2.1 * of(2000)
