"""Facts: what one Python file says, lowered to data.

A file is lowered once and cached by the hash of its content, so nothing here may depend on the file's
path, on another file, or on the configuration.  The language is Python's own, made small: statements that
can change what a node does, and expressions with their source spans.  Formatting and comments
are gone; docstrings of classes and functions and ``archlint: ignore`` comments are kept beside the body.

A span is ``(line, column, end_line, end_column)``: lines and columns start at 1, columns count characters,
and the end column is exclusive.
"""

from __future__ import annotations

import typing
from functools import cache

import msgspec

from archlint.syntax.cpp_uses import MemberUse, RefusedUse, TypedField
from archlint.syntax.expressions import (
    Argument,
    Assigned,
    Attribute,
    Await,
    Base,
    Binary,
    BinaryOperator,
    Boolean,
    Call,
    Compare,
    CompareOperator,
    Comprehension,
    Conditional,
    Constant,
    Expr,
    Field,
    FormatString,
    Generator,
    Implicit,
    Lambda,
    Literal,
    Mapping,
    Name,
    Opaque,
    Param,
    Sequence,
    Slice,
    Span,
    Starred,
    Subscript,
    Unary,
    Yield,
)
from archlint.syntax.statements import (
    Annotated,
    Assert,
    Assign,
    Augmented,
    Case,
    Class,
    Delete,
    Expression,
    For,
    Function,
    Global,
    Handler,
    If,
    Import,
    ImportFrom,
    Jump,
    Match,
    Pattern,
    Raise,
    Return,
    Statement,
    Stmt,
    Try,
    While,
    With,
    WithItem,
)

FACTS_VERSION = 34
"""Raised whenever the shape or the meaning of the facts changes: old cache entries are then misses."""


class Suppression(Base, frozen=True):
    """An ``# archlint: ignore[…]`` comment.

    ``line`` is where the comment stands; ``applies_to`` the first and last line it covers (the next
    statement for a comment on its own line, the whole statement it ends otherwise); ``codes`` as written.
    An empty ``codes`` is a refused bare ignore, or words that only look like a
    suppression: ``not_understood`` holds them.
    """

    line: int
    column: int
    end_column: int
    applies_to: tuple[int, int]
    codes: list[str]
    scope: typing.Literal["line", "file"] = "line"
    not_understood: str = ""
    listed: tuple[int, int] | None = None
    """First and last column (exclusive) of the codes with their brackets; None for a refused one."""
    closed: bool = False
    """Whether it ends by itself, as comments of XML do; one with ``#`` goes on to the end of the line."""
    reason: bool = False
    """Whether it says why, behind the codes."""

    def covers(self, line: int) -> bool:
        """Whether what stands on a line is meant."""
        first, last = self.applies_to
        return self.scope == "file" or first <= line <= last


class FileProblem(Base, frozen=True):
    """Why (part of) a file could not be analysed: becomes an LNT002 finding at this place."""

    line: int
    column: int
    message: str
    internal: bool = False
    """Whether it is archlint's own fault: an LNT003 finding then."""
    partly: bool = False
    """Whether the rest of the file was understood, and nothing says that it is wrong: information then."""


class Facts(Base, frozen=True):
    """All that is kept of one Python file."""

    version: int
    body: list[Stmt] = msgspec.field(default_factory=list)
    suppressions: list[Suppression] = msgspec.field(default_factory=list)
    problems: list[FileProblem] = msgspec.field(default_factory=list)
    exports: list[str] | None = None
    """``__all__`` where it is a literal list."""
    names: list[str] = msgspec.field(default_factory=list)
    """All names and attributes that the code uses, sorted."""
    member_uses: list[MemberUse] = msgspec.field(default_factory=list)
    """What C++ code asks of messages."""
    typed_fields: list[TypedField] = msgspec.field(default_factory=list)
    """The fields of classes of C++ that are messages."""
    refused_uses: list[RefusedUse] = msgspec.field(default_factory=list)
    """What C++ code gives rclcpp that does not compile."""

    @property
    def statements(self) -> list[Base]:
        return [*self.body]


def encode(facts: Facts) -> bytes:
    """Facts as MessagePack."""
    return msgspec.msgpack.encode(facts)


@cache
def _decoder() -> msgspec.msgpack.Decoder[Facts]:
    """Made when a file is first read from the cache, for that takes as long as reading many."""
    return msgspec.msgpack.Decoder(Facts)


def decode(payload: bytes) -> Facts | None:
    """Facts from MessagePack; None for anything damaged, foreign or of another version."""
    try:
        facts = _decoder().decode(payload)
    except (msgspec.MsgspecError, ValueError, RecursionError):
        return None
    return facts if facts.version == FACTS_VERSION else None


__all__ = [
    "FACTS_VERSION",
    "Annotated",
    "Argument",
    "Assert",
    "Assign",
    "Assigned",
    "Attribute",
    "Augmented",
    "Await",
    "Base",
    "Binary",
    "BinaryOperator",
    "Boolean",
    "Call",
    "Case",
    "Class",
    "Compare",
    "CompareOperator",
    "Comprehension",
    "Conditional",
    "Constant",
    "Delete",
    "Expr",
    "Expression",
    "Facts",
    "Field",
    "FileProblem",
    "For",
    "FormatString",
    "Function",
    "Generator",
    "Global",
    "Handler",
    "If",
    "Implicit",
    "Import",
    "ImportFrom",
    "Jump",
    "Lambda",
    "Literal",
    "Mapping",
    "Match",
    "Name",
    "Opaque",
    "Param",
    "Pattern",
    "Raise",
    "Return",
    "Sequence",
    "Slice",
    "Span",
    "Starred",
    "Statement",
    "Stmt",
    "Subscript",
    "Suppression",
    "Try",
    "Unary",
    "While",
    "With",
    "WithItem",
    "Yield",
    "decode",
    "encode",
]
