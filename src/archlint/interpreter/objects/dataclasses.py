"""Objects of data classes and named tuples: what their constructors set."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import hints
from archlint.interpreter.attributes import method_of
from archlint.interpreter.values import (
    TUPLE_FIELDS,
    ClassValue,
    Instance,
    Unknown,
    Value,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

_NAMED_TUPLE = "typing.NamedTuple"


def is_data(cls: ClassValue) -> bool:
    """Whether a class has its constructor from its fields."""
    decorators = (name for base in cls.classes for name in base.decorators)
    return any("dataclass" in name for name in decorators) or _NAMED_TUPLE in cls.external_bases()


def fill(machine: Machine, target: Instance, cls: ClassValue, site: CallSite) -> None:
    """Set the fields of an object as a call of its class says."""
    fields = _fields(cls)
    rest = list(site.args)
    for name, base in fields.items():
        value = rest.pop(0) if rest else _given(machine, base, name, site)
        if value is None:
            value = hints.declared(machine, cls, name) or Unknown(f"the field '{name}' is not set")
        else:
            machine.library.kept(target.key, (value,), name)
        machine.store.set(target.key, name, value)
    if _NAMED_TUPLE in cls.external_bases():
        machine.store.set(target.key, TUPLE_FIELDS, tuple(fields))
    after = method_of(machine, target, "__post_init__")
    if after is not None:
        machine.call(after)


def _fields(cls: ClassValue) -> dict[str, ClassValue]:
    """The fields of a class, and which class says each of them last."""
    fields: dict[str, ClassValue] = {}
    for base in reversed(cls.classes):
        for statement in base.ir.body:
            match statement:
                case facts.Annotated(target=facts.Name(id=name)):
                    fields[name] = base
    return fields


def _given(machine: Machine, base: ClassValue, name: str, site: CallSite) -> Value | None:
    """What a field gets by name or by default; None where it gets nothing."""
    if name in site.keywords:
        return site.keywords[name]
    if site.open:
        return Unknown("a field that is passed by * or **")
    value = machine.store.get(base.key, name)
    if isinstance(value, Instance) and value.note == "dataclasses.field":
        value = _default(machine, value)
    return None if value is None else value.as_default()


def _default(machine: Machine, declared: Instance) -> Value:
    """What ``dataclasses.field(…)`` says."""
    if "default" in declared.arguments:
        return declared.arguments["default"]
    factory = declared.arguments.get("default_factory")
    return Unknown("a field without a default") if factory is None else machine.call(factory)


__all__ = ["fill", "is_data"]
