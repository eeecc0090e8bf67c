"""Expressions, as facts say them; a part of :mod:`archlint.syntax.facts`, by whose name others speak of them."""

from __future__ import annotations

import typing
from typing import ClassVar, Union

import msgspec

from archlint.syntax.fields_with_facts import fields_with_facts

Span = tuple[int, int, int, int]
Constant = Union[str, int, float, bool, None]
Star = typing.Literal["", "*", "**"]
DisplayKind = typing.Literal["tuple", "list", "set"]
ComprehensionKind = typing.Literal["list", "set", "dict", "generator"]
BinaryOperator = typing.Literal["+", "-", "*", "/", "//", "%", "**", "@", "<<", ">>", "&", "|", "^"]
UnaryOperator = typing.Literal["not", "-", "+", "~"]
BooleanOperator = typing.Literal["and", "or"]
CompareOperator = typing.Literal["==", "!=", "<", "<=", ">", ">=", "in", "not in", "is", "is not"]
ParamKind = typing.Literal["positional_only", "normal", "star", "keyword_only", "double_star"]


class Base(msgspec.Struct, frozen=True, array_like=True, gc=False):
    """Common options of every fact, and what any fact can be asked: those that have no answer say nothing."""

    is_scope: ClassVar[bool] = False
    """Whether what is inside it has variables of its own: a function, a class."""

    def children(self) -> list[Base]:
        """The facts that it is made of, in the order of the source."""
        parts: list[Base] = []
        for name, is_list, is_mixed in fields_with_facts(type(self)):
            value = getattr(self, name)
            if is_mixed:
                parts += [item for item in value if isinstance(item, Base)]
            elif is_list:
                parts += value
            elif value is not None:
                parts.append(value)
        return parts

    @property
    def statements(self) -> list[Base]:
        """The statements that stand directly in it, in the order of the source."""
        return []

    @property
    def dotted(self) -> str:
        """A name or attribute as it is written, such as ``self.node.client``; empty for anything else."""
        return ""

    @property
    def variable(self) -> str:
        """The name of a plain variable; empty for anything else."""
        return ""

    @property
    def attribute(self) -> str:
        """``publish`` of ``self.publisher.publish``; empty for what is no attribute."""
        return ""

    @property
    def last_name(self) -> str:
        """The name of a variable or an attribute; empty for anything else."""
        return self.variable or self.attribute

    @property
    def root(self) -> Base:
        """What attributes and items are of, in the end: ``x`` of ``x.position[0].y``; anything else itself."""
        return self

    @property
    def unpacked(self) -> list[Expr]:
        """The targets that an assignment to this sets: those of a display, or just itself."""
        return [self]  # type: ignore[list-item]

    @property
    def negated(self) -> Expr | None:
        """The condition that a ``not`` stands before."""
        return None

    @property
    def conjuncts(self) -> list[Expr]:
        """The conditions that hold where this one does: those that ``and`` joins, or just itself."""
        return [self]  # type: ignore[list-item]

    @property
    def text(self) -> str | None:
        """The text of a literal."""
        return None

    @property
    def number(self) -> float | None:
        """The number of a literal, be it below zero; True and False are none."""
        return None

    @property
    def is_true(self) -> bool:
        """Whether this is the literal ``True``."""
        return False

    @property
    def truth(self) -> bool | None:
        """Whether a literal is true: ``True``, ``1``; None for what is none."""
        return None

    @property
    def assigned(self) -> list[Expr]:
        """The targets that an assignment or a ``for`` sets."""
        return []

    @property
    def jumps(self) -> bool:
        """Whether this is a statement after which nothing of its block runs."""
        return False


class Literal(Base, frozen=True, tag="lit"):
    """A string, number, boolean or None.  Bytes, Ellipsis, complex and huge numbers are :class:`Opaque`."""

    value: Constant
    span: Span

    @property
    def text(self) -> str | None:
        return self.value if isinstance(self.value, str) else None

    @property
    def number(self) -> float | None:
        number = isinstance(self.value, (int, float)) and not isinstance(self.value, bool)
        return float(self.value) if number and self.value is not None else None

    @property
    def is_true(self) -> bool:
        return self.value is True

    @property
    def truth(self) -> bool:
        return bool(self.value)


