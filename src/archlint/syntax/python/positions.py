"""Where every node of a libcst tree is in its file.

libcst's trees carry no positions, and its own providers cost more than twice the parse.  A code generation
pass that only counts characters costs a third of it: offsets are recorded for each node without its
surrounding white space, and turned into lines and columns when a span is asked for.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Mapping
from types import TracebackType

from libcst import (
    Comment,
    CSTNode,
    Module,
    ParenthesizedWhitespace,
    TrailingWhitespace,
)
from libcst._nodes.internal import CodegenState

from archlint.syntax.facts import Span

_NEWLINE = re.compile(r"\r\n|\n|\r")


class LineTable:
    """Offsets in a text as lines and columns, both counted from 1.

    ``shifts`` says of lines whose indentation is another one in the file how long it is here, and how long there.
    """

    def __init__(self, text: str, shifts: Mapping[int, tuple[int, int]] | None = None) -> None:
        self._shifts = shifts or {}
        self.starts = [0, *(match.end() for match in _NEWLINE.finditer(text))]
        self._line = 1
        self._start = 0
        self._next = self.starts[1] if len(self.starts) > 1 else len(text) + 1
        self._beyond = len(text) + 1

    def place(self, offset: int) -> tuple[int, int]:
        """Line and column of an offset.  Cheap when the last answer was on the same line."""
        if not self._start <= offset < self._next:
            self._line = bisect_right(self.starts, offset)
            self._start = self.starts[self._line - 1]
            self._next = self.starts[self._line] if self._line < len(self.starts) else self._beyond
        column = offset - self._start + 1
        if self._line in self._shifts:
            here, there = self._shifts[self._line]
            column = max(min(column, there + 1), column - here + there)
        return self._line, column


class Positions(CodegenState):
    """A code generation that writes nothing and remembers the offsets of each node."""

    __slots__ = ("_open", "offset", "ranges")

    def __init__(self, module: Module) -> None:
        super().__init__(default_indent=module.default_indent, default_newline=module.default_newline)
        self.offset = 0
        # By identity: the hash of a libcst node is its id, but asking for it is a call in Python.
        self.ranges: dict[int, tuple[int, int]] = {}
        self._open: list[tuple[int, CSTNode | None, int]] = []
        module._codegen(self)

    def add_token(self, value: str) -> None:
        self.offset += len(value)

    def add_indent_tokens(self) -> None:
        for token in self.indent_tokens:
            self.offset += len(token)

    # libcst enters the result of this call in a `with` statement.  The nesting of those statements is the
    # nesting of the nodes, so one object that keeps a stack does, where a generator each would cost more
    # than all the rest.
    def record_syntactic_position(  # type: ignore[override]
        self, node: CSTNode, *, start_node: CSTNode | None = None, end_node: CSTNode | None = None
    ) -> Positions:
        self._open.append((id(node), end_node, self.offset))
        return self

    def __enter__(self) -> None:
        return None

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        node, end_node, start = self._open.pop()
        if end_node is None or id(end_node) not in self.ranges:
            self.ranges[node] = (start, self.offset)
        else:
            # A suite has already passed the newline behind its last statement.
            self.ranges[node] = (start, self.ranges[id(end_node)][1])


class CommentPositions(Positions):
    """Records the comments as well, and where each logical line ends."""

    __slots__ = ("_depth", "comments", "line_ends")

    def __init__(self, module: Module) -> None:
        self.comments: list[tuple[int, str]] = []
        self.line_ends: list[int] = []
        self._depth = 0
        super().__init__(module)

    def before_codegen(self, node: CSTNode) -> None:
        kind = node.__class__
        if kind is Comment:
            self.comments.append((self.offset, node.value))  # type: ignore[attr-defined]
        elif kind is ParenthesizedWhitespace:
            self._depth += 1
        elif kind is TrailingWhitespace and not self._depth:
            self.line_ends.append(self.offset)

    def after_codegen(self, node: CSTNode) -> None:
        if node.__class__ is ParenthesizedWhitespace:
            self._depth -= 1


class SpanFinder:
    """The spans of the nodes of one module, which must outlive it."""

    def __init__(self, text: str, positions: Positions, shifts: Mapping[int, tuple[int, int]] | None = None) -> None:
        self.lines = LineTable(text, shifts)
        self._ranges = positions.ranges

    def of(self, node: CSTNode) -> Span:
        """The span of a node without the white space and the parentheses around it."""
        start, end = self._ranges[id(node)]
        place = self.lines.place
        return place(start) + place(end)

    def between(self, first: CSTNode, last: CSTNode) -> Span:
        """From the start of one node to the end of another."""
        place = self.lines.place
        return place(self._ranges[id(first)][0]) + place(self._ranges[id(last)][1])
