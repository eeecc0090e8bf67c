"""Attributes of classes, through their method resolution order."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.python_classes import PLAIN_BASES
from archlint.interpreter.values import ClassValue, External, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def class_lookup(
    machine: Machine, cls: ClassValue, name: str, after: ClassValue | None = None
) -> tuple[Value | None, Value]:
    """A class attribute through the MRO: ``(value, class it was found on)``; value None where it is not found.

    A foreign base that may define the name ends the search with that base.
    """
    started = after is None
    for base in cls.mro:
        if not started:
            started = base is after
            continue
        if isinstance(base, ClassValue):
            value = machine.store.get(base.key, name)
            if isinstance(value, Value):
                return value, base
        elif isinstance(base, External):
            if base.path in ("builtins.object", "object"):
                continue
            if base.path not in PLAIN_BASES:
                return None, base
        elif isinstance(base, Unknown):
            return None, base
    return None, cls


__all__ = ["class_lookup"]
