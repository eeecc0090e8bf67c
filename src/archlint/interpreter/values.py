"""What the symbolic run knows of a value.

Values are immutable; what can change (attributes, items, variables) lives in the store under the identity of
an object.  A value that cannot be known is :class:`Unknown` and says why.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import TYPE_CHECKING, ClassVar

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.modules import Module, Scope
    from archlint.syntax import facts

ALTERNATIVES = 12
"""How many alternatives a value may have before it is unknown."""

NO_PARAMETERS: frozenset[str] = frozenset()


class Value:
    """The base of all values."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Known(Value):
    """A constant of Python.

    ``via`` names the ROS parameters whose defaults (or overrides) it was made from; ``origin`` is where a
    text is written; ``kind`` is ``literal``, ``format``, ``argument_default``, ``node_name`` (made from the
    name or namespace of a node), ``path`` (a ``pathlib.Path``) or ``other``.
    """

    value: str | int | float | bool | bytes | None
    via: frozenset[str] = NO_PARAMETERS
    origin: Place | None = field(default=None, compare=False)
    kind: str = field(default="other", compare=False)

    def __eq__(self, other: object) -> bool:
        # 1, 1.0 and True are equal in Python, and quite different as a default.
        return (
            isinstance(other, Known)
            and type(self.value) is type(other.value)
            and self.value == other.value
            and self.via == other.via
        )

    def __hash__(self) -> int:
        return hash((type(self.value), self.value, self.via))


@dataclass(frozen=True, slots=True)
class Unknown(Value):
    """A value that the source does not decide, and why.  ``parameter`` is set where a ROS parameter without a
    default decides it."""

    reason: str
    parameter: str | None = None
    annotation: Value | None = field(default=None, compare=False)
    """What annotations tell of it: a class of ours, or an attribute of one."""
    name: str | None = field(default=None, compare=False)
    """The name of the variable it came in by."""


@dataclass(frozen=True, slots=True)
class Holed(Value):
    """A text with holes: ``parts`` are known pieces, ``None`` stands for what only data decides."""

    parts: tuple[str | None, ...]
    reason: str
    via: frozenset[str] = NO_PARAMETERS
    origin: Place | None = field(default=None, compare=False)

    @property
    def pattern(self) -> str:
        return "".join("*" if part is None else part for part in self.parts)


@dataclass(frozen=True, slots=True)
class OneOf(Value):
    """One of several values; which one, the source does not decide."""

    values: tuple[Value, ...]


@dataclass(frozen=True, slots=True)
class External(Value):
    """Something of a package that is not in this workspace, by its dotted name; ``via`` names the ROS parameters
    that chose it."""

    path: str
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)


@dataclass(frozen=True, slots=True)
class Builtin(Value):
    """A function or type of Python's own; ``self_value`` for methods of constants and containers."""

    name: str
    self_value: Value | None = None


@dataclass(frozen=True, slots=True, eq=False)
class ModuleValue(Value):
    module: Module


@dataclass(frozen=True, slots=True, eq=False)
class FunctionValue(Value):
    ir: facts.Function | facts.Lambda
    scope: Scope
    """The scope it closes over."""
    qualified: str
    defaults: tuple[tuple[str, Value], ...] = ()
    owner: ClassValue | None = None
    """The class whose body defines it; what ``super()`` starts from."""
    decorators: frozenset[str] = frozenset()

    @property
    def place_span(self) -> tuple[int, int, int, int]:
        return self.ir.span if not hasattr(self.ir, "name_span") else self.ir.name_span


@dataclass(frozen=True, slots=True)
class BoundMethod(Value):
    function: Value
    self_value: Value


@dataclass(frozen=True, slots=True)
class Partial(Value):
    function: Value
    args: tuple[Value, ...]
    keywords: tuple[tuple[str, Value], ...]


@dataclass(frozen=True, slots=True)
class ApiMethod(Value):
    """A method of an rclpy class, bound to a value: ``path`` is canonical (``rclpy.node.Node.create_timer``)."""

    path: str
    self_value: Value


