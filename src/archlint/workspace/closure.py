"""All that some things lead to, directly or not: dependencies, imports."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import TypeVar

_Item = TypeVar("_Item", bound=Hashable)


def closure(starts: Iterable[_Item], leads_to: Callable[[_Item], Iterable[_Item]]) -> frozenset[_Item]:
    """``starts`` and all that ``leads_to`` gets from them, asked once for each item."""
    waiting = list(starts)
    reached = set(waiting)
    while waiting:
        for item in leads_to(waiting.pop()):
            if item not in reached:
                reached.add(item)
                waiting.append(item)
    return frozenset(reached)


__all__ = ["closure"]
