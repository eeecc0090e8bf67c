"""The search for circles of servers, each of which waits for the next one."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol, TypeVar

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

MOST_STEPS = 1_000_000
"""Steps of ways that are gone along in the search for circles: enough for one of a hundred services."""

Key = tuple[str, str]
"""Kind of server and full name."""


class Waits(Protocol):
    """What one server has to wait for before it answers."""

    @property
    def server(self) -> Endpoint: ...
    @property
    def target(self) -> Key: ...


_Edge = TypeVar("_Edge", bound=Waits)


class Steps:
    """How many steps may still be gone along, of all ways together."""

    def __init__(self) -> None:
        self.left = MOST_STEPS


def circles(
    edges: Mapping[Key, Sequence[_Edge]], system: System, identity: Callable[[Sequence[_Edge]], frozenset[object]]
) -> Iterator[list[_Edge]]:
    """The shortest circle of each wait, those of one ``identity`` once."""
    seen: set[frozenset[object]] = set()
    steps = Steps()
    for start in sorted(edges):
        for first in edges[start]:
            circle = shortest_circle(first, start, edges, system, steps)
            if circle and (same := identity(circle)) not in seen:
                seen.add(same)
                yield circle


def shortest_circle(
    first: _Edge, start: Key, edges: Mapping[Key, Sequence[_Edge]], system: System, steps: Steps
) -> list[_Edge]:
    """The shortest circle that begins with a wait and comes back to ``start``; empty where there is none.

    Each server is reached once, over the way that was found first: there are more circles than anybody can list where
    all handlers ask each other, and each wait of them is in its shortest one.
    """
    ways: dict[Key, list[_Edge]] = {first.target: [first]}
    waiting = deque(ways)
    while waiting:
        target = waiting.popleft()
        way = ways[target]
        if target == start:
            return way
        steps.left -= len(way)
        if steps.left < 0:
            return []
        for edge in edges.get(target, ()):
            node = edge.server.node
            together = all(node is step.server.node or system.may_coexist(node, step.server.node) for step in way)
            if together and edge.target not in ways:
                ways[edge.target] = [*way, edge]
                waiting.append(edge.target)
    return []


__all__ = ["MOST_STEPS", "Key", "Steps", "Waits", "circles", "shortest_circle"]
