"""Objects of classes, and what reaches into them by way of ``super()`` and ``__dict__``."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.interpreter.values.base import TUPLE_FIELDS, ClassValue, Items, State, Value
from archlint.interpreter.values.foreign import External
from archlint.records import dataclass
from archlint.syntax.parts import Itself

if TYPE_CHECKING:
    from archlint.finding import Place


@dataclass(frozen=True, slots=True, eq=False)
class Instance(Value):
    """An object: of a class of the workspace, or of a foreign one (then ``cls`` is :class:`External`)."""

    cls: ClassValue | External
    key: int
    place: Place | None = None
    arguments: dict[str, Value] = field(default_factory=dict)
    """What a foreign constructor was given, by parameter name or position (``"0"``)."""
    note: str = ""
    is_member: bool = field(default=False, kw_only=True)
    """Whether it is a member of an enum of the workspace."""

    @property
    def heap_key(self) -> int:
        return self.key

    @property
    def has_identity(self) -> bool:
        return True

    @property
    def own_class(self) -> ClassValue | None:
        return self.cls if isinstance(self.cls, ClassValue) else None

    @property
    def class_names(self) -> frozenset[str]:
        if not isinstance(self.cls, ClassValue):
            return frozenset({self.cls.dotted.rpartition(".")[2]})
        own = (base.ir.name for base in self.cls.classes)
        return frozenset({*own, *(path.rpartition(".")[2] for path in self.cls.external_bases())})

    def member_value(self, state: State) -> Value | None:
        """The ``value`` of a member of an enum."""
        return state.store.get(self.key, "value") if self.is_member else None

    def truth(self, state: State) -> bool | None:
        """An object is true, but where its class says otherwise: members of ``IntEnum`` are as true as they count."""
        cls = self.own_class
        if cls is None:
            return True
        value = self.member_value(state)
        if value is not None and set(cls.external_bases()) - {"enum.Enum"}:
            return value.truth(state)
        says = any(cls.lookup(state, name)[0] is not None for name in ("__bool__", "__len__"))
        return None if says else True

    def items(self, state: State) -> Items | None:
        """The items of a named tuple."""
        names = state.store.get(self.key, TUPLE_FIELDS)
        if names is None:
            return None
        fields = (state.store.get(self.key, name) for name in names)
        return Items(tuple(value for value in fields if value is not None))

    def entry_key(self) -> Hashable:
        return Itself(self)


@dataclass(frozen=True, slots=True)
class SuperValue(Value):
    """``super()`` in a method of ``owner``."""

    owner: ClassValue
    self_value: Value

    @property
    def inner(self) -> tuple[Value, ...]:
        return (self.self_value,)


@dataclass(frozen=True, slots=True)
class AttributeOf(Value):
    """An attribute of an object of which only the class is known."""

    cls: ClassValue
    name: str


@dataclass(frozen=True, slots=True)
class AttributesValue(Value):
    """``object.__dict__``: its items are the object's attributes."""

    instance: Value
