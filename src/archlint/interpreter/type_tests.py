"""``isinstance``: whether a value is of a type of Python's own, of a followed class or of a foreign one."""

from __future__ import annotations

import builtins
import collections.abc
import numbers
import os
import pathlib
import types
import typing
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    FALSE,
    TRUE,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    ForeignValue,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
)

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

_LIBRARIES: dict[str, object] = {
    "builtins": builtins,
    "collections.abc": collections.abc,
    "numbers": numbers,
    "os": os,
    "pathlib": pathlib,
    "types": types,
    "typing": typing,
    "typing_extensions": typing,
}
"""Where a name means the same class for us as for the program."""


def _nothing() -> Iterator[None]:
    yield from ()


_SAMPLES: dict[str, object] = {"list": [], "tuple": (), "generator": _nothing()}
"""What stands for a collection.  A set may be frozen or not: that is not kept."""

_ABSTRACT = frozenset({"abc.ABC", "typing.Protocol", "typing_extensions.Protocol"})
"""Bases of classes that may take others, which do not derive from them, for their own."""


def isinstance_of(machine: Machine, args: list[Value]) -> Value:
    """Whether a value is of some classes; what is not known of the value or of a class leaves it open."""
    if len(args) != 2:
        return Unknown("isinstance() without a type")
    classes = classes_of(machine, args[1])
    if classes is None:
        return Unknown("isinstance() of a type that is not known")
    verdicts = {is_any(machine, value, classes) for value in alternatives(args[0])}
    if len(verdicts) == 1 and None not in verdicts:
        return TRUE if True in verdicts else FALSE
    return Unknown("the type of the value is not known")


def classes_of(machine: Machine, given: Value) -> list[Value] | None:
    """The classes of a test, those in nested tuples too; None where not all of them are known."""
    if not isinstance(given, ListValue):
        return [given]
    items = given.items(machine)
    if items.open:
        return None
    classes: list[Value] = []
    for item in items.values:
        inner = classes_of(machine, item)
        if inner is None:
            return None
        classes += inner
    return classes


def is_any(machine: Machine, value: Value, classes: list[Value]) -> bool | None:
    """Whether a value is of one of some classes; None where that is not known."""
    verdicts = [_is_a(machine, value, cls) for cls in classes]
    return True if True in verdicts else None if None in verdicts else False


def _is_a(machine: Machine, value: Value, cls: Value) -> bool | None:
    python = _python_class(cls)
    if python is object:
        return True
    match value:
        case Known() | Holed() | ListValue() | DictValue():
            return _plain_is_a(machine, value, cls, python)
        case ForeignValue():
            return machine.library.is_instance(value, cls, python)
        case Instance():
            return _object_is_a(machine, value, cls, python)
        case ClassValue() | FunctionValue() | BoundMethod() if python in (str, int, float, bool, list, dict):
            return False
    return None


def _plain_is_a(
    machine: Machine, value: Known | Holed | ListValue | DictValue, cls: Value, python: type | None
) -> bool | None:
    """Of constants and collections of Python's own."""
    if python is not None:
        return _sample_is_a(value, python)
    match cls:
        case ClassValue():
            return None if _ABSTRACT & set(cls.external_bases()) else False
        case External() if machine.library.is_ordinary_class(cls.path):
            return False
    return None


def _sample_is_a(value: Known | Holed | ListValue | DictValue, python: type) -> bool | None:
    if isinstance(value, ListValue) and value.kind == "set":
        return True if python in _OF_EVERY_SET else None if python in _OF_SOME_SETS else False
    try:
        return isinstance(_sample(value), python)
    except TypeError:  # a protocol that cannot be asked for
        return None


def _sample(value: Known | Holed | ListValue | DictValue) -> object:
    """What is of the same classes as a value."""
    match value:
        case Known():
            return pathlib.Path() if value.kind == "path" else value.value
        case Holed():
            return ""
        case ListValue():
            return _SAMPLES[value.kind]
    return {}


def has_attribute(value: Value, name: str) -> bool | None:
    """Whether a constant or a collection of Python's own has an attribute; None where that is not known."""
    match value:
        case ListValue(kind="set"):
            return None
        case Known(kind="path"):
            return None
        case Known() | Holed() | ListValue() | DictValue():
            return hasattr(_sample(value), name)
    return None


_OF_EVERY_SET = frozenset(
    {
        collections.abc.Set,
        collections.abc.Collection,
        collections.abc.Iterable,
        collections.abc.Sized,
        collections.abc.Container,
    }
)
_OF_SOME_SETS = frozenset({set, frozenset, collections.abc.MutableSet, collections.abc.Hashable})


def _object_is_a(machine: Machine, value: Instance, cls: Value, python: type | None) -> bool | None:
    if isinstance(value.cls, External):
        return machine.library.is_subclass(value.cls.path, cls)
    mro = value.cls.mro
    if any(base is cls or base == cls for base in mro):
        return True
    foreign = value.cls.external_bases()
    if python is not None:
        names = {f"{python.__module__}.{python.__name__}", python.__name__}
        if names & set(foreign):
            return True
        # An abstract class of Python's asks what an object can do, not what it derives from.
        return None if foreign or python.__module__ != "builtins" else False
    return None if any(isinstance(base, (External, Unknown)) for base in mro) else False


def _python_class(cls: Value) -> type | None:
    """The class itself, of Python's own library."""
    match cls:
        case Builtin():
            return _class_at(f"builtins.{cls.name}")
        case External():
            return _class_at(cls.path)
    return None


@lru_cache(maxsize=1024)
def _class_at(path: str) -> type | None:
    module, _, name = path.rpartition(".")
    library = _LIBRARIES.get(module)
    attribute = getattr(library, name, None) if library is not None else None
    origin = typing.get_origin(attribute)
    attribute = attribute if origin is None else origin
    return attribute if isinstance(attribute, type) and attribute is not typing.Any else None
