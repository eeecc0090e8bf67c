"""What every way through a graph comes by, in time that grows hardly faster than the graph."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator
from typing import TypeVar

Place = TypeVar("Place", bound=Hashable)


def immediate_dominators(start: Place, onward: Callable[[Place], Iterable[Place]]) -> dict[Place, Place]:
    """For each place that is reached from the start, the last one that every way there comes by before it.

    This is the algorithm Semi-NCA (Georgiadis, Tarjan and Werneck, "Finding Dominators in Practice", 2006). The start
    itself has no entry; a place stands behind the one that dominates it.
    """
    places, parents = _depth_first(start, onward)
    number = {place: count for count, place in enumerate(places)}
    sources: list[list[int]] = [[] for _ in places]
    for count, place in enumerate(places):
        for target in onward(place):
            sources[number[target]].append(count)
    lowest = _semidominators(parents, sources)
    above = list(parents)
    for count in range(1, len(places)):
        while above[count] > lowest[count]:
            above[count] = above[above[count]]
    return {place: places[above[count]] for count, place in enumerate(places) if count}


def _semidominators(parents: list[int], sources: list[list[int]]) -> list[int]:
    """For each place the lowest one from which a way of higher ones leads to it."""
    lowest, labels, links = list(range(len(parents))), list(range(len(parents))), list(parents)
    for count in range(len(parents) - 1, 0, -1):
        others = (lowest[_label(source, count + 1, lowest, labels, links)] for source in sources[count])
        lowest[count] = min(parents[count], *others)
    return lowest


def _label(place: int, linked: int, lowest: list[int], labels: list[int], links: list[int]) -> int:
    """The place with the lowest semidominator on the way up through those that are linked; the way is made shorter."""
    way: list[int] = []
    while links[place] >= linked:
        way.append(place)
        place = links[place]
    upper = place
    for lower in reversed(way):
        links[lower] = links[upper]
        if lowest[labels[upper]] < lowest[labels[lower]]:
            labels[lower] = labels[upper]
        upper = lower
    return labels[upper]


def _depth_first(start: Place, onward: Callable[[Place], Iterable[Place]]) -> tuple[list[Place], list[int]]:
    """All places in the order of a walk that goes on before it goes back, each with the number of the one before."""
    places, parents = [start], [-1]
    seen = {start}
    waiting: list[tuple[int, Iterator[Place]]] = [(0, iter(onward(start)))]
    while waiting:
        source, targets = waiting[-1]
        target = next((target for target in targets if target not in seen), None)
        if target is None:
            waiting.pop()
        else:
            seen.add(target)
            waiting.append((len(places), iter(onward(target))))
            places.append(target)
            parents.append(source)
    return places, parents


__all__ = ["immediate_dominators"]
