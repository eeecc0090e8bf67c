"""What every value can be asked, and what the answers are made of.

Values are immutable; what can change (attributes, items, variables) lives in the store under the identity of an
object.  A value answers for itself; where its class says nothing else, the answer is that nothing is known.
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING, ClassVar, Protocol, TypeVar, overload

from archlint.interpreter.fields import Field
from archlint.interpreter.python_classes import PLAIN_BASES
from archlint.records import dataclass
from archlint.syntax.parts import Itself

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.modules import Scope
    from archlint.origins import OriginKind
    from archlint.syntax import facts

T = TypeVar("T")

NO_PARAMETERS: frozenset[str] = frozenset()


class Heap(Protocol):
    """What can change during a run, for a value to read."""

    @overload
    def get(self, key: int, slot: str) -> Value | None: ...
    @overload
    def get(self, key: int, slot: Field[T]) -> T | None: ...


class State(Protocol):
    """What a value asks of the run that holds it."""

    @property
    def store(self) -> Heap: ...

    def are_settled(self, parameters: frozenset[str]) -> bool:
        """Whether the values of these parameters are certain while what runs now does."""


# ------------------------------------------------------------------------------------------------ any value


class Value:
    """The base of all values."""

    __slots__ = ()

    @property
    def heap_key(self) -> int | None:
        """The identity under which the store has what can change of it; None of what cannot change."""
        return None

    # ---------------------------------------------------------------------------------------- constants

    @property
    def constant(self) -> str | int | float | bool | bytes | None:
        """The constant that it is; None, too, where it is none."""
        return None

    @property
    def text(self) -> str | None:
        """The text that it is."""
        return None

    @property
    def whole_number(self) -> int | None:
        """The whole number that it is."""
        return None

    @property
    def is_none(self) -> bool:
        """Whether it certainly is ``None``."""
        return False

    @property
    def is_text(self) -> bool:
        """Whether it certainly is a text, known in full or not."""
        return False

    @property
    def pieces(self) -> tuple[str | None, ...]:
        """What ``str`` makes of it, None for each part that is not known."""
        return (None,)

    @property
    def is_closed(self) -> bool:
        """Whether it is a constant that a launch gives: reading it says that something depends on it."""
        return False

    # ----------------------------------------------------------------------------------- where it comes from

    @property
    def via(self) -> frozenset[str]:
        """The ROS parameters that it depends on."""
        return NO_PARAMETERS

    def chosen_by(self, parameters: frozenset[str]) -> Value:
        """The same where these parameters chose it among others."""
        return self

    @property
    def written_at(self) -> Place | None:
        """Where the text that it is, or ends with, is written."""
        return None

    @property
    def why_unknown(self) -> str | None:
        """Why it is not known."""
        return None

    @property
    def why_open(self) -> str | None:
        """Of one of several values, why it is not decided which."""
        return None

    def as_default(self, kind: OriginKind = "argument_default") -> Value:
        """The same, as a placeholder for what somebody else may say: the default of an argument, of a setting."""
        return self

    # ------------------------------------------------------------------------------------------ objects

    @property
    def has_identity(self) -> bool:
        """Whether it is equal to itself alone."""
        return False

    @property
    def is_object(self) -> bool:
        """Whether it certainly is not ``None``."""
        return self.has_identity

    @property
    def number_class(self) -> str | None:
        """``int`` or ``float``, of what certainly is one."""
        return None

    has_content: ClassVar[bool] = False
    """Whether two of its class may be equal that are not the same."""

    @property
    def is_callable(self) -> bool:
        """Whether it certainly can be called."""
        return False

    @property
    def own_class(self) -> ClassValue | None:
        """The class of the workspace that it is an object of."""
        return None

    @property
    def class_names(self) -> frozenset[str]:
        """The names of its class and of those that this derives from, as far as it is an object of a class."""
        return frozenset()

    @property
    def dotted(self) -> str:
        """The dotted name under which a library offers it; empty where it is nothing of a library's."""
        return ""

    @property
    def callee(self) -> Value:
        """What runs in the end when it is called, whatever is bound to it."""
        return self

    @property
    def inner(self) -> tuple[Value, ...]:
        """The values that it is made of."""
        return ()

    # ---------------------------------------------------------------------------------- what it holds

    def truth(self, state: State) -> bool | None:
        """Whether it is true; None where that is not known."""
        return True if self.is_object else None

    def items(self, state: State) -> Items | None:
        """The items that iterating yields; None where nothing is known of them."""
        return None

    def entries(self, state: State) -> Entries | None:
        """The entries of a dict; None where it is none."""
        return None

    @property
    def each(self) -> Value | None:
        """What every item of a collection is like of which no more is known."""
        return None

    def entry_key(self) -> Hashable | None:
        """What stands for it as the key of a dict; None where it is not known."""
        return None