@dataclass(frozen=True, slots=True, eq=False)
class ClassValue(Value):
    ir: facts.Class
    scope: Scope
    qualified: str
    bases: tuple[Value, ...]
    key: int
    mro: tuple[Value, ...] = ()
    """This class first; foreign bases as :class:`External`, unresolved ones as :class:`Unknown`."""
    decorators: frozenset[str] = frozenset()

    def external_bases(self) -> list[str]:
        return [base.path for base in self.mro if isinstance(base, External)]


@dataclass(frozen=True, slots=True, eq=False)
class Instance(Value):
    """An object: of a class of the workspace, or of a foreign one (then ``cls`` is :class:`External`)."""

    cls: ClassValue | External
    key: int
    place: Place | None = None
    arguments: dict[str, Value] = field(default_factory=dict)
    """What a foreign constructor was given, by parameter name or position (``"0"``)."""
    note: str = ""


@dataclass(frozen=True, slots=True)
class ListValue(Value):
    """A list, tuple or set; items are in the store, ``kind`` says which of the three; ``via`` names the ROS
    parameters that chose it among others."""

    key: int
    kind: str = "list"
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)


@dataclass(frozen=True, slots=True)
class DictValue(Value):
    """A dict; entries are in the store, ``via`` names the ROS parameters that chose it among others."""

    key: int
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)


class ForeignValue(Value):
    """What only a library makes, in a form of its own; the library says what its attributes are."""

    __slots__ = ()

    is_hashable: ClassVar[bool] = False
    """Whether the machine follows it as the key of a dict."""
    is_object: ClassVar[bool] = True
    """Whether it is certainly not None, and the same as itself alone."""
    has_content: ClassVar[bool] = False
    """Whether two of its class may be equal."""

    def identity(self, key_of: Callable[[Value], Hashable]) -> tuple[Hashable, ...] | None:
        """What tells it from others of its class, values in it by ``key_of``; None: its ``key``."""
        return None

    def kind(self) -> Hashable | None:
        """What is the same whenever the code that makes it runs; None: no more than its class."""
        return None

    def parts(self) -> tuple[Value, ...]:
        """The values that it is made of."""
        return ()


@dataclass(frozen=True, slots=True)
class AttributeOf(Value):
    """An attribute of an object of which only the class is known."""

    cls: ClassValue
    name: str


@dataclass(frozen=True, slots=True)
class AttributesValue(Value):
    """``object.__dict__``: its items are the object's attributes."""

    instance: Value


@dataclass(frozen=True, slots=True)
class SuperValue(Value):
    owner: ClassValue
    self_value: Value


@dataclass(frozen=True, slots=True)
class EachValue(Value):
    """A collection of which only this is known: every item is like ``element``, however many there are.  What a
    message has in an array of messages."""

    element: Value


@dataclass(frozen=True, slots=True, eq=False)
class PythonValue(Value):
    """A function of the run itself: called with the call's values, it returns a value."""

    name: str
    function: Callable[..., Value]


NONE = Known(None)
TRUE = Known(True)
FALSE = Known(False)


def as_default(value: Value) -> Value:
    """A text that stands in for what somebody else may say: the default of an argument, an option, a setting."""
    if isinstance(value, Known):
        return Known(value.value, value.via, value.origin, "argument_default")
    return OneOf(tuple(map(as_default, value.values))) if isinstance(value, OneOf) else value


def alternatives(value: Value) -> tuple[Value, ...]:
    return value.values if isinstance(value, OneOf) else (value,)


def one_of(values: Iterable[Value]) -> Value:
    """The value that is one of ``values``: duplicates merged, too many of them unknown."""
    found: list[Value] = []
    plain = unknown = 0
    for value in values:
        for alternative in alternatives(value):
            is_unknown = isinstance(alternative, Unknown)
            if is_unknown and unknown > 1:
                continue
            if not is_unknown and plain > ALTERNATIVES:
                return Unknown("more values than can be followed")
            if alternative not in found:
                found.append(alternative)
                unknown += is_unknown
                plain += not is_unknown
    if not found:
        return Unknown("no value")
    if len(found) == 1:
        return found[0]
    unknowns = [value for value in found if isinstance(value, Unknown)]
    if len(unknowns) > 1:
        # One unknown is enough to say so; the first reason is the one met first.
        found = [value for value in found if not isinstance(value, Unknown) or value is unknowns[0]]
        if len(found) == 1:
            return found[0]
    if len(found) > ALTERNATIVES:
        return Unknown("more values than can be followed")
    return OneOf(tuple(found))


