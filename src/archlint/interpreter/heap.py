"""What can change during a symbolic run: variables, attributes, items.

Everything mutable is kept here under ``(object, slot)``.  An undecided branch runs on a layer of its own;
layers are joined afterwards, so that each slot is one of what the branches left in it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import chain, islice, repeat
from typing import Any, TypeVar, overload

from archlint.interpreter.fields import Field, Fields, key_in
from archlint.interpreter.values import Entries, Items, Value, chosen_for, one_of

T = TypeVar("T")

Slot = tuple[int, str | Field[Any]]
Layer = dict[Slot, object]
_Keys = set[int]
"""The slot of a name (a variable, an attribute) holds a value, that of a field the run's own immutable data."""


class Store:
    """A stack of layers over one base; reads go from the top down, writes go to the top."""

    def __init__(self) -> None:
        self.layers: list[Layer] = [{}]
        self._next = 1
        self._names: dict[int, list[str]] = {}
        """The names that objects and scopes have in the base layer, of its first ``_named`` slots."""
        self._named = 0
        self._references: dict[int, dict[str, None]] = {}
        self._program_references: dict[int, dict[str, None]] = {}
        self.shared: dict[int, object] = {}
        """How the objects that a module keeps from its import on are got at, by key."""
        self._at_base = False
        self._oldest = 0
        self._inner: list[range] = []
        """The keys of what the imports have made that the import of the present module has led to."""
        self._older: set[int] = set()
        self.work = 0
        """Slots and items that joins have looked at, until somebody counts and takes them."""
        self._met: _Met | None = None
        """What is read of the state that the present callback has met."""
        self._met_before = 0
        """The keys below this one are of what was there before it ran."""
        self._reads: list[tuple[Slot, object, int]] | None = None
        """What was read, and from which layer (-1: from none), while somebody watches."""

    def new_key(self) -> int:
        self._next += 1
        return self._next

    @overload
    def get(self, key: int, slot: str) -> Value | None: ...
    @overload
    def get(self, key: int, slot: Field[T]) -> T | None: ...
    def get(self, key: int, slot: str | Field[Any]) -> Any:
        """What a slot holds; None where nobody has written it."""
        at = (key, slot)
        if key < self._met_before:
            self._note_met(at)
        if self._reads is not None:
            return self._noted(at, None)
        for layer in reversed(self.layers):
            if at in layer:
                return layer[at]
        return None

    def names_of(self, key: int) -> list[str]:
        """The names under which an object or a scope has values now, in the order in which they were written first."""
        self._note_names()
        above = (slot for layer in self.layers[1:] for owner, slot in layer if owner == key and isinstance(slot, str))
        return list(dict.fromkeys([*self._names.get(key, ()), *above]))

    def values_at(self, slots: Sequence[tuple[int, str]]) -> list[Value | None]:
        """What each of many variables holds; None where nobody has written it."""
        if self._reads is not None:
            return [self.get(*at) for at in slots]
        values: Iterable[Any] = repeat(None)
        for layer in filter(None, self.layers):  # from the bottom up, each falling back on those below it
            values = map(layer.get, slots, values)
        return [*islice(values, len(slots))]

    def holds(self, key: int) -> dict[str, None]:
        """The attributes of an object that may lead to others, whatever they hold now."""
        return {**self._references.get(key, {}), **self._program_references.get(key, {})}

    def note_reference(self, key: int, name: str) -> None:
        """An attribute of an object may lead to others: until the program ends, or from its module's import on."""
        rows = self._references if self._at_base else self._program_references
        rows.setdefault(key, {})[name] = None

    def forget_program_references(self) -> None:
        """A program ends: what it has put into objects that all programs share is gone."""
        self._program_references = {}

    def value_at(self, at: Slot) -> object:
        """What a slot holds, whatever it is; MISSING where nobody has written it."""
        if at[0] < self._met_before:
            self._note_met(at)
        if self._reads is not None:
            return self._noted(at, MISSING)
        return next((layer[at] for layer in reversed(self.layers) if at in layer), MISSING)

    def family(self, key: int, fields: Fields[T]) -> dict[str, T]:
        """What the fields of a family hold, by name."""
        values: dict[str, Any] = {}
        for layer in self.layers:
            for (owner, slot), value in layer.items():
                name = key_in(fields, slot) if owner == key else None
                if name is not None:
                    values[name] = value
        return values

    def variables(self, key: int) -> list[tuple[str, Value]]:
        """The names under which the base layer has values of an object or a scope, with these values."""
        self._note_names()
        base = self.layers[0]
        rows = ((slot, base[key, slot]) for slot in self._names.get(key, ()))
        return [(slot, value) for slot, value in rows if isinstance(value, Value)]

    def _note_names(self) -> None:
        base = self.layers[0]
        # The base only grows, and dicts keep the order: what is new since the last question stands at its end.
        for owner, slot in reversed([*islice(reversed(base), len(base) - self._named)]):
            if isinstance(slot, str):
                self._names.setdefault(owner, []).append(slot)
        self._named = len(base)

    @contextmanager
    def meeting(self, oldest: int) -> Iterator[set[Slot]]:
        """Note what is read of the state that is here now, and not of what has taken its place since.  What is made
        has keys from ``oldest`` on."""
        kept = self._met, self._met_before
        self._met, self._met_before = _Met(self.depth), oldest
        try:
            yield self._met.slots
        finally:
            has_imported = self._met_before > oldest
            self._met, before = kept
            self._met_before = self._met_before if has_imported and self._met is not None else before

    def _note_met(self, at: Slot) -> None:
        met = self._met
        if met is not None and at not in met.slots and (at in met.mixed or not self._is_written_since(at, met)):
            met.slots.add(at)

    def _note_mixed(self, slots: Iterable[Slot], branches: Sequence[Layer]) -> None:
        """Of what branches write, note that where one of them does not the callback still has what it met."""
        met, oldest = self._met, self._met_before
        if met is None:
            return
        for at in slots:
            is_open = at[0] < oldest and any(at not in branch for branch in branches)
            if is_open and not self._is_written_since(at, met):
                met.mixed.add(at)

    def _is_written_since(self, at: Slot, met: _Met) -> bool:
        return any(at in layer for layer in self.layers[met.depth :])

    def _noted(self, at: Slot, default: object) -> object:
        assert self._reads is not None
        for number in range(len(self.layers) - 1, -1, -1):
            if at in self.layers[number]:
                value = self.layers[number][at]
                self._reads.append((at, value, number))
                return value
        self._reads.append((at, MISSING, -1))
        return default

    @contextmanager
    def watched(self) -> Iterator[dict[Slot, object]]:
        """Note what is read of the state that is here now, and what is left in it: with the same in all of these
        slots, the same would happen again, and leave all as it is."""
        around: dict[Slot, object] = {}
        kept, depth, youngest = self._reads, self.depth, self._next
        reads = self._reads = [] if kept is None else kept
        first = len(reads)
        self.push()
        try:
            yield around
        finally:
            written = self.cut(depth)
            self.apply(written)
            self._reads = kept
        for at, value, number in reads[first:]:
            if number < depth and at[0] <= youngest:
                around.setdefault(at, value)
        for at, value in written.items():
            if at[0] <= youngest:
                around[at] = value if around.get(at, value) == value else _CHANGING

    @overload
    def set(self, key: int, slot: str, value: Value) -> None: ...
    @overload
    def set(self, key: int, slot: Field[T], value: T) -> None: ...
    def set(self, key: int, slot: str | Field[Any], value: object) -> None:
        """Write a slot."""
        if self._at_base and self.depth == 1:
            self._note_older([(key, slot)])
        self.layers[-1][(key, slot)] = value

    def _note_older(self, written: Iterable[Slot]) -> None:
        for key, slot in written:
            if isinstance(slot, Field) and slot.is_of_all:
                continue
            if key < self._oldest or any(key in keys for keys in self._inner):
                self._older.add(key)

    @property
    def depth(self) -> int:
        return len(self.layers)

    def push(self) -> None:
        self.layers.append({})

    def pop(self) -> Layer:
        return self.layers.pop()

    def above(self, depth: int) -> Layer:
        """What was written above ``depth`` layers, flattened: the newest value of each slot."""
        merged: Layer = {}
        for layer in self.layers[depth:]:
            merged.update(layer)
        return merged

    def cut(self, depth: int) -> Layer:
        """Take off all layers above ``depth`` and return them flattened."""
        merged = self.above(depth)
        del self.layers[depth:]
        return merged

    def apply(self, layer: Layer) -> None:
        """Write all that a layer has into the top one."""
        if self._at_base and self.depth == 1:
            self._note_older(layer)
        self.layers[-1].update(layer)

    def merge(self, branches: Sequence[Layer], why: str | None = None) -> bool:
        """Join what alternative branches wrote into the top layer; True if a slot now holds something new.

        ``why`` says why it is not decided which of them is taken.

        A branch that did not write a slot leaves what was there before; a slot that was not there before is
        taken from the branches that have it.
        """
        changed = False
        if len(branches) == 1:
            # One way on: what it wrote is what holds.
            self.apply(branches[0])
            return False
        slots = dict.fromkeys(chain.from_iterable(branches))
        self.work += sum(map(len, branches))
        if self._reads is not None:
            for at in slots:
                if any(at not in branch for branch in branches):
                    self._noted(at, None)  # what was there before is one of what it may hold now
        self._note_mixed(slots, branches)
        below = self.layers[::-1]
        top = self.layers[-1]
        for at in slots:
            before: object = MISSING
            for layer in below:
                if at in layer:
                    before = layer[at]
                    break
            joined = self._joined(at, before, branches, why)
            if joined is not before:
                if self._at_base and self.depth == 1:
                    self._note_older([at])
                top[at] = joined
                changed = changed or before is MISSING or joined != before
        return changed

    def _joined(self, at: Slot, before: object, branches: Sequence[Layer], why: str | None) -> object:
        """What a slot holds after the branches; ``before`` in those that did not write it."""
        first: object = MISSING
        different: list[object] | None = None  # most slots hold one thing, whichever way was taken
        for branch in branches:
            value = branch.get(at, before)
            if value is MISSING or value is first:
                continue
            if first is MISSING:
                first = value
            elif different is None:
                different = [first, value]
            elif not any(value is other for other in different):
                different.append(value)
        if different is None:
            return first
        self.work += sum(map(_size, different))
        return _join(at[1], different, why)

    @contextmanager
    def at_base(self) -> Iterator[_Keys]:
        """Run on the base layer only: for modules, whose state all programs share.  What is here already is of other
        modules: the set has the keys of such objects that were written."""
        first = self._next
        kept = self.layers, self._at_base, self._oldest, self._older, self._inner
        self.layers, self._at_base, self._oldest, self._older, self._inner = self.layers[:1], True, first, set(), []
        try:
            yield self._older
        finally:
            self.layers, self._at_base, self._oldest, self._older, self._inner = kept
            self._inner.append(range(first, self._next + 1))
            if self._met is not None:  # other callbacks may write the variables of the module, too
                self._met_before = self._next + 1


class _Met:
    """What a callback reads of the state that it meets; what it writes is in the layers from ``depth`` on."""

    def __init__(self, depth: int) -> None:
        self.depth = depth
        self.slots: set[Slot] = set()
        self.mixed: set[Slot] = set()
        """What it has written on some ways only, so that what was there before may still be there."""


class _Missing:
    pass


MISSING = _Missing()
"""What a slot holds that nobody has written."""


class _Changing:
    """What a slot was to hold for a function that reads it and leaves something else there."""


_CHANGING = _Changing()


def _size(value: object) -> int:
    return value.size if isinstance(value, (Items, Entries)) else 1


def _join(slot: str | Field[Any], left: Sequence[Any], why: str | None) -> object:
    return chosen_for(one_of(left), why) if isinstance(slot, str) else slot.join(left)
