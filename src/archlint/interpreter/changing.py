"""Attributes that methods change: what a class, as it is written, puts into them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from archlint.interpreter.values import ClassValue, Known, Unknown, Value
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

_CONSTRUCTOR = "__init__"


def changed_attributes(cls: ClassValue) -> dict[str, tuple[Value, ...]]:
    """The attributes that the methods of a class, and of those it derives from, change, and what they put there."""
    given: dict[str, list[tuple[bool, Value]]] = {}
    for base in cls.classes:
        for name, later, value in _assigned(Itself(base.ir)):
            given.setdefault(name, []).append((later, value))
    return {
        name: tuple(dict.fromkeys(value for _, value in rows))
        for name, rows in given.items()
        if len(rows) > 1 and any(later for later, _ in rows)
    }


@lru_cache(maxsize=4096)
def _assigned(key: Itself[facts.Class]) -> tuple[tuple[str, bool, Value], ...]:
    """Each attribute of its own object that a class assigns, whether the constructor is over by then, and the value
    as far as it is written there."""
    methods = [statement for statement in key.fact.body if isinstance(statement, facts.Function) and statement.params]
    return tuple(
        (name, method.name != _CONSTRUCTOR, value)
        for method in methods
        for statement in everything_in(method)
        for name, value in _targets(statement, method.params[0].name)
    )


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


_CHANGES = Unknown("methods change it")


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
