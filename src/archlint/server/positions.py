"""Places of findings, and positions as the protocol counts them."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable

from lsprotocol.types import Position, Range

from archlint.place import Place

_LINE_END = re.compile(r"\r\n|\r|\n")

Units = Callable[[str], int]
"""How many units of the client's encoding a text takes."""


class Positions:
    """The positions of one text; ``units`` measures what stands on a line."""

    def __init__(self, text: str, units: Units) -> None:
        self._text = text
        self._units = units
        self._starts = [0, *(match.end() for match in _LINE_END.finditer(text))]

    def position(self, line: int, column: int) -> Position:
        """Of a line and a column, both from 1, in characters; the nearest there is where the text is shorter."""
        if line > len(self._starts):
            return self.end
        text = self._line(line)
        before = text[: column - 1]
        return Position(line - 1, len(before) if before.isascii() else self._units(before))

    def range(self, place: Place) -> Range:
        return Range(self.position(place.line, place.column), self.position(place.end_line, place.end_column))

    @property
    def whole(self) -> Range:
        return Range(Position(0, 0), self.end)

    @property
    def end(self) -> Position:
        last = len(self._starts)
        return self.position(last, len(self._line(last)) + 1)

    def column(self, position: Position) -> tuple[int, int]:
        """Line and column, both from 1, in characters, of a position of the client's."""
        line = min(position.line + 1, len(self._starts))
        text = self._line(line)
        columns = range(len(text) + 1)
        column = bisect_right(columns, position.character, key=lambda number: self._units(text[:number]))
        return line, max(column, 1)

    def _line(self, number: int) -> str:
        end = self._starts[number] if number < len(self._starts) else len(self._text)
        return self._text[self._starts[number - 1] : end].rstrip("\r\n")


__all__ = ["Positions", "Units"]
