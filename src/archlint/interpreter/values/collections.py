"""Lists, tuples, sets and dicts: their items are in the store, under the identity of the collection."""

from __future__ import annotations

from dataclasses import field, replace
from typing import Literal

from archlint.interpreter.values.base import NO_PARAMETERS, Entries, Items, State, Value
from archlint.interpreter.values.choices import ENTRIES, ITEMS
from archlint.records import dataclass

ListKind = Literal["list", "tuple", "set", "generator"]


@dataclass(frozen=True)
class UnknownKey:
    """Stands for a key of a dict, or an item of a set, that is not known: no two are the same."""

    number: int


@dataclass(frozen=True, slots=True)
class ListValue(Value):
    """A list, tuple or set, or what a generator yields; ``via`` names the ROS parameters that chose it among others."""

    key: int
    kind: ListKind = "list"
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)

    @property
    def heap_key(self) -> int:
        return self.key

    @property
    def is_object(self) -> bool:
        return True

    def chosen_by(self, parameters: frozenset[str]) -> ListValue:
        return replace(self, via=self.via | parameters)

    def items(self, state: State) -> Items:
        items = state.store.get(self.key, ITEMS)
        if items is None:
            return Items((), True)
        if not self.via:
            return items
        values = tuple(item.chosen_by(self.via) for item in items.values)
        return Items(values, items.open, items.exhaustive, items.ordered)

    def truth(self, state: State) -> bool | None:
        return self.items(state).truth


@dataclass(frozen=True, slots=True)
class DictValue(Value):
    """A dict; ``via`` names the ROS parameters that chose it among others."""

    key: int
    via: frozenset[str] = field(default=NO_PARAMETERS, compare=False)

    @property
    def heap_key(self) -> int:
        return self.key

    @property
    def is_object(self) -> bool:
        return True

    def chosen_by(self, parameters: frozenset[str]) -> DictValue:
        return replace(self, via=self.via | parameters)

    def entries(self, state: State) -> Entries:
        """Its entries."""
        entries = state.store.get(self.key, ENTRIES)
        if entries is None:
            return Entries({}, True)
        if not self.via:
            return entries
        rows = {at: (key, value.chosen_by(self.via)) for at, (key, value) in entries.entries.items()}
        return Entries(rows, entries.open)

    def items(self, state: State) -> Items:
        entries = self.entries(state)
        return Items(entries.keys, entries.open)

    def truth(self, state: State) -> bool | None:
        return self.entries(state).truth


@dataclass(frozen=True, slots=True)
class EachValue(Value):
    """A collection of which only this is known: every item is like ``element``, however many there are.  What a
    message has in an array of messages or of numbers."""

    element: Value

    @property
    def each(self) -> Value:
        return self.element

    @property
    def is_object(self) -> bool:
        return True

    def truth(self, state: State) -> bool | None:
        return None

    @property
    def inner(self) -> tuple[Value, ...]:
        return (self.element,)
