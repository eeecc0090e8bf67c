"""What a class keeps beside its attributes, and what decorates it."""

from __future__ import annotations

from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.values import ClassValue, FunctionValue
from archlint.syntax import facts

SETTERS: Fields[FunctionValue] = Fields("setter")
"""The setters of its properties, by name."""
SUBCLASSES: Field[tuple[ClassValue, ...]] = Field("subclasses", is_of_all=True)
"""The classes that derive from it, in the order in which they are defined."""


def called(decorator: facts.Expr) -> facts.Expr:
    """What a decorator is, without the arguments that it is given."""
    return decorator.func if isinstance(decorator, facts.Call) else decorator


__all__ = ["SETTERS", "SUBCLASSES", "called"]
