"""Constants and texts: what is known of them, and what is made of them."""

from __future__ import annotations

import re
from collections.abc import Hashable, Iterable, Sequence
from dataclasses import field, replace
from itertools import groupby
from typing import TYPE_CHECKING

from archlint.interpreter.values.base import NO_PARAMETERS, Items, State, Value
from archlint.interpreter.values.choices import Unknown
from archlint.origins import OriginKind
from archlint.reasons import NOT_A_CONSTANT
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place

Constant = str | int | float | bool | bytes | None

TEXT_LIMIT = 16_384
"""How long the texts are that a program makes of others: no name comes near, and a loop that doubles one would
need all memory there is."""
NUMBER_BITS = 1_000
"""How large the whole numbers are that a program makes of others: every one of them fits a float and a text."""
ITERATED_TEXT = 256
"""How long a text is that a program goes through letter by letter."""


@dataclass(frozen=True, slots=True)
class Known(Value):
    """A constant of Python.

    ``via`` names the ROS parameters whose defaults (or overrides) it was made from; ``origin`` is where a
    text is written.
    """

    value: Constant
    via: frozenset[str] = NO_PARAMETERS
    origin: Place | None = field(default=None, compare=False)
    kind: OriginKind = field(default="other", compare=False)

    def __eq__(self, other: object) -> bool:
        # 1, 1.0 and True are equal in Python, and quite different as a default.
        return (
            isinstance(other, Known)
            and type(self.value) is type(other.value)
            and self.value == other.value
            and self.via == other.via
        )

    def __hash__(self) -> int:
        if self.via:  # few are like it in that; and one that a launch gives is not looked at
            return hash((self.python_type, self.via))
        return hash((type(self.value), self.value))

    @property
    def python_type(self) -> type:
        """The type of the constant."""
        return type(self.value)

    @property
    def is_true(self) -> bool:
        """The truth value of the constant, whatever parameters it comes from."""
        return bool(self.value)

    @property
    def constant(self) -> Constant:
        return self.value

    @property
    def text(self) -> str | None:
        return self.value if isinstance(self.value, str) else None

    @property
    def number_class(self) -> str | None:
        return "int" if isinstance(self.value, int) else "float" if isinstance(self.value, float) else None

    @property
    def whole_number(self) -> int | None:
        return self.value if isinstance(self.value, int) else None

    @property
    def is_none(self) -> bool:
        return self.value is None

    @property
    def is_text(self) -> bool:
        return isinstance(self.value, str)

    @property
    def pieces(self) -> tuple[str, ...]:
        return (str(self.value),)

    @property
    def written_at(self) -> Place | None:
        return self.origin if _names_file(str(self.value)) else None

    def chosen_by(self, parameters: frozenset[str]) -> Known:
        return replace(self, via=self.via | parameters)

    @property
    def shown(self) -> Known:
        """What ``str`` makes of it."""
        return Known(str(self.value), self.via)

    def joined(self, parts: Sequence[Value], origin: Place | None) -> Known | None:
        """The text that these constants make, this one among them, without looking at what a launch gives; None where
        that has to be done."""
        return None

    def as_default(self, kind: OriginKind = "argument_default") -> Known:
        return Known(self.value, self.via, self.origin, kind)

    def truth(self, state: State) -> bool | None:
        # A parameter's default is one value of many: the default decides nothing.  What a launch file sets decides
        # while the program starts; callbacks may see what was set later.
        return self.is_true if not self.via or state.are_settled(self.via) else None

    def items(self, state: State) -> Items | None:
        if not isinstance(self.value, str) or len(self.value) > ITERATED_TEXT:
            return None
        return Items(tuple(Known(character, self.via) for character in self.value))

    def entry_key(self) -> Hashable:
        return ("str" if isinstance(self.value, str) else "", self.value)


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

    @property
    def pieces(self) -> tuple[str | None, ...]:
        return self.parts

    @property
    def is_text(self) -> bool:
        return True

    @property
    def is_object(self) -> bool:
        return True

    def may_be(self, text: str) -> bool:
        """Whether a text fits the known parts, whatever stands in the holes."""
        parts = (".*" if part is None else re.escape(part) for part in self.parts)
        return re.fullmatch("".join(parts), text, re.DOTALL) is not None

    @property
    def written_at(self) -> Place | None:
        return self.origin if _names_file(self.parts[-1] or "") else None

    @property
    def why_unknown(self) -> str:
        return self.reason

    def chosen_by(self, parameters: frozenset[str]) -> Holed:
        return replace(self, via=self.via | parameters)

    def truth(self, state: State) -> bool | None:
        return True if any(self.parts) else None