@dataclass(frozen=True, slots=True, eq=False)
class ClassValue(Value):
    """A class of the workspace."""

    ir: facts.Class
    scope: Scope
    qualified: str
    bases: tuple[Value, ...]
    key: int
    mro: tuple[Value, ...] = ()
    """This class first; foreign bases as :class:`External`, unresolved ones as :class:`Unknown`."""
    decorators: frozenset[str] = frozenset()
    other_bases: tuple[Value, ...] = ()
    """What its bases are where another branch is taken than the one that is followed: ``try: import …``."""
    metaclass: Value | None = None

    @property
    def heap_key(self) -> int:
        return self.key

    @property
    def has_identity(self) -> bool:
        return True

    @property
    def is_callable(self) -> bool:
        return True

    @property
    def classes(self) -> list[ClassValue]:
        """Those of the classes that it derives from which are of the workspace, itself first."""
        return [base for base in self.mro if isinstance(base, ClassValue)]

    def external_bases(self) -> list[str]:
        """The dotted names of the foreign classes that it derives from."""
        return [base.dotted for base in self.mro if base.dotted]

    def lookup(self, state: State, name: str, after: Value | None = None) -> tuple[Value | None, Value]:
        """A class attribute through the MRO: ``(value, class it was found on)``; value None where it is not found.

        A foreign base that may define the name ends the search with that base.
        """
        mro = self.mro
        if after is not None:
            mro = mro[mro.index(after) + 1 :] if after in mro else ()
        for base in mro:
            if isinstance(base, ClassValue):
                value = state.store.get(base.key, name)
                if value is not None:
                    return value, base
            elif base.why_unknown is not None or (base.dotted and base.dotted not in PLAIN_BASES):
                return None, base
        return None, self

    def items(self, state: State) -> Items | None:
        """The members of an enum."""
        members = self.members(state)
        return Items(tuple(members)) if members else None

    def members(self, state: State) -> list[Value]:
        """The members of an enum; of any other class none."""
        values = (state.store.get(self.key, name) for name in state.store.get(self.key, MEMBERS) or ())
        return [value for value in values if value is not None]

    def entry_key(self) -> Hashable:
        return Itself(self)


# ---------------------------------------------------------------------------------------- what objects hold


class Items:
    """Items of a list; ``open`` where which of them there are is not known: there may be more, or, if it is
    ``exhaustive``, fewer, but no others.  Those that are ``ordered`` are the first ones of the list, and the last of
    them stands for all that follow."""

    __slots__ = ("exhaustive", "open", "ordered", "values")

    def __init__(
        self, values: tuple[Value, ...], open_: bool = False, exhaustive: bool = False, ordered: bool = False
    ) -> None:
        self.values = values
        self.open = open_
        self.exhaustive = exhaustive or not open_
        self.ordered = ordered

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Items) and self._all == other._all

    def __hash__(self) -> int:
        return hash(self._all)

    @property
    def _all(self) -> tuple[object, ...]:
        return (self.values, self.open, self.exhaustive, self.ordered)

    @property
    def size(self) -> int:
        """How many are known."""
        return len(self.values)

    @property
    def truth(self) -> bool | None:
        """Whether there are any; None where that is not known."""
        return None if self.open else bool(self.values)


class Entries:
    """Entries of a dict in order; ``open`` where there may be more than are known."""

    __slots__ = ("entries", "open")

    def __init__(self, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> None:
        self.entries = entries
        self.open = open_

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Entries) and self.entries == other.entries and self.open == other.open

    __hash__ = None  # type: ignore[assignment]

    @property
    def size(self) -> int:
        """How many are known."""
        return len(self.entries)

    @property
    def truth(self) -> bool | None:
        """Whether there are any; None where that is not known."""
        return None if self.open else bool(self.entries)

    @property
    def keys(self) -> tuple[Value, ...]:
        return tuple(key for key, _ in self.entries.values())

    @property
    def values(self) -> tuple[Value, ...]:
        return tuple(value for _, value in self.entries.values())


MEMBERS: Field[tuple[str, ...]] = Field("members of an enum")
"""Their names, in order."""
TUPLE_FIELDS: Field[tuple[str, ...]] = Field("fields of a named tuple")
"""The attributes that are the items of an object."""
