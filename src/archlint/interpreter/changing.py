"""Attributes that methods change: what a class, as it is written, puts into them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from archlint.interpreter.values import ClassValue, FunctionValue, Known, Unknown, Value
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

_BEFORE = frozenset({"__init__", "__fields__"})
"""The methods that run before all others; in C++ the second gives fields their first values."""


class Changes(NamedTuple):
    """What an attribute is given: by the methods that run before all others, and by those that change it."""

    first: tuple[Value, ...]
    later: tuple[Value, ...]


def changed_attributes(machine: Machine, cls: ClassValue) -> dict[str, Changes]:
    """The attributes that the methods of a class, and of those it derives from, change, and what they put there."""
    given: dict[str, list[tuple[bool, Value]]] = {}
    for base in cls.classes:
        for method in _methods_of(machine, base):
            for name, value in _assigned(Itself(method)):
                given.setdefault(name, []).append((method.name not in _BEFORE, value))
    return {
        name: Changes(
            *(tuple(dict.fromkeys(value for later, value in rows if later is when)) for when in (False, True))
        )
        for name, rows in given.items()
        if len(rows) > 1 and any(later for later, _ in rows)
    }


def _methods_of(machine: Machine, cls: ClassValue) -> list[facts.Function]:
    """The methods of a class; those of C++ are mostly defined outside of it."""
    if cls.scope.module.file.kind != "cpp":
        return [statement for statement in cls.ir.body if isinstance(statement, facts.Function)]
    values = [value for _, value in machine.store.variables(cls.key) if isinstance(value, FunctionValue)]
    return [value.ir for value in values if isinstance(value.ir, facts.Function)]


@lru_cache(maxsize=16384)
def _assigned(key: Itself[facts.Function]) -> tuple[tuple[str, Value], ...]:
    """Each attribute of its own object that a method assigns, and the value as far as it is written there."""
    method = key.fact
    own = method.params[0].name if method.params else ""
    return tuple(row for statement in everything_in(method) for row in _targets(statement, own))


def _targets(statement: facts.Base, own: str) -> Iterator[tuple[str, Value]]:
    match statement:
        case facts.Assign():
            known = _literal(statement.value)
            for target in statement.targets:
                yield from ((name, known) for name in _names(target, own))
        case facts.Augmented():
            yield from ((name, _CHANGES) for name in _names(statement.target, own))
        case facts.Annotated() if statement.value is not None:
            yield from ((name, _literal(statement.value)) for name in _names(statement.target, own))


CHANGED = "methods change it"
_CHANGES = Unknown(CHANGED)


def _literal(value: facts.Expr) -> Value:
    return Known(value.value) if isinstance(value, facts.Literal) else _CHANGES


def _names(target: facts.Expr, own: str) -> Iterator[str]:
    """The attributes of ``own`` in the target of an assignment."""
    match target:
        case facts.Sequence():
            for element in target.elements:
                yield from _names(element, own)
        case facts.Attribute(value=facts.Name(id=name)) if name == own:
            yield target.attr
        case facts.Implicit(name=name):
            yield name
