"""Patterns of several names, one below the other: the time to match them grows with the pattern times the path."""

from __future__ import annotations

from collections.abc import Callable, Sequence

NamePattern = Callable[[str], object]
"""Says of one name whether it is meant."""


def matches_names(pattern: Sequence[NamePattern | None], names: Sequence[str]) -> bool:
    """Whether a pattern means these names; None stands for any number of them, also for none.

    It goes through the pattern once, with all the places in the path that it may have come to by then.
    """
    ends = {0}
    for part in pattern:
        if part is None:
            ends = set(range(min(ends), len(names) + 1))
        else:
            ends = {end + 1 for end in ends if end < len(names) and part(names[end])}
        if not ends:
            return False
    return len(names) in ends