NONE = Known(None)
TRUE = Known(True)
FALSE = Known(False)


def _names_file(text: str) -> bool:
    """Whether a text names a file, rather than being a suffix alone (``.yaml``)."""
    return bool(text.strip("/")) and (not text.startswith(".") or "/" in text)


def constants_of(values: Iterable[Value]) -> list[Constant] | None:
    """The constants that values are; None where one of them is none."""
    constants: list[Constant] = []
    for value in values:
        if not isinstance(value, Known):
            return None
        constants.append(value.value)
    return constants


def constant(
    value: str | int | float | bool,
    via: frozenset[str] = NO_PARAMETERS,
    kind: OriginKind = "other",
    origin: Place | None = None,
) -> Value:
    """A constant that a program makes of others; not known where it is longer or larger than is followed."""
    if isinstance(value, str) and len(value) > TEXT_LIMIT:
        return Unknown("a string too long to follow")
    if isinstance(value, int) and value.bit_length() > NUMBER_BITS:
        return Unknown("a number too large to follow")
    return Known(value, via, origin, kind)


def file_origin(*parts: Value) -> Place | None:
    """Where the name of a file is written that ends a path made of ``parts``; a suffix alone (``.yaml``) is none."""
    return next((part.written_at for part in reversed(parts) if part.written_at is not None), None)


def join_texts(parts: Sequence[Value], origin: Place | None = None) -> Value:
    """The concatenation of texts and of what ``str`` makes of other constants."""
    for part in parts:
        if part.is_closed and isinstance(part, Known):
            closed = part.joined(parts, origin)
            if closed is not None:
                return closed
    pieces = [piece for part in parts for piece in part.pieces]
    if sum(len(piece) for piece in pieces if piece is not None) > TEXT_LIMIT:
        return Unknown("a string too long to follow", next(iter(sorted(via(*parts))), None))
    if None not in pieces:
        kinds = {part.kind for part in parts if isinstance(part, Known)}
        return Known("".join(piece for piece in pieces if piece is not None), via(*parts), origin, kind_of_text(kinds))
    merged: list[str | None] = []
    for known, group in groupby((piece for piece in pieces if piece != ""), key=lambda piece: piece is not None):
        merged.append("".join(piece for piece in group if piece is not None) if known else None)
    why = reason(*(part for part in parts if not isinstance(part, Known)))
    return Unknown(why, of_class="str") if merged == [None] else Holed(tuple(merged), why, via(*parts), origin)


def kind_of_text(kinds: Iterable[OriginKind]) -> OriginKind:
    """How a text came to be that is made of others."""
    return next((kind for kind in _LASTING if kind in kinds), "format")


_LASTING: tuple[OriginKind, ...] = ("argument_default", "fallback", "node_name")
"""What a text still is that is made of such a text and others, the first of these first."""


def via(*values: Value) -> frozenset[str]:
    """The parameters that a result made from these values depends on."""
    parameters = NO_PARAMETERS
    for value in values:
        if value.via:  # few values have any
            parameters |= value.via
    return parameters


def with_via(value: Value, parameters: frozenset[str]) -> Value:
    """A value that these parameters chose among others."""
    return value.chosen_by(parameters) if parameters else value


def reason(*values: Value) -> str:
    """Why a result made from these values is not known."""
    unknown = next((why for value in values if (why := value.why_unknown) is not None), None)
    return unknown or next((why for value in values if (why := value.why_open) is not None), NOT_A_CONSTANT)


def depends_on(*values: Value) -> str | None:
    """The parameter that decides a result made from these values, the first by name; None where none does."""
    return min(via(*values), default=None)


def as_default(value: Value) -> Value:
    """A placeholder for a text that somebody else may give: the default of an argument, an option, a setting."""
    return value.as_default()
