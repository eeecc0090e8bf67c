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

FACTS_VERSION = 1
"""Raised whenever the shape or the meaning of the facts changes: old cache entries are then misses."""

Span = tuple[int, int, int, int]
Constant = Union[str, int, float, bool, None]


class Base(msgspec.Struct, frozen=True, array_like=True, gc=False):
    """Common options of every fact."""


# --------------------------------------------------------------------------------------------- expressions


class Literal(Base, tag="lit"):
    """A string, number, boolean or None.  Bytes, Ellipsis, complex and huge numbers are :class:`Opaque`."""

    value: Constant
    span: Span


class Name(Base, tag="name"):
    id: str
    span: Span


class Attribute(Base, tag="attr"):
    """``value.attr``; names inside classes are already mangled (``self.__x`` in ``C`` is ``_C__x``)."""

    value: Expr
    attr: str
    span: Span


class Argument(Base):
    """One argument of a call.  ``star`` is ``""``, ``"*"`` or ``"**"``."""

    value: Expr
    keyword: str | None = None
    star: str = ""


class Call(Base, tag="call"):
    func: Expr
    args: list[Argument]
    span: Span


class Subscript(Base, tag="sub"):
    value: Expr
    index: Expr
    span: Span


class Slice(Base, tag="slice"):
    lower: Expr | None
    upper: Expr | None
    step: Expr | None


class Binary(Base, tag="bin"):
    """``left op right`` with ``op`` as written: ``+ - * / // % ** @ << >> & | ^``."""

    op: str
    left: Expr
    right: Expr
    span: Span


class Unary(Base, tag="un"):
    """``op`` is ``not``, ``-``, ``+`` or ``~``."""

    op: str
    operand: Expr
    span: Span


class Boolean(Base, tag="bool"):
    """``a and b and c``: ``op`` is ``and`` or ``or``, chains of one operator are flat."""

    op: str
    values: list[Expr]
    span: Span


class Compare(Base, tag="cmp"):
    """``left op1 x op2 y``; operators as written: ``== != < <= > >= in``, ``not in``, ``is``, ``is not``."""

    left: Expr
    ops: list[str]
    comparators: list[Expr]
    span: Span


class Conditional(Base, tag="ifexp"):
    test: Expr
    body: Expr
    orelse: Expr
    span: Span


class Field(Base, tag="field"):
    """``{value!r:spec}`` inside an f-string; ``spec`` is the literal text of the format specification."""

    value: Expr
    conversion: str | None = None
    spec: str | None = None


class FormatString(Base, tag="fstr"):
    """An f-string; neighbouring literal parts are already joined."""

    parts: list[Union[str, Field]]
    span: Span


class Sequence(Base, tag="seq"):
    """A display; ``kind`` is ``tuple``, ``list`` or ``set``.  May hold :class:`Starred`."""

    kind: str
    elements: list[Expr]
    span: Span


class Mapping(Base, tag="dict"):
    """A dict display; a ``None`` key stands for ``**value``."""

    keys: list[Union[Expr, None]]
    values: list[Expr]
    span: Span


class Starred(Base, tag="star"):
    value: Expr


class Generator(Base):
    """One ``for target in iterable if …`` of a comprehension."""

    target: Expr
    iterable: Expr
    conditions: list[Expr]


class Comprehension(Base, tag="comp"):
    """``kind`` is ``list``, ``set``, ``dict`` or ``generator``; ``value`` is set for dicts only."""

    kind: str
    element: Expr
    value: Expr | None
    generators: list[Generator]
    span: Span


class Lambda(Base, tag="lambda"):
    params: list[Param]
    body: Expr
    span: Span


class Assigned(Base, tag="walrus"):
    """``(target := value)``."""

    target: Expr
    value: Expr
    span: Span


class Await(Base, tag="await"):
    value: Expr
    span: Span


class Yield(Base, tag="yield"):
    value: Expr | None
    delegated: bool
    span: Span


class Opaque(Base, tag="opaque"):
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


