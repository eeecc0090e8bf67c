"""How objects of the workspace's classes are made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.attributes import bind
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.objects import dataclasses, enums
from archlint.interpreter.values import (
    MEMBERS,
    ApiMethod,
    ClassValue,
    External,
    FunctionValue,
    Instance,
    Value,
    alternatives,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def instantiate(machine: Machine, cls: ClassValue, site: CallSite) -> Value:
    """Make an object of a class of the workspace."""
    if machine.store.get(cls.key, MEMBERS):
        return enums.member(machine, cls, site.args)
    target = _given_by_new(machine, cls, site) or allocate(machine, cls, site.expression)
    machine.library.constructing(target, cls, site)
    init, owner = cls.lookup(machine, "__init__")
    if init is not None:
        machine.call(bind(machine, init, target, cls), site)
    elif isinstance(owner, External):
        machine.library.call_method(ApiMethod(f"{owner.path}.__init__", target), site)
    elif dataclasses.is_data(cls):
        dataclasses.fill(machine, target, cls, site)
    return target


def allocate(machine: Machine, cls: ClassValue, expression: facts.Call | None = None) -> Instance:
    """An object of a class, before its ``__init__``."""
    place = machine.place(expression.span) if expression is not None and machine.activations else None
    target = Instance(cls, machine.store.new_key(), place)
    machine.instances[target.key] = target
    machine.library.allocated(target)
    return target


def _given_by_new(machine: Machine, cls: ClassValue, site: CallSite) -> Instance | None:
    """The object that a ``__new__`` of ours gives: of a class with one object only, the one that there is."""
    new, _ = cls.lookup(machine, "__new__")
    if not isinstance(new, FunctionValue):
        return None
    given = machine.call(new, CallSite([cls, *site.args], site.keywords, site.expression))
    objects = (option for option in alternatives(given) if isinstance(option, Instance) and option.cls is cls)
    return min(objects, key=lambda option: option.key, default=None)


__all__ = ["allocate", "instantiate"]
