"""Attributes of classes, through their method resolution order, and what a class keeps beside them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.values import ClassValue, FunctionValue, Value
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

SETTERS: Fields[FunctionValue] = Fields("setter")
"""The setters of its properties, by name."""
SUBCLASSES: Field[tuple[ClassValue, ...]] = Field("subclasses")
"""The classes that derive from it, in the order in which they are defined."""


def class_lookup(
    machine: Machine, cls: ClassValue, name: str, after: ClassValue | None = None
) -> tuple[Value | None, Value]:
    """A class attribute through the MRO: ``(value, class it was found on)``; value None where it is not found."""
    return cls.lookup(machine, name, after)


def called(decorator: facts.Expr) -> facts.Expr:
    """What a decorator is, without the arguments that it is given."""
    return decorator.func if isinstance(decorator, facts.Call) else decorator


__all__ = ["SETTERS", "SUBCLASSES", "called", "class_lookup"]
