"""What can change during a symbolic run: variables, attributes, items.

Everything mutable is kept here under ``(object, slot)``.  An undecided branch runs on a layer of its own;
layers are joined afterwards, so that each slot is one of what the branches left in it.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from contextlib import contextmanager
from itertools import islice

from archlint.interpreter.values import Unknown, Value, one_of

Slot = tuple[int, Hashable]
Layer = dict[Slot, object]
"""A slot holds a value; slots that start with ``#`` hold the run's own immutable data (items of a list …)."""
JOINED_LIMIT = 512
"""Of a list that alternatives filled with more than this, the first are kept: as many as a loop is followed over."""


class Store:
    """A stack of layers over one base; reads go from the top down, writes go to the top."""

    def __init__(self) -> None:
        self.layers: list[Layer] = [{}]
        self._next = 1
        self.held: dict[int, dict[Hashable, None]] = {}
        """The attributes of objects that may lead to others, by key, whatever they hold now."""
        self.shared: dict[int, object] = {}
        """How the objects that a module keeps from its import on are got at, by key."""
        self.work = 0
        """Slots and items that joins have looked at, until somebody counts and takes them."""
        self._reads: list[tuple[Slot, object, int]] | None = None
        """What was read, and from which layer (-1: from none), while somebody watches."""

    def new_key(self) -> int:
        self._next += 1
        return self._next

    def get(self, key: int, slot: Hashable, default: object = None) -> object:
        at = (key, slot)
        if self._reads is not None:
            return self._noted(at, default)
        for layer in reversed(self.layers):
            if at in layer:
                return layer[at]
        return default

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
            self.layers[-1].update(written)
            self._reads = kept
        for at, value, number in reads[first:]:
            if number < depth and at[0] <= youngest:
                around.setdefault(at, value)
        for at, value in written.items():
            if at[0] <= youngest:
                around[at] = value if around.get(at, value) == value else _CHANGING

    def set(self, key: int, slot: Hashable, value: object) -> None:
        self.layers[-1][(key, slot)] = value

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

    def merge(self, branches: Sequence[Layer]) -> bool:
        """Join what alternative branches wrote into the top layer; True if a slot now holds something new.

        A branch that did not write a slot leaves what was there before; a slot that was not there before is
        taken from the branches that have it.
        """
        changed = False
        if len(branches) == 1:
            # One way on: what it wrote is what holds.
            self.layers[-1].update(branches[0])
            return False
        slots: dict[Slot, None] = {}
        for branch in branches:
            slots.update(dict.fromkeys(branch))
            self.work += len(branch)
        if self._reads is not None:
            for at in slots:
                if any(at not in branch for branch in branches):
                    self._noted(at, None)  # what was there before is one of what it may hold now
        below = self.layers[::-1]
        top = self.layers[-1]
        for at in slots:
            before: object = MISSING
            for layer in below:
                if at in layer:
                    before = layer[at]
                    break
            first: object = MISSING
            found: list[object] | None = None
            for branch in branches:
                value = branch.get(at, before)
                if value is MISSING or value is first:
                    continue
                if first is MISSING:
                    first = value
                elif found is None:
                    found = [first, value]
                elif not any(value is other for other in found):
                    found.append(value)
            if found is not None:
                self.work += sum(map(_size, found))
            joined = first if found is None else _join(found)
            if joined is not before:
                top[at] = joined
                changed = changed or before is MISSING or joined != before
        return changed

    @contextmanager
    def at_base(self) -> Iterator[None]:
        """Run on the base layer only: for modules, whose state all programs share."""
        kept = self.layers
        self.layers = kept[:1]
        try:
            yield
        finally:
            self.layers = kept


class _Missing:
    pass


MISSING = _Missing()
"""What a slot holds that nobody has written."""


class _Changing:
    """What a slot was to hold for a function that reads it and leaves something else there."""


_CHANGING = _Changing()


def _size(value: object) -> int:
    if isinstance(value, Items):
        return len(value.values)
    return len(value.entries) if isinstance(value, Entries) else 1


def _join(found: Sequence[object]) -> object:
    values = [value for value in found if isinstance(value, Value)]
    if len(values) == len(found):
        return one_of(values)
    items = [value for value in found if isinstance(value, Items)]
    if len(items) == len(found):
        return join_items(items)
    entries = [value for value in found if isinstance(value, Entries)]
    if len(entries) == len(found):
        return join_entries(entries)
    return found[-1]


class Items:
    """Items of a list; ``open`` where which of them there are is not known: there may be more, or, if it is
    ``whole``, fewer, but no others."""

    __slots__ = ("open", "values", "whole")

    def __init__(self, values: tuple[Value, ...], open_: bool = False, whole: bool = False) -> None:
        self.values = values
        self.open = open_
        self.whole = whole or not open_

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Items) and self._all == other._all

    def __hash__(self) -> int:
        return hash(self._all)

    @property
    def _all(self) -> tuple[object, ...]:
        return (self.values, self.open, self.whole)


class Entries:
    """Entries of a dict in order; ``open`` where there may be more than are known."""

    __slots__ = ("entries", "open")

    def __init__(self, entries: dict[Hashable, tuple[Value, Value]], open_: bool = False) -> None:
        self.entries = entries
        self.open = open_

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Entries) and self.entries == other.entries and self.open == other.open

    __hash__ = None  # type: ignore[assignment]


def join_items(found: Sequence[Items]) -> Items:
    """A list that is one of several: known where all agree in length, else the union, open."""
    first = found[0]
    whole = all(items.whole for items in found)
    if all(len(items.values) == len(first.values) for items in found):
        columns = zip(*(items.values for items in found), strict=True)
        return Items(tuple(one_of(column) for column in columns), any(items.open for items in found), whole)
    union = dict.fromkeys(value for items in found for value in items.values)
    if len(union) > JOINED_LIMIT:
        return Items(tuple(islice(union, JOINED_LIMIT)), True)
    return Items(tuple(union), True, whole)


def join_entries(found: Sequence[Entries]) -> Entries:
    merged: dict[Hashable, tuple[Value, Value]] = {}
    for entries in found:
        for key, (name, value) in entries.entries.items():
            merged[key] = (name, one_of((merged[key][1], value))) if key in merged else (name, value)
    same = all(entries.entries.keys() == found[0].entries.keys() for entries in found)
    return Entries(merged, not same or any(entries.open for entries in found))


def unknown_items(reason: str) -> Items:
    return Items((Unknown(reason),), True)
