"""Facts: what one Python file says, lowered to data.

A file is lowered once and cached by the hash of its content, so nothing here may depend on the file's
path, on another file, or on the configuration.  The language is Python's own, made small: statements that
can change what a node does, and expressions with their source spans.  Formatting, comments and docstrings
are gone; ``archlint: ignore`` comments are kept beside the body.

A span is ``(line, column, end_line, end_column)``: lines and columns start at 1, columns count characters,
and the end column is exclusive.
"""

from __future__ import annotations

from typing import Union

import msgspec

from archlint.syntax.expressions import (
    Argument,
    Assigned,
    Attribute,
    Await,
    Base,
    Binary,
    Boolean,
    Call,
    Compare,
    Comprehension,
    Conditional,
    Constant,
    Expr,
    Field,
    FormatString,
    Generator,
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

FACTS_VERSION = 6
"""Raised whenever the shape or the meaning of the facts changes: old cache entries are then misses."""


class Assign(Base, frozen=True, tag="="):
    """``targets[0] = targets[1] = value``; targets are Name, Attribute, Subscript, Sequence or Starred."""

    targets: list[Expr]
    value: Expr
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return self.targets


class Annotated(Base, frozen=True, tag=":"):
    """``target: annotation [= value]``."""

    target: Expr
    annotation: Expr
    value: Expr | None
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class Augmented(Base, frozen=True, tag="+="):
    """``target op= value``; ``op`` without the equals sign."""

    target: Expr
    op: str
    value: Expr
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class Expression(Base, frozen=True, tag="expr"):
    value: Expr
    span: Span


class Return(Base, frozen=True, tag="return"):
    value: Expr | None
    span: Span

    @property
    def jumps(self) -> bool:
        return True


class Raise(Base, frozen=True, tag="raise"):
    value: Expr | None
    span: Span

    @property
    def jumps(self) -> bool:
        return True


class If(Base, frozen=True, tag="if"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span


class For(Base, frozen=True, tag="for"):
    target: Expr
    iterable: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    is_async: bool
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class While(Base, frozen=True, tag="while"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span


class WithItem(Base, frozen=True):
    value: Expr
    target: Expr | None = None


class With(Base, frozen=True, tag="with"):
    items: list[WithItem]
    body: list[Stmt]
    is_async: bool
    span: Span


class Handler(Base, frozen=True):
    """``except type as name``; ``type`` is None for a bare ``except``."""

    type: Expr | None
    name: str | None
    body: list[Stmt]
    span: Span


class Try(Base, frozen=True, tag="try"):
    body: list[Stmt]
    handlers: list[Handler]
    orelse: list[Stmt]
    final: list[Stmt]
    span: Span


class Pattern(Base, frozen=True):
    """A ``case`` pattern.

    ``kind``: ``value`` (compare with ``value``), ``capture`` (bind ``name``; ``None`` is the wildcard),
    ``or`` (any of ``parts``), ``sequence`` (``parts``), ``as`` (``parts[0]`` bound to ``name``), ``mapping``
    (parts are ``entry`` with a key as ``value`` and a pattern, and at most one ``rest``), ``other``.
    """

    kind: str
    value: Expr | None = None
    name: str | None = None
    parts: list[Pattern] = msgspec.field(default_factory=list)


class Case(Base, frozen=True):
    pattern: Pattern
    guard: Expr | None
    body: list[Stmt]


class Match(Base, frozen=True, tag="match"):
    subject: Expr
    cases: list[Case]
    span: Span


class Import(Base, frozen=True, tag="import"):
    """``import module [as alias]``; without an alias the first segment of ``module`` is bound."""

    module: str
    alias: str | None
    span: Span


class ImportFrom(Base, frozen=True, tag="from"):
    """``from ..module import a as b``; ``names`` holds ``(name, bound as)``; ``[("*", "*")]`` for a star."""

    module: str
    level: int
    names: list[tuple[str, str]]
    span: Span


class Global(Base, frozen=True, tag="global"):
    """``global`` and ``nonlocal``; ``kind`` says which."""

    kind: str
    names: list[str]


class Delete(Base, frozen=True, tag="del"):
    targets: list[Expr]
    span: Span


class Assert(Base, frozen=True, tag="assert"):
    test: Expr
    span: Span


class Jump(Base, frozen=True, tag="jump"):
    """``break``, ``continue`` or ``pass``."""

    kind: str
    span: Span

    @property
    def jumps(self) -> bool:
        return self.kind != "pass"


class Function(Base, frozen=True, tag="def"):
    """``name_span`` covers the name alone; ``span`` the whole definition from its first decorator's line."""

    name: str
    params: list[Param]
    body: list[Stmt]
    decorators: list[Expr]
    returns: Expr | None
    is_async: bool
    is_generator: bool
    span: Span
    name_span: Span


class Class(Base, frozen=True, tag="class"):
    name: str
    bases: list[Argument]
    body: list[Stmt]
    decorators: list[Expr]
    span: Span
    name_span: Span


Stmt = Union[
    Assign,
    Annotated,
    Augmented,
    Expression,
    Return,
    Raise,
    If,
    For,
    While,
    With,
    Try,
    Match,
    Import,
    ImportFrom,
    Global,
    Delete,
    Assert,
    Jump,
    Function,
    Class,
]


# -------------------------------------------------------------------------------------------------- a file


class Suppression(Base, frozen=True):
    """An ``# archlint: ignore[…]`` comment.

    ``line`` is where the comment stands; ``applies_to`` the first and last line it covers (the next
    statement for a comment on its own line, the whole statement it ends otherwise); ``codes`` as written.
    ``scope`` is ``line`` or ``file``.  An empty ``codes`` is a refused bare ignore, or words that only look like a
    suppression: ``not_understood`` holds them.
    """

    line: int
    column: int
    end_column: int
    applies_to: tuple[int, int]
    codes: list[str]
    scope: str = "line"
    not_understood: str = ""

    def covers(self, line: int) -> bool:
        """Whether what stands on a line is meant."""
        first, last = self.applies_to
        return self.scope == "file" or first <= line <= last


class FileProblem(Base, frozen=True):
    """Why (part of) a file could not be analysed: becomes an LNT002 finding at this place."""

    line: int
    column: int
    message: str


class Facts(Base, frozen=True):
    """All that is kept of one Python file."""

    version: int
    body: list[Stmt] = msgspec.field(default_factory=list)
    suppressions: list[Suppression] = msgspec.field(default_factory=list)
    problems: list[FileProblem] = msgspec.field(default_factory=list)
    exports: list[str] | None = None
    """``__all__`` where it is a literal list."""


def encode(facts: Facts) -> bytes:
    """Facts as MessagePack."""
    return msgspec.msgpack.encode(facts)


_DECODER: msgspec.msgpack.Decoder[Facts] | None = None


def decode(payload: bytes) -> Facts | None:
    """Facts from MessagePack; None for anything damaged, foreign or of another version."""
    global _DECODER
    if _DECODER is None:
        _DECODER = msgspec.msgpack.Decoder(Facts)
    try:
        facts = _DECODER.decode(payload)
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
    "Boolean",
    "Call",
    "Case",
    "Class",
    "Compare",
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