class Param(Base):
    """A parameter; ``kind`` is ``positional_only``, ``normal``, ``star``, ``keyword_only`` or ``double_star``."""

    name: str
    kind: str
    default: Expr | None = None
    annotation: Expr | None = None


# ---------------------------------------------------------------------------------------------- statements


class Assign(Base, tag="="):
    """``targets[0] = targets[1] = value``; targets are Name, Attribute, Subscript, Sequence or Starred."""

    targets: list[Expr]
    value: Expr
    span: Span


class Annotated(Base, tag=":"):
    """``target: annotation [= value]``."""

    target: Expr
    annotation: Expr
    value: Expr | None
    span: Span


class Augmented(Base, tag="+="):
    """``target op= value``; ``op`` without the equals sign."""

    target: Expr
    op: str
    value: Expr
    span: Span


class Expression(Base, tag="expr"):
    value: Expr
    span: Span


class Return(Base, tag="return"):
    value: Expr | None
    span: Span


class Raise(Base, tag="raise"):
    value: Expr | None
    span: Span


class If(Base, tag="if"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span


class For(Base, tag="for"):
    target: Expr
    iterable: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    is_async: bool
    span: Span


class While(Base, tag="while"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span


class WithItem(Base):
    value: Expr
    target: Expr | None = None


class With(Base, tag="with"):
    items: list[WithItem]
    body: list[Stmt]
    is_async: bool
    span: Span


class Handler(Base):
    """``except type as name``; ``type`` is None for a bare ``except``."""

    type: Expr | None
    name: str | None
    body: list[Stmt]
    span: Span


class Try(Base, tag="try"):
    body: list[Stmt]
    handlers: list[Handler]
    orelse: list[Stmt]
    final: list[Stmt]
    span: Span


class Pattern(Base):
    """A ``case`` pattern.

    ``kind``: ``value`` (compare with ``value``), ``capture`` (bind ``name``; ``None`` is the wildcard),
    ``or`` (any of ``parts``), ``sequence`` (``parts``), ``as`` (``parts[0]`` bound to ``name``), ``other``.
    """

    kind: str
    value: Expr | None = None
    name: str | None = None
    parts: list[Pattern] = []


class Case(Base):
    pattern: Pattern
    guard: Expr | None
    body: list[Stmt]


class Match(Base, tag="match"):
    subject: Expr
    cases: list[Case]
    span: Span


class Import(Base, tag="import"):
    """``import module [as alias]``; without an alias the first segment of ``module`` is bound."""

    module: str
    alias: str | None
    span: Span


class ImportFrom(Base, tag="from"):
    """``from ..module import a as b``; ``names`` holds ``(name, bound as)``; ``[("*", "*")]`` for a star."""

    module: str
    level: int
    names: list[tuple[str, str]]
    span: Span


class Global(Base, tag="global"):
    """``global`` and ``nonlocal``; ``kind`` says which."""

    kind: str
    names: list[str]


class Delete(Base, tag="del"):
    targets: list[Expr]
    span: Span


class Assert(Base, tag="assert"):
    test: Expr
    span: Span


class Jump(Base, tag="jump"):
    """``break``, ``continue`` or ``pass``."""

    kind: str
    span: Span


class Function(Base, tag="def"):
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


class Class(Base, tag="class"):
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


class Suppression(Base):
    """An ``# archlint: ignore[…]`` comment.

    ``line`` is where the comment stands; ``applies_to`` the first and last line it covers (the next
    statement for a comment on its own line, the whole statement it ends otherwise); ``codes`` as written.
    ``scope`` is ``line`` or ``file``.  An empty ``codes`` is a refused bare ignore.
    """

    line: int
    column: int
    end_column: int
    applies_to: tuple[int, int]
    codes: list[str]
    scope: str = "line"


class FileProblem(Base):
    """Why (part of) a file could not be analysed: becomes an LNT002 finding at this place."""

    line: int
    column: int
    message: str


class Facts(Base):
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
