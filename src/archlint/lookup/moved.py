"""Where the lines of a text are in a later one: an editor has the later one, and what is known is of the earlier."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from archlint.lookup.texts import Texts
from archlint.place import Place


class Moves:
    """The lines of files ``before``, as a run has read them, and ``now``.  A file has changed in one stretch of lines;
    those above it are where they were, and those below it have moved."""

    def __init__(self, before: Texts, now: Texts) -> None:
        self._before, self._now = before, now
        self._known: dict[str, tuple[int, int, int]] = {}

    def line_before(self, file: str, line: int) -> int | None:
        """The number that a line of now had; None for one that is new or has changed."""
        same, tail_starts, moved_by = self._stretch(file)
        if line <= same:
            return line
        return line - moved_by if line - moved_by > tail_starts else None

    def place_now(self, place: Place) -> Place | None:
        """Where a place is now; None where its lines have changed."""
        same, tail_starts, moved_by = self._stretch(place.file)
        if place.end_line <= same:
            return place
        if place.line > tail_starts:
            return replace(place, line=place.line + moved_by, end_line=place.end_line + moved_by)
        return None

    def places_now(self, places: Iterable[Place]) -> list[Place]:
        """Places where they are now, without those that have changed."""
        return [now for place in places if (now := self.place_now(place)) is not None]

    def _stretch(self, file: str) -> tuple[int, int, int]:
        """How many lines are the same at the start, after which line of before they are again, and by how much those
        have moved."""
        if file not in self._known:
            before, now = self._before.lines(file), self._now.lines(file)
            same = len(before) if before == now else _in_common(before, now)
            below = _in_common(before[same:][::-1], now[same:][::-1])
            self._known[file] = same, len(before) - below, len(now) - len(before)
        return self._known[file]


def _in_common(lines: Sequence[str], others: Sequence[str]) -> int:
    """How many lines two texts begin with alike."""
    pairs = enumerate(zip(lines, others, strict=False))
    return next((number for number, (line, other) in pairs if line != other), min(len(lines), len(others)))


__all__ = ["Moves"]
