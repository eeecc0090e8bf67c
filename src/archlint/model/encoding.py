"""Programs as MessagePack, and back.

Nodes, create calls, callbacks and the like refer to one another, in circles, and are distinguished by identity.  So
all programs of a workspace are written together, as two tables: the *values* (places, names, what calls are given …),
each after those that it is made of, and the *objects* that have an identity.  A reference is a list of one number: that
of a value's row from 0 up, behind those of what is empty, that of an object's from -1 down.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field, fields
from enum import Enum
from functools import cached_property
from typing import Any, Final

import msgspec

from archlint import branches
from archlint.finding import Place
from archlint.model import given
from archlint.model.absent_reads import AbsentRead
from archlint.model.calls import ApiCall
from archlint.model.executors import ExecutorUse, Spell, SpinDuration
from archlint.model.futures import MistakenFuture
from archlint.model.kinds import EntityKind, ExecutorKind, GroupKind, Role
from archlint.model.messages import FieldUse, Passed, UnknownInterface, ValueEffect, WrongValue
from archlint.model.nodes import (
    Blueprint,
    Callback,
    Creation,
    Frame,
    FunctionRef,
    Group,
    NodeClass,
    ParameterDeclaration,
    ParameterDescription,
)
from archlint.model.programs import Program
from archlint.model.refused import Misuse, RefusedCall
from archlint.model.texts import Text
from archlint.model.transforms import FramePair
from archlint.reasons import NotPassed, Uninformative
from archlint.records import dataclass
from archlint.ros.qos import Qos

Plain = Any
"""None, a truth value, a number, a text, bytes, or a list of such that begins with one of these tags."""

_HUGE: Final = "huge"
_DICT: Final = "dict"

_Setter = Callable[[object, object], None]

_CONTAINERS: Mapping[str, type] = {"list": list, "tuple": tuple, "set": set, "frozenset": frozenset}
_EMPTY_KINDS: Final = (tuple, frozenset)
_EMPTY: Final[Sequence[object]] = ((), frozenset())
"""What the first references mean: most tuples of a program are empty."""


@dataclass(frozen=True, eq=False)
class Language:
    """The classes that data is made of: ``words`` and numbers with a type of their own, and ``records``."""

    words: tuple[type, ...]
    records: tuple[type, ...]

    @cached_property
    def numbers(self) -> Mapping[type, int]:
        """The classes of records and words by their numbers, with which rows begin."""
        return {kind: number for number, kind in enumerate((*self.records, *self.words))}

    @cached_property
    def fields(self) -> Mapping[type, tuple[str, ...]]:
        """The fields of each class of records."""
        return {kind: tuple(row.name for row in fields(kind)) for kind in self.records}

    @cached_property
    def setting(self) -> Sequence[tuple[tuple[str, ...], Sequence[_Setter] | None]]:
        """By the number of a class: its fields, and what sets each where objects of it have no ``__dict__``."""
        return [
            (names, [getattr(kind, name).__set__ for name in names] if hasattr(kind, "__slots__") else None)
            for kind, names in self.fields.items()
        ]

    @cached_property
    def layout(self) -> int:
        """Another number where a class has other fields."""
        words = [kind.__name__ for kind in self.words]
        return zlib.crc32(repr([(kind.__name__, names) for kind, names in self.fields.items()] + words).encode())


PROGRAMS: Final = Language(
    (
        *(EntityKind, ExecutorKind, GroupKind, Misuse, Role, SpinDuration, ValueEffect),
        *(NotPassed, Uninformative),
    ),
    (
        *(
            AbsentRead,
            ApiCall,
            Blueprint,
            Callback,
            Creation,
            ExecutorUse,
            FieldUse,
            Frame,
            FramePair,
            FunctionRef,
            Group,
        ),
        *(
            MistakenFuture,
            NodeClass,
            ParameterDeclaration,
            ParameterDescription,
            Passed,
            Place,
            Program,
            Qos,
            RefusedCall,
            Spell,
            Text,
            UnknownInterface,
        ),
        WrongValue,
        *(given.Given, given.Constant, given.OneOf, given.Entity, given.Future, given.Node, given.Executor),
        *(given.Message, given.Process, given.Object, given.GoalHandle, given.Duration),
        *(given.ForeignClass, given.Collection, given.PlainValue),
        *(branches.CodeBranch, branches.ChoiceOfArgument, branches.ChoiceOfCallee),
    ),
)
"""What programs are made of."""
_MET_AGAIN = frozenset({Place, Frame, NodeClass})
_SMALL = range(-(2**63), 2**63)
"""What MessagePack has a number for."""


class NotEncodable(TypeError):
    """Something that is no plain data."""


class NotPrograms(ValueError):
    """A payload that is damaged, or of another version."""


class Payload(msgspec.Struct, array_like=True):
    """What is written: which fields the classes have, the rows of both tables, and what was asked for."""

    layout: int
    values: list[list[Plain]]
    objects: list[list[Plain]]
    items: list[Plain]


def encode(items: Iterable[object], language: Language = PROGRAMS) -> bytes:
    """Programs or parts of them, in lists, with all that they refer to."""
    return encode_noting(items, language)[0]


def encode_noting(items: Iterable[object], language: Language = PROGRAMS) -> tuple[bytes, list[object]]:
    """As :func:`encode`, with the objects that have an identity: what two payloads share is two things afterwards."""
    tables = _Tables(language)
    rows = [tables.plain(item) for item in items]
    tables.fill()
    return msgspec.msgpack.encode(Payload(language.layout, tables.values, tables.objects, rows)), tables.with_identity


def decode(payload: bytes, language: Language = PROGRAMS) -> list[Any]:
    """What was encoded; raises :class:`NotPrograms`."""
    try:
        decoded = msgspec.msgpack.decode(payload, type=Payload)
    except (msgspec.MsgspecError, ValueError, RecursionError) as error:
        raise NotPrograms(str(error)) from error
    if decoded.layout != language.layout:
        raise NotPrograms("written by another version")
    try:
        return _Rows(decoded, language).items()
    except (LookupError, TypeError, ValueError) as error:
        raise NotPrograms(str(error)) from error


@dataclass
class _Tables:
    language: Language
    values: list[list[Plain]] = field(default_factory=list)
    objects: list[list[Plain]] = field(default_factory=list)
    _numbers: dict[int, Plain] = field(default_factory=dict)
    """References by the ``id`` of what they refer to."""
    with_identity: list[object] = field(default_factory=list)
    """What has a number among the objects, in that order; it is kept alive, and with it its ``id``."""
    _kept: list[object] = field(default_factory=list)
    _equal: dict[object, Plain] = field(default_factory=dict)
    """References to words, places, frames and classes, of which most are met again and again."""

    def fill(self) -> None:
        """Write the rows of all objects, and of those that they refer to."""
        while len(self.objects) < len(self.with_identity):
            self.objects.append(self._row(self.with_identity[len(self.objects)]))

    def plain(self, item: object) -> Plain:
        kind = type(item)
        if item is None or kind in (bool, float, str, bytes):
            return item
        if kind is int:
            return item if item in _SMALL else [_HUGE, str(item)]
        if kind in self.language.fields:
            return self._reference(item)
        if kind in self.language.numbers:
            return self._word(item, kind)
        if not item and kind in _EMPTY_KINDS:
            return [_EMPTY_KINDS.index(kind)]
        match item:
            case list() | tuple():
                return [kind.__name__, *map(self.plain, item)]
            case set() | frozenset():
                return [kind.__name__, *map(self.plain, sorted(item, key=repr))]
            case dict():
                return [_DICT, *(self.plain(part) for row in item.items() for part in row)]
        raise NotEncodable(f"{kind.__module__}.{kind.__qualname__} is no plain data")

    def _reference(self, item: object) -> Plain:
        known = self._numbers.get(id(item))
        if known is None:
            if type(item).__eq__ is object.__eq__:
                self.with_identity.append(item)
                known = [-len(self.with_identity)]
            else:
                known = self._equal.get(item) if type(item) in _MET_AGAIN else None
                known = self._added(item) if known is None else known
                self._kept.append(item)
            self._numbers[id(item)] = known
        return known

    def _word(self, item: Any, kind: type) -> Plain:
        row = [self.language.numbers[kind], item.value if isinstance(item, Enum) else str(item)]
        if (known := self._equal.get(tuple(row))) is None:
            known = self._equal[tuple(row)] = [len(_EMPTY) + len(self.values)]
            self.values.append(row)
        return known

    def _added(self, item: object) -> Plain:
        row = self._row(item)
        reference = [len(_EMPTY) + len(self.values)]
        self.values.append(row)
        if type(item) in _MET_AGAIN:
            self._equal[item] = reference
        return reference

    def _row(self, item: object) -> list[Plain]:
        kind = type(item)
        return [self.language.numbers[kind], *(self.plain(getattr(item, name)) for name in self.language.fields[kind])]


class _Rows:
    def __init__(self, payload: Payload, language: Language) -> None:
        self._language = language
        self._payload = payload
        objects: list[object] = [object.__new__(language.records[row[0]]) for row in payload.objects]
        self._known: list[object] = [*_EMPTY, *([None] * len(payload.values)), *reversed(objects)]
        """What references mean: what is empty, the values so far, and from the end all objects."""

    def items(self) -> list[object]:
        known, fill, new = self._known, self._fill, object.__new__
        records, words = self._language.records, self._language.words
        place = self._language.numbers.get(Place)
        for number, row in enumerate(self._payload.values, len(_EMPTY)):
            if row[0] == place:  # half of all, with nothing in them to look up
                known[number] = Place(*row[1:])
                continue
            if row[0] >= len(records):
                known[number] = words[row[0] - len(records)](row[1])
                continue
            item: object = new(records[row[0]])
            fill(item, row)
            known[number] = item
        for number, row in enumerate(self._payload.objects):
            fill(known[-1 - number], row)
        return self._items(self._payload.items)

    def _fill(self, item: object, row: list[Plain]) -> None:
        """Set the fields of an object to what stands in its row behind the number of its class."""
        names, setters = self._language.setting[row[0]]
        values = self._items(row[1:]) if list in map(type, row) else row[1:]
        if len(values) != len(names):
            raise ValueError(f"{len(values)} values for {len(names)} fields")
        # Not with setattr(), which frozen dataclasses refuse.
        if setters is None:
            item.__dict__.update(zip(names, values, strict=True))
            return
        for put, value in zip(setters, values, strict=True):
            put(item, value)

    def _items(self, row: Sequence[Plain]) -> list[object]:
        """What stands in a row."""
        known = self._known
        return [
            plain if type(plain) is not list else known[plain[0]] if type(plain[0]) is int else self._item(plain)
            for plain in row
        ]

    def _item(self, plain: list[Plain]) -> object:
        """What is no reference."""
        tag = plain[0]
        if tag == _HUGE:
            return int(plain[1])
        items = self._items(plain[1:])
        return dict(zip(items[::2], items[1::2], strict=True)) if tag == _DICT else _CONTAINERS[tag](items)


__all__ = ["NotEncodable", "NotPrograms", "decode", "encode", "encode_noting"]
