"""What asks an object for its attributes and its class, or makes one without calling its class."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute, set_attribute
from archlint.interpreter.builtins.handlers import first
from archlint.interpreter.machine import Phase
from archlint.interpreter.objects.classes import allocate
from archlint.interpreter.type_tests import has_attribute, isinstance_of
from archlint.interpreter.values import (
    FALSE,
    NONE,
    TRUE,
    ApiMethod,
    ClassValue,
    External,
    ForeignValue,
    Instance,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine


def attribute(machine: Machine, site: CallSite) -> Value:
    """``getattr``."""
    if len(site.args) < 2:
        return Unknown("getattr() without a name")
    target, name, *default = site.args
    return one_of(value for option in alternatives(name) for value in _attribute(machine, target, option, default[:1]))


def _attribute(machine: Machine, target: Value, name: Value, default: list[Value]) -> Iterator[Value]:
    if name.text is None:
        yield Unknown(reason(name))
        return
    value = get_attribute(machine, target, name.text)
    if isinstance(value, External):
        value = value.chosen_by(name.via)
    missing = _is_missing(machine, value)
    if not missing or not default:
        yield value
    if default and (missing or isinstance(value, Unknown)):
        yield default[0].as_default()


def _is_missing(machine: Machine, value: Value) -> bool:
    """Whether an object certainly lacks an attribute: neither its class here nor a foreign base has it."""
    match value:
        case Unknown():
            return value.missing is not None
        case ApiMethod():
            return machine.library.lacks(value)
    return False


def assign(machine: Machine, site: CallSite) -> Value:
    """``setattr``, and ``object.__setattr__(self, 'x', value)``: how frozen dataclasses fill themselves."""
    match site.args:
        case [target, Known(value=str(name)), value]:
            set_attribute(machine, target, name, value)
        case _:
            machine.library.escaped(site.args[2:], "setattr() stores it under a name that is not known")
    return NONE


def has(machine: Machine, site: CallSite) -> Value:
    """``hasattr``."""
    match site.args:
        case [target, Known(value=str(name))]:
            return _has(machine, target, name)
    return Unknown("hasattr() of a name that is not known")


def _has(machine: Machine, target: Value, name: str) -> Value:
    known = machine.library.has_attribute(target, name) if isinstance(target, ForeignValue) else None
    if known is not None:
        return known
    verdicts = {has_attribute(option, name) for option in alternatives(target)}
    if len(verdicts) == 1 and None not in verdicts:
        return TRUE if True in verdicts else FALSE
    if target.own_class is None:
        if isinstance(target, Instance) and isinstance(get_attribute(machine, target, name), Known):
            return TRUE  # of a class of the library, which knows that one
        return Unknown("hasattr() of an object that is not followed")
    value = get_attribute(machine, target, name)
    if _is_missing(machine, value):
        return FALSE if machine.phase is Phase.START else Unknown("whether it is already set")
    return Unknown(value.reason) if isinstance(value, Unknown) else TRUE


def is_of(machine: Machine, site: CallSite) -> Value:
    """``isinstance``."""
    return isinstance_of(machine, site.args)


def type_of(machine: Machine, site: CallSite) -> Value:
    """``type``."""
    cls: Value | None = None
    match first(site):
        case Instance() as value:
            cls = value.cls
        case ForeignValue() as foreign:
            cls = machine.library.class_of(foreign)
    return cls or Unknown("the type of a value")


def can_be_called(machine: Machine, site: CallSite) -> Value:
    """``callable``."""
    value = first(site)
    if value.is_callable:
        return TRUE
    return FALSE if isinstance(value, Known) else Unknown(reason(value))


def new_object(machine: Machine, site: CallSite) -> Value:
    """``object.__new__``."""
    cls = first(site)
    return allocate(machine, cls) if isinstance(cls, ClassValue) else Unknown("an object")


__all__ = ["assign", "attribute", "can_be_called", "has", "is_of", "new_object", "type_of"]
