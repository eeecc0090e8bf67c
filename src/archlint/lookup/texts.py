"""The texts of files as the caller has them, saved or not, and what of a place in them is the name itself."""

from __future__ import annotations

import re
from collections.abc import Callable

from archlint.place import Place

TextOf = Callable[[str], "str | None"]
"""The text of a file by its shown path; None where there is none."""

_LINE_END = re.compile(r"\r\n|\r|\n")
_PYTHON = re.compile(r"""(?s)[uUrR]?(\"{3}|'{3}|"|')(.*)\1""")

_BEFORE = r"""(?:=\s*["']|:\s+["']?|^\s*-\s+["']?|^["']?|[\[,]\s*["']?)"""
_BEHIND = r"""(?=["']|\s*$|\s+#|\s*[,\]}])"""
"""What stands before and behind a value in XML and YAML."""

_VALUE = re.compile(r"""[\w-]+\s*(?:=\s*|:\s+)?(["']?)(.*)\1""")
"""``name="value"`` in XML, ``name: value`` in YAML."""


class Texts:
    """Texts by line; each is divided once."""

    def __init__(self, text_of: TextOf) -> None:
        self._text_of = text_of
        self._lines: dict[str, list[str]] = {}

    def lines(self, file: str) -> list[str]:
        """The lines of a file; none of one that is not there."""
        if file not in self._lines:
            self._lines[file] = _LINE_END.split(self._text_of(file) or "")
        return self._lines[file]

    def line(self, file: str, number: int) -> str:
        """A line by its number, from 1; empty where the file has no such line."""
        lines = self.lines(file)
        return lines[number - 1] if 0 < number <= len(lines) else ""

    def at(self, place: Place) -> str:
        """What stands at a place, with ``\\n`` between its lines."""
        if place.line == place.end_line:
            return self.line(place.file, place.line)[place.column - 1 : place.end_column - 1]
        first = self.line(place.file, place.line)[place.column - 1 :]
        between = [self.line(place.file, number) for number in range(place.line + 1, place.end_line)]
        return "\n".join([first, *between, self.line(place.file, place.end_line)[: place.end_column - 1]])

    def name_at(self, place: Place, written: str) -> Place | None:
        """Where in a place a name stands, without its quotes; None where it does not stand there as it is.

        In Python the place is that of a literal.  In XML and YAML it is an attribute, or the key of one, whose value
        may follow on the line.  It may be the place without quotes itself.
        """
        text = self.at(place)
        if text == written and self._is_quoted(place):
            return place
        if place.file.endswith(".py"):
            match = _PYTHON.fullmatch(text)
            if match is None or match[2] != written or "\\" in written:
                return None
            return _within(place, match.start(2), len(written))
        line = self.line(place.file, place.line)
        value = rf"{_BEFORE}({re.escape(written)}){_BEHIND}"
        for region in (text if place.line == place.end_line else "", line[place.column - 1 :]):
            if found_at := re.search(value, region):
                return _within(place, found_at.start(1), len(written))
        return None

    def _is_quoted(self, place: Place) -> bool:
        line = self.line(place.file, place.line)
        around = line[place.column - 2 : place.column - 1] + line[place.end_column - 1 : place.end_column]
        return around in ("''", '""')

    def inside(self, place: Place) -> Place | None:
        """What is between the quotes at a place, or behind the key there; None where it is neither a plain literal nor
        an attribute."""
        text = self.at(place)
        is_python = place.file.endswith(".py")
        match = _PYTHON.fullmatch(text) if is_python else _VALUE.fullmatch(text)
        if match is None or "\n" in text or "\\" in text:
            return None
        return _within(place, match.start(2), len(match[2]))

    def value_behind(self, key: Place, written: str) -> Place | None:
        """Where the value of a key stands, without its quotes: behind it on the same line, or on the next."""
        start = (key.end_line, key.end_column - 1)
        return self._behind(key.file, start, r"[:=]\s*", written, 2)

    def value_set(self, setting: Place, written: str) -> Place | None:
        """Where a launch file or a parameter file has the value of a parameter, by the place of its setting."""
        start = (setting.line, setting.column - 1)
        if self.at(setting).startswith("<"):
            return self._behind(setting.file, start, r"\bvalue\s*=\s*", written, 3)
        if self.at(setting) == "name":
            return self._behind(setting.file, start, r"\bvalue\s*:\s*", written, 3)
        return self.value_behind(setting, written)

    def _behind(self, file: str, start: tuple[int, int], before: str, written: str, lines: int) -> Place | None:
        """Where a value stands behind what comes ``before`` it, from a line and an offset in it on."""
        value = re.compile(rf"""{before}(["']?)({re.escape(written)})(?=\1(?:$|[\s,}}\])/>]))""")
        for line in range(start[0], start[0] + lines):
            offset = start[1] if line == start[0] else 0
            match = value.search(self.line(file, line)[offset:])
            if match is not None:
                return _within(Place(file, line, offset + 1, line, offset + 1), match.start(2), len(written))
        return None

    def is_callee(self, place: Place, line: int, column: int) -> bool:
        """Whether a position is in what is called by the call (or in the name of the element) at a place."""
        text = self.at(place)
        if place.file.endswith(".py"):
            last = text.find("(")
        else:
            word = re.match(r"<?[\w-]+", text)
            last = -1 if word is None else word.end()
        return last >= 0 and line == place.line and place.column <= column <= place.column + last


def _within(place: Place, start: int, length: int) -> Place:
    column = place.column + start
    return Place(place.file, place.line, column, place.line, column + length)


def contains(place: Place, line: int, column: int) -> bool:
    """Whether a position is in a place, or right behind it."""
    return (place.line, place.column) <= (line, column) <= (place.end_line, place.end_column)


__all__ = ["TextOf", "Texts", "contains"]
