"""The text of a C++ file, and where the parser's nodes are in it."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tree_sitter import Node

    from archlint.syntax.facts import Span


class SourceText:
    """A file's bytes, and its spans: lines and columns from 1, columns in characters."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self._lines = None if data.isascii() else data.split(b"\n")
        self._continued: dict[int, list[int]] = {}
        """For each line that was asked for, the columns of the bytes that continue a character."""
        self._renamed: dict[int, str] = {}
        self.joined: set[Span] = set()
        """The references that are called what they refer to."""

    def rename(self, starts: Iterable[int], name: str) -> None:
        """The variables that are named there are called otherwise."""
        self._renamed |= dict.fromkeys(starts, name)

    def as_written(self) -> None:
        """All variables are called what the code calls them."""
        self._renamed, self.joined = {}, set()

    @cached_property
    def words(self) -> str:
        """The whole text."""
        return self.data.decode("utf-8", "replace")

    def text(self, node: Node) -> str:
        """What a node says, as it is written."""
        if self._renamed and node.start_byte in self._renamed and node.type == "identifier":
            return self._renamed[node.start_byte]
        return self.data[node.start_byte : node.end_byte].decode("utf-8", "replace")

    def span(self, node: Node) -> Span:
        """Where a node is."""
        return self.between(node, node)

    def between(self, first: Node, last: Node) -> Span:
        """From the start of one node to the end of another."""
        row, column = first.start_point
        end_row, end_column = last.end_point
        if self._lines is not None:
            column, end_column = self._characters(row, column), self._characters(end_row, end_column)
        return row + 1, column + 1, end_row + 1, end_column + 1

    def _characters(self, row: int, column: int) -> int:
        assert self._lines is not None
        continued = self._continued.get(row)
        if continued is None:
            continued = self._continued[row] = _continuing(self._lines[row])
        return column - bisect_left(continued, column)


class FixedText(SourceText):
    """Code that a macro stands for: all of it is where the macro is used."""

    def __init__(self, span: Span) -> None:
        super().__init__(b"")
        self._span = span

    def text(self, node: Node) -> str:
        return (node.text or b"").decode("utf-8", "replace")

    def between(self, first: Node, last: Node) -> Span:
        return self._span


def _continuing(line: bytes) -> list[int]:
    """The columns of the bytes that continue a character; none for a line that is not UTF-8, where a byte is one."""
    try:
        line.decode()
    except UnicodeDecodeError:
        return []
    return [column for column, byte in enumerate(line) if 0x80 <= byte < 0xC0]


__all__ = ["FixedText", "SourceText"]
