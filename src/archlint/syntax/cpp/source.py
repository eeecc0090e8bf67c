"""The bytes of a C++ file as the parser gets them, and where its nodes are in the text."""

from __future__ import annotations

import re
from bisect import bisect_left
from functools import cache, cached_property
from typing import TYPE_CHECKING

import tree_sitter
import tree_sitter_cpp

from archlint.syntax.cpp.preprocessor import with_whole_branches

if TYPE_CHECKING:
    from tree_sitter import Node, Parser, Tree

    from archlint.syntax.facts import Span

_EXPORT_MACRO = re.compile(
    rb"\b(?!RMW_)[A-Z][A-Z0-9_]*_(?:PUBLIC|PUBLIC_TYPE|EXPORT|EXPORTS|LOCAL|API|HIDDEN|VISIBILITY)(?=\s+[A-Za-z_~])"
)
"""``DEMO_NODES_CPP_PUBLIC``: the grammar knows no macro in front of a class or a function."""
_MACRO_OF_CLASS = re.compile(rb"\b(?:class|struct)\s+([A-Z][A-Z0-9_]{3,})\s+(?=[A-Za-z_]\w*\s*(?:final\s*)?[:{])")
_QT_MACRO = re.compile(rb"\bQ_(?:OBJECT|GADGET)\b|^[ \t]*(?:Q_SIGNALS|signals)\s*:", re.M)
_QT_SLOTS = re.compile(rb"\b(?:public|protected|private)\s+(Q_SLOTS|slots)\s*:")
_POINT_MACRO = re.compile(
    rb"\b(?:PCL_ADD_\w+|(?:EIGEN|PCL)_MAKE_ALIGNED_OPERATOR_NEW|EIGEN_ALIGN(?:16|32|64|_MAX)?)\b(?!\s*\()"
)
"""What types of points are written with, as ``EIGEN_ALIGN16`` behind the struct."""
_MODULE_MACRO = re.compile(
    rb"^[ \t]*RCLCPP_(?:SMART_PTR\w*|SHARED_PTR\w*|UNIQUE_PTR\w*|WEAK_PTR\w*|DISABLE_COPY)\([^()\n]*\)", re.M
)


@cache
def _parser() -> Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_cpp.language()))


def parse(data: bytes) -> Tree:
    """The tree of a file.  Damaged code has nodes of the type ``ERROR`` where it is not understood."""
    for pattern, group in (
        (_EXPORT_MACRO, 0),
        (_MACRO_OF_CLASS, 1),
        (_QT_MACRO, 0),
        (_QT_SLOTS, 1),
        (_POINT_MACRO, 0),
        (_MODULE_MACRO, 0),
    ):
        data = pattern.sub(lambda match, group=group: _blanked(match, group), data)  # type: ignore[misc]
    return _parser().parse(with_whole_branches(data))


def _blanked(match: re.Match[bytes], group: int) -> bytes:
    """The match with white space in place of a group, so that all places stay the same."""
    start, end = match.start(group) - match.start(), match.end(group) - match.start()
    return match[0][:start] + b" " * (end - start) + match[0][end:]


class SourceText:
    """A file's bytes, and its spans: lines and columns from 1, columns in characters."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self._lines = None if data.isascii() else data.split(b"\n")
        self._continued: dict[int, list[int]] = {}
        """For each line that was asked for, the columns of the bytes that continue a character."""

    @cached_property
    def words(self) -> str:
        """The whole text."""
        return self.data.decode("utf-8", "replace")

    def text(self, node: Node) -> str:
        """What a node says, as it is written."""
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


__all__ = ["FixedText", "SourceText", "parse"]
