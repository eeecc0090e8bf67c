"""What stands for a value that is not known, and for one of several; how what branches leave is joined."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import field, replace
from itertools import islice

from archlint.interpreter.fields import Field
from archlint.interpreter.values.base import NO_PARAMETERS, Entries, Items, State, Value
from archlint.origins import OriginKind
from archlint.records import dataclass

ALTERNATIVES = 12
"""How many alternatives a value may have before it is unknown."""
TOO_MANY = "more values than can be followed"
"""Why it then is."""
JOINED_LIMIT = 512
"""Of a list that alternatives filled with more than this, the first are kept: as many as a loop is followed over."""


@dataclass(frozen=True, slots=True)
class Unknown(Value):
    """A value that the source does not decide, and why.  ``parameter`` is set where a ROS parameter without a
    default decides it."""

    reason: str
    parameter: str | None = None
    annotation: Value | None = field(default=None, compare=False)
    """What annotations say of it: a class of ours, or an attribute of one."""
    name: str | None = field(default=None, compare=False)
    """The name of the variable it came in by."""
    missing: str | None = field(default=None, compare=False)
    """The attribute that an object certainly lacks."""
    interface: str | None = field(default=None, compare=False)
    """The interface that it would be if its package defined one: the graph still says which type the code writes."""
    never_none: bool = False
    """Whether it is some object for certain: what ``list()`` gives, the field of a message."""
    of_class: str | None = field(default=None, kw_only=True)
    """The dotted name of the class that it certainly is an object of: ``float``, ``rclpy.time.Time``."""

    @property
    def via(self) -> frozenset[str]:
        return NO_PARAMETERS if self.parameter is None else frozenset({self.parameter})

    def chosen_by(self, parameters: frozenset[str]) -> Unknown:
        return self if self.parameter is not None else replace(self, parameter=min(parameters))

    @property
    def is_object(self) -> bool:
        return self.never_none

    @property
    def number_class(self) -> str | None:
        return self.of_class if self.of_class in ("int", "float") else None

    def truth(self, state: State) -> bool | None:
        return None

    @property
    def why_unknown(self) -> str:
        return self.reason


@dataclass(frozen=True, slots=True)
class OneOf(Value):
    """One of several values; which one, the source does not decide."""

    values: tuple[Value, ...]
    why: str | None = field(default=None, compare=False)
    """Why the test is not decided that chooses one of them."""

    def chosen_by(self, parameters: frozenset[str]) -> Value:
        return chosen_for(one_of(option.chosen_by(parameters) for option in self.values), self.why)

    @property
    def why_unknown(self) -> str | None:
        return next((option.why_unknown for option in self.values if option.why_unknown is not None), None)

    @property
    def why_open(self) -> str | None:
        return self.why or next((option.why_open for option in self.values if option.why_open is not None), None)

    def as_default(self, kind: OriginKind = "argument_default") -> Value:
        return OneOf(tuple(option.as_default(kind) for option in self.values), self.why)

    @property
    def inner(self) -> tuple[Value, ...]:
        return self.values

    def truth(self, state: State) -> bool | None:
        verdicts = {option.truth(state) for option in self.values}
        return verdicts.pop() if len(verdicts) == 1 else None

    def items(self, state: State) -> Items | None:
        rows = [option.items(state) for option in self.values]
        known = [row for row in rows if row is not None]
        if not known:
            return None
        union: list[Value] = []
        for row in known:
            union.extend(item for item in row.values if item not in union)
        same = len(known) == len(rows) and all(row == known[0] for row in known)
        exhaustive = len(known) == len(rows) and all(row.exhaustive for row in known)
        return Items(tuple(union), not same or known[0].open, exhaustive)


def alternatives(value: Value) -> tuple[Value, ...]:
    """What a value may be: the values that it is one of, or itself alone."""
    return value.values if isinstance(value, OneOf) else (value,)


def one_of(values: Iterable[Value]) -> Value:
    """The value that is one of ``values``: duplicates merged, too many of them unknown."""
    distinct: list[Value] = []
    plain = unknown = 0
    for value in values:
        if len(distinct) == 1 and value is distinct[0]:
            continue  # as in most joins: no branch has changed it
        for alternative in value.values if isinstance(value, OneOf) else (value,):
            is_unknown = isinstance(alternative, Unknown)
            if is_unknown and unknown > 1:
                continue
            if not is_unknown and plain > ALTERNATIVES:
                return Unknown(TOO_MANY)
            if alternative not in distinct:
                distinct.append(alternative)
                unknown += is_unknown
                plain += not is_unknown
    if not distinct:
        return Unknown("no value")
    if len(distinct) == 1:
        return distinct[0]
    if unknown > 1:
        # One unknown is enough to say so; the first reason is the one met first.
        first = next(value for value in distinct if isinstance(value, Unknown))
        merged = replace(first, of_class=None)
        distinct = [
            merged if value is first else value for value in distinct if value is first or not _is_unknown(value)
        ]
        if len(distinct) == 1:
            return distinct[0]
    if len(distinct) > ALTERNATIVES:
        return Unknown(TOO_MANY)
    return OneOf(tuple(distinct))


def _is_unknown(value: Value) -> bool:
    return isinstance(value, Unknown)


def chosen_for(value: Value, why: str | None) -> Value:
    """A value that a test chooses, which is not decided for the reason ``why``."""
    if isinstance(value, OneOf) and value.why is None and why is not None:
        return OneOf(value.values, why)
    return value


def chosen_with(value: Value, *sources: Value) -> Value:
    """A value that is made of others: what chooses among these chooses among its alternatives."""
    return chosen_for(value, next((source.why_open for source in sources if source.why_open is not None), None))


def join_items(alternatives: Sequence[Items]) -> Items:
    """A list that is one of several: known where all agree in length, else the union, open."""
    first = alternatives[0]
    exhaustive = all(items.exhaustive for items in alternatives)
    if all(len(items.values) == len(first.values) for items in alternatives):
        columns = zip(*(items.values for items in alternatives), strict=True)
        return Items(tuple(one_of(column) for column in columns), any(items.open for items in alternatives), exhaustive)
    union = dict.fromkeys(value for items in alternatives for value in items.values)
    if len(union) > JOINED_LIMIT:
        return Items(tuple(islice(union, JOINED_LIMIT)), True)
    return Items(tuple(union), True, exhaustive)


def join_entries(alternatives: Sequence[Entries]) -> Entries:
    """A dict that is one of several: all their entries, open where they differ in keys."""
    merged: dict[Hashable, tuple[Value, Value]] = {}
    for entries in alternatives:
        for key, (name, value) in entries.entries.items():
            merged[key] = (name, one_of((merged[key][1], value))) if key in merged else (name, value)
    same = all(entries.entries.keys() == alternatives[0].entries.keys() for entries in alternatives)
    return Entries(merged, not same or any(entries.open for entries in alternatives))


ITEMS: Field[Items] = Field("items of a list", join_items)
ENTRIES: Field[Entries] = Field("entries of a dict", join_entries)
FACTORY: Field[Value] = Field("factory of a defaultdict", one_of)