def via(*values: Value) -> frozenset[str]:
    """The parameters that a result made from these values depends on."""
    found: frozenset[str] = NO_PARAMETERS
    for value in values:
        if isinstance(value, (Known, Holed, External, ListValue, DictValue)):
            found |= value.via
        elif isinstance(value, Unknown) and value.parameter is not None:
            found |= {value.parameter}
    return found


def with_via(value: Value, parameters: frozenset[str]) -> Value:
    """A value that these parameters chose among others."""
    if not parameters:
        return value
    if isinstance(value, (Known, Holed, External, ListValue, DictValue)):
        return replace(value, via=value.via | parameters)
    if isinstance(value, Unknown):
        return value if value.parameter is not None else replace(value, parameter=min(parameters))
    if isinstance(value, OneOf):
        return one_of(with_via(option, parameters) for option in value.values)
    return value


def reason(*values: Value) -> str:
    """Why a result made from these values is not known."""
    for value in values:
        if isinstance(value, (Unknown, Holed)):
            return value.reason
        if isinstance(value, OneOf):
            for alternative in value.values:
                if isinstance(alternative, (Unknown, Holed)):
                    return alternative.reason
    return "the value is not a constant"


TEXT_LIMIT = 16_384
"""How long the texts are that a program makes of others: no name comes near, and a loop that doubles one would
need all memory there is."""


NUMBER_BITS = 1_000
"""How large the whole numbers are that a program makes of others: every one of them fits a float and a text."""


def constant(
    value: str | int | float | bool,
    via: frozenset[str] = NO_PARAMETERS,
    kind: str = "other",
    origin: Place | None = None,
) -> Value:
    """A constant that a program makes of others; not known where it is longer or larger than is followed."""
    if isinstance(value, str) and len(value) > TEXT_LIMIT:
        return Unknown("a text too long to follow")
    if isinstance(value, int) and value.bit_length() > NUMBER_BITS:
        return Unknown("a number too large to follow")
    return Known(value, via, origin, kind)


def file_origin(*parts: Value) -> Place | None:
    """Where the name of a file is written that ends a path made of ``parts``; a suffix alone (``.yaml``) is none."""
    for part in reversed(parts):
        if isinstance(part, (Known, Holed)) and part.origin is not None:
            text = str(part.value) if isinstance(part, Known) else part.parts[-1] or ""
            if text.strip("/") and (not text.startswith(".") or "/" in text):
                return part.origin
    return None


def join_texts(parts: Sequence[Value], origin: Place | None = None) -> Value:
    """The concatenation of texts and of what ``str`` makes of other constants."""
    pieces: list[str | None] = []
    for part in parts:
        if isinstance(part, Known):
            pieces.append(str(part.value))
        elif isinstance(part, Holed):
            pieces.extend(part.parts)
        else:
            pieces.append(None)
    if sum(len(piece) for piece in pieces if piece is not None) > TEXT_LIMIT:
        return Unknown("a text too long to follow", next(iter(sorted(via(*parts))), None))
    merged: list[str | None] = []
    for known, group in groupby((piece for piece in pieces if piece != ""), key=lambda piece: piece is not None):
        merged.append("".join(piece for piece in group if piece is not None) if known else None)
    if None not in merged:
        kinds = {part.kind for part in parts if isinstance(part, Known)}
        kind = next((kind for kind in ("argument_default", "node_name") if kind in kinds), "format")
        return Known("".join(p for p in merged if p is not None), via(*parts), origin, kind)
    if merged == [None]:
        return Unknown(reason(*(p for p in parts if not isinstance(p, Known))))
    return Holed(tuple(merged), reason(*(p for p in parts if not isinstance(p, Known))), via(*parts), origin)