class Name(Base, frozen=True, tag="name"):
    id: str
    span: Span

    @property
    def dotted(self) -> str:
        return self.id

    @property
    def variable(self) -> str:
        return self.id


class Implicit(Base, frozen=True, tag="implicit"):
    """A name that C++ looks up in the object first, and then in the file."""

    name: str
    span: Span

    @property
    def dotted(self) -> str:
        return f"self.{self.name}"

    @property
    def attribute(self) -> str:
        return self.name


class Attribute(Base, frozen=True, tag="attr"):
    """``value.attr``; names inside classes are already mangled (``self.__x`` in ``C`` is ``_C__x``)."""

    value: Expr
    attr: str
    span: Span

    @property
    def dotted(self) -> str:
        owner = self.value.dotted
        return f"{owner}.{self.attr}" if owner else ""

    @property
    def owner(self) -> Expr:
        """What the first of several attributes in a row is read of: ``make()`` of ``make().client.name``."""
        return self.value.owner if isinstance(self.value, Attribute) else self.value

    @property
    def attribute(self) -> str:
        return self.attr

    @property
    def root(self) -> Base:
        return self.value.root


class Argument(Base, frozen=True):
    """One argument of a call."""

    value: Expr
    keyword: str | None = None
    star: Star = ""


class Call(Base, frozen=True, tag="call"):
    func: Expr
    args: list[Argument]
    span: Span


class Subscript(Base, frozen=True, tag="sub"):
    value: Expr
    index: Expr
    span: Span

    @property
    def root(self) -> Base:
        return self.value.root


class Slice(Base, frozen=True, tag="slice"):
    lower: Expr | None
    upper: Expr | None
    step: Expr | None


class Binary(Base, frozen=True, tag="bin"):
    """``left op right``."""

    op: BinaryOperator
    left: Expr
    right: Expr
    span: Span


class Unary(Base, frozen=True, tag="un"):
    """``op operand``."""

    op: UnaryOperator
    operand: Expr
    span: Span

    @property
    def negated(self) -> Expr | None:
        return self.operand if self.op == "not" else None

    @property
    def number(self) -> float | None:
        number = self.operand.number if self.op == "-" else None
        return None if number is None else -number


class Boolean(Base, frozen=True, tag="bool"):
    """``a and b and c``: chains of one operator are flat."""

    op: BooleanOperator
    values: list[Expr]
    span: Span

    @property
    def conjuncts(self) -> list[Expr]:
        return [part for value in self.values for part in value.conjuncts] if self.op == "and" else [self]


class Compare(Base, frozen=True, tag="cmp"):
    """``left op1 x op2 y``."""

    left: Expr
    ops: list[CompareOperator]
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
    """A display.  May hold :class:`Starred`."""

    kind: DisplayKind
    elements: list[Expr]
    span: Span

    @property
    def unpacked(self) -> list[Expr]:
        return self.elements


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
    """``value`` is set for dicts only."""

    kind: ComprehensionKind
    element: Expr
    value: Expr | None
    generators: list[Generator]
    span: Span


class Lambda(Base, frozen=True, tag="lambda"):
    """A function without a name, of one expression."""

    is_scope: ClassVar[bool] = True
    is_async: ClassVar[bool] = False
    is_generator: ClassVar[bool] = False
    name: ClassVar[str] = ""

    params: list[Param]
    body: Expr
    span: Span

    @property
    def name_span(self) -> Span:
        """Where it stands: nothing names it."""
        return self.span


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


_Operand = Union[Literal, Name, Implicit, Attribute, Call, Subscript, Slice, Binary, Unary, Boolean, Compare]
_Whole = Union[Conditional, FormatString, Sequence, Mapping, Starred, Comprehension, Lambda, Assigned, Await, Yield]
Expr = Union[_Operand, _Whole, Opaque]


class Param(Base, frozen=True):
    """A parameter."""

    name: str
    kind: ParamKind
    default: Expr | None = None
    annotation: Expr | None = None
    by_reference: bool = False
    """Whether what the function assigns to it is assigned to the argument, as in C++."""
