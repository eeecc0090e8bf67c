"""\"Did you mean\": the known word that is nearest to an unknown one."""

from __future__ import annotations

from collections.abc import Iterable


def distance(one: str, other: str, limit: int) -> int:
    """The edit distance with transpositions; anything above ``limit`` is ``limit + 1``."""
    if abs(len(one) - len(other)) > limit:
        return limit + 1
    before: list[int] = []
    row = list(range(len(other) + 1))
    for i, left in enumerate(one, start=1):
        last, before, row = before, row, [i]
        for j, right in enumerate(other, start=1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (left != right))
            if i > 1 and j > 1 and left == other[j - 2] and one[i - 2] == right:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word within a third of the word's length (at least one edit, but not all of it); the first of
    equals."""
    if len(word) > 256:
        return None
    limit = max(1, len(word) // 3)
    best: tuple[int, str] | None = None
    for candidate in sorted(set(known)):
        found = distance(word.lower(), candidate.lower(), limit)
        if found <= limit and found < len(word) and candidate != word and (best is None or found < best[0]):
            best = (found, candidate)
    return None if best is None else best[1]


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """``; did you mean 'x'?`` to put after a message, or nothing."""
    near = nearest(word, known)
    return f"; did you mean '{near}'?" if near is not None else ""
