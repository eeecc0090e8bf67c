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

FACTS_VERSION = 6
"""Raised whenever the shape or the meaning of the facts changes: old cache entries are then misses."""

Span = tuple[int, int, int, int]
Constant = Union[str, int, float, bool, None]


class Base(msgspec.Struct, frozen=True, array_like=True, gc=False):
    """Common options of every fact."""


# --------------------------------------------------------------------------------------------- expressions


class Literal(Base, frozen=True, tag="lit"):
    """A string, number, boolean or None.  Bytes, Ellipsis, complex and huge numbers are :class:`Opaque`."""

    value: Constant
    span: Span


class Name(Base, frozen=True, tag="name"):
    id: str
    span: Span


class Attribute(Base, frozen=True, tag="attr"):
    """``value.attr``; names inside classes are already mangled (``self.__x`` in ``C`` is ``_C__x``)."""

    value: Expr
    attr: str
    span: Span


class Argument(Base, frozen=True):
    """One argument of a call.  ``star`` is ``""``, ``"*"`` or ``"**"``."""

    value: Expr
    keyword: str | None = None
    star: str = ""


class Call(Base, frozen=True, tag="call"):
    func: Expr
    args: list[Argument]
    span: Span


class Subscript(Base, frozen=True, tag="sub"):
    value: Expr
    index: Expr
    span: Span


class Slice(Base, frozen=True, tag="slice"):
    lower: Expr | None
    upper: Expr | None
    step: Expr | None


class Binary(Base, frozen=True, tag="bin"):
    """``left op right`` with ``op`` as written: ``+ - * / // % ** @ << >> & | ^``."""

    op: str
    left: Expr
    right: Expr
    span: Span


class Unary(Base, frozen=True, tag="un"):
    """``op`` is ``not``, ``-``, ``+`` or ``~``."""

    op: str
    operand: Expr
    span: Span


class Boolean(Base, frozen=True, tag="bool"):
    """``a and b and c``: ``op`` is ``and`` or ``or``, chains of one operator are flat."""

    op: str
    values: list[Expr]
    span: Span


class Compare(Base, frozen=True, tag="cmp"):
    """``left op1 x op2 y``; operators as written: ``== != < <= > >= in``, ``not in``, ``is``, ``is not``."""

    left: Expr
    ops: list[str]
    comparators: list[Expr]
    span: Span


class Conditional(Base, frozen=True, tag="ifexp"):
    test: Expr
    body: Expr
    orelse: Expr
    span: Span


class Field(Base, frozen=True, tag="field"):
    """``{value!r:spec}`` inside an f-string; ``spec`` is the literal text of the format specification."""

    value: Expr
    conversion: str | None = None
    spec: str | None = None


class FormatString(Base, frozen=True, tag="fstr"):
    """An f-string; neighbouring literal parts are already joined."""

    parts: list[Union[str, Field]]
    span: Span


class Sequence(Base, frozen=True, tag="seq"):
    """A display; ``kind`` is ``tuple``, ``list`` or ``set``.  May hold :class:`Starred`."""

    kind: str
    elements: list[Expr]
    span: Span


class Mapping(Base, frozen=True, tag="dict"):
    """A dict display; a ``None`` key stands for ``**value``."""

    keys: list[Union[Expr, None]]
    values: list[Expr]
    span: Span


class Starred(Base, frozen=True, tag="star"):
    value: Expr


class Generator(Base, frozen=True):
    """One ``for target in iterable if …`` of a comprehension."""

    target: Expr
    iterable: Expr
    conditions: list[Expr]


class Comprehension(Base, frozen=True, tag="comp"):
    """``kind`` is ``list``, ``set``, ``dict`` or ``generator``; ``value`` is set for dicts only."""

    kind: str
    element: Expr
    value: Expr | None
    generators: list[Generator]
    span: Span


class Lambda(Base, frozen=True, tag="lambda"):
    params: list[Param]
    body: Expr
    span: Span


class Assigned(Base, frozen=True, tag="walrus"):
    """``(target := value)``."""

    target: Expr
    value: Expr
    span: Span


class Await(Base, frozen=True, tag="await"):
    value: Expr
    span: Span


class Yield(Base, frozen=True, tag="yield"):
    value: Expr | None
    delegated: bool
    span: Span


class Opaque(Base, frozen=True, tag="opaque"):
    """What the linker has no use for; ``what`` says it in a word for the reason of an unknown."""

    what: str
    span: Span


Expr = Union[
    Literal,
    Name,
    Attribute,
    Call,
    Subscript,
    Slice,
    Binary,
    Unary,
    Boolean,
    Compare,
    Conditional,
    FormatString,
    Sequence,
    Mapping,
    Starred,
    Comprehension,
    Lambda,
    Assigned,
    Await,
    Yield,
    Opaque,
]


class Param(Base, frozen=True):
    """A parameter; ``kind`` is ``positional_only``, ``normal``, ``star``, ``keyword_only`` or ``double_star``."""

    name: str
    kind: str
    default: Expr | None = None
    annotation: Expr | None = None


# ---------------------------------------------------------------------------------------------- statements


class Assign(Base, frozen=True, tag="="):
    """``targets[0] = targets[1] = value``; targets are Name, Attribute, Subscript, Sequence or Starred."""

    targets: list[Expr]
    value: Expr
    span: Span


class Annotated(Base, frozen=True, tag=":"):
    """``target: annotation [= value]``."""

    target: Expr
    annotation: Expr
    value: Expr | None
    span: Span


class Augmented(Base, frozen=True, tag="+="):
    """``target op= value``; ``op`` without the equals sign."""

    target: Expr
    op: str
    value: Expr
    span: Span


class Expression(Base, frozen=True, tag="expr"):
    value: Expr
    span: Span


class Return(Base, frozen=True, tag="return"):
    value: Expr | None
    span: Span


class Raise(Base, frozen=True, tag="raise"):
    value: Expr | None
    span: Span


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
    parts: list[Pattern] = []


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
    body: list[Stmt] = []
    suppressions: list[Suppression] = []
    problems: list[FileProblem] = []
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
