"""Statements, as facts say them; a part of :mod:`archlint.syntax.facts`, by whose name others speak of them."""

from __future__ import annotations

from typing import ClassVar, Literal, Union

import msgspec

from archlint.syntax.expressions import Argument, Base, BinaryOperator, Expr, Param, Span

PatternKind = Literal["value", "capture", "or", "sequence", "as", "mapping", "entry", "rest", "other"]
GlobalKind = Literal["global", "nonlocal"]
JumpKind = Literal["break", "continue", "pass"]


class Statement(Base, frozen=True):
    """What any statement can be asked."""

    @property
    def blocks(self) -> list[list[Stmt]]:
        """The blocks that it holds."""
        return []

    @property
    def statements(self) -> list[Base]:
        return [statement for block in self.blocks for statement in block]


class Assign(Statement, frozen=True, tag="="):
    """``targets[0] = targets[1] = value``; targets are Name, Attribute, Subscript, Sequence or Starred."""

    targets: list[Expr]
    value: Expr
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return self.targets


class Annotated(Statement, frozen=True, tag=":"):
    """``target: annotation [= value]``."""

    target: Expr
    annotation: Expr
    value: Expr | None
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class Augmented(Statement, frozen=True, tag="+="):
    """``target op= value``; ``op`` without the equals sign."""

    target: Expr
    op: BinaryOperator
    value: Expr
    span: Span

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class Expression(Statement, frozen=True, tag="expr"):
    value: Expr
    span: Span


class Return(Statement, frozen=True, tag="return"):
    value: Expr | None
    span: Span


class Raise(Statement, frozen=True, tag="raise"):
    value: Expr | None
    span: Span


class If(Statement, frozen=True, tag="if"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [self.body, self.orelse]


class For(Statement, frozen=True, tag="for"):
    target: Expr
    iterable: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    is_async: bool
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [self.body, self.orelse]

    @property
    def head(self) -> Expr:
        """What is evaluated before the loop, or each time round."""
        return self.iterable

    @property
    def tests(self) -> list[Expr]:
        """The conditions that keep it going, each of those that ``and`` joins; none for a ``for``."""
        return []

    @property
    def is_endless(self) -> bool:
        """Whether it is written to end by ``break``, ``return`` or ``raise`` alone."""
        return False

    @property
    def assigned(self) -> list[Expr]:
        return [self.target]


class While(Statement, frozen=True, tag="while"):
    test: Expr
    body: list[Stmt]
    orelse: list[Stmt]
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [self.body, self.orelse]

    @property
    def head(self) -> Expr:
        """What is evaluated before the loop, or each time round."""
        return self.test

    @property
    def tests(self) -> list[Expr]:
        """The conditions that keep it going, each of those that ``and`` joins; none for a ``for``."""
        return self.test.conjuncts

    @property
    def is_endless(self) -> bool:
        """Whether it is written to end by ``break``, ``return`` or ``raise`` alone: ``while True``."""
        return self.test.truth is True


class WithItem(Base, frozen=True):
    value: Expr
    target: Expr | None = None


class With(Statement, frozen=True, tag="with"):
    items: list[WithItem]
    body: list[Stmt]
    is_async: bool
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [self.body]


class Handler(Base, frozen=True):
    """``except type as name``; ``type`` is None for a bare ``except``."""

    type: Expr | None
    name: str | None
    body: list[Stmt]
    span: Span

    @property
    def caught(self) -> frozenset[str]:
        """The names that its type consists of, each without what it is an attribute of: those of its classes, wherever
        they stand in it, and those of modules.  There are none for a bare ``except``, which is for all."""
        parts: list[Base] = [] if self.type is None else [self.type]
        for part in parts:
            parts += part.children()
        return frozenset(part.last_name for part in parts) - {""}

    @property
    def statements(self) -> list[Base]:
        return [*self.body]


class Try(Statement, frozen=True, tag="try"):
    body: list[Stmt]
    handlers: list[Handler]
    orelse: list[Stmt]
    final: list[Stmt]
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [self.body, *(handler.body for handler in self.handlers), self.orelse, self.final]


class Pattern(Base, frozen=True):
    """A ``case`` pattern: ``value`` (compare with ``value``), ``capture`` (bind ``name``; ``None`` is the wildcard),
    ``or`` (any of ``parts``), ``sequence`` (``parts``), ``as`` (``parts[0]`` bound to ``name``), ``mapping``
    (parts are ``entry`` with a key as ``value`` and a pattern, and at most one ``rest``), ``other``.
    """

    kind: PatternKind
    value: Expr | None = None
    name: str | None = None
    parts: list[Pattern] = msgspec.field(default_factory=list)


class Case(Base, frozen=True):
    pattern: Pattern
    guard: Expr | None
    body: list[Stmt]

    @property
    def statements(self) -> list[Base]:
        return [*self.body]


class Match(Statement, frozen=True, tag="match"):
    subject: Expr
    cases: list[Case]
    span: Span

    @property
    def blocks(self) -> list[list[Stmt]]:
        return [case.body for case in self.cases]


class Import(Statement, frozen=True, tag="import"):
    """``import module [as alias]``; without an alias the first segment of ``module`` is bound."""

    module: str
    alias: str | None
    span: Span


class ImportFrom(Statement, frozen=True, tag="from"):
    """``from ..module import a as b``; ``names`` holds ``(name, bound as)``; ``[("*", "*")]`` for a star."""

    module: str
    level: int
    names: list[tuple[str, str]]
    span: Span


class Global(Statement, frozen=True, tag="global"):
    """``global`` and ``nonlocal``."""

    kind: GlobalKind
    names: list[str]


class Delete(Statement, frozen=True, tag="del"):
    targets: list[Expr]
    span: Span


class Assert(Statement, frozen=True, tag="assert"):
    test: Expr
    span: Span


class Jump(Statement, frozen=True, tag="jump"):
    """A statement that is one word."""

    kind: JumpKind
    span: Span


class Function(Statement, frozen=True, tag="def"):
    """``name_span`` covers the name alone; ``span`` the whole definition from its first decorator's line."""

    is_scope: ClassVar[bool] = True

    name: str
    params: list[Param]
    body: list[Stmt]
    decorators: list[Expr]
    returns: Expr | None
    is_async: bool
    is_generator: bool
    span: Span
    name_span: Span
    docstring: str = ""
    """Without its indentation, and cut where it is very long; it changes nothing that the code does."""

    @property
    def statements(self) -> list[Base]:
        return [*self.body]


class Class(Statement, frozen=True, tag="class"):
    is_scope: ClassVar[bool] = True

    name: str
    bases: list[Argument]
    body: list[Stmt]
    decorators: list[Expr]
    span: Span
    name_span: Span
    docstring: str = ""
    """As that of a function."""

    @property
    def statements(self) -> list[Base]:
        return [*self.body]


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
