"""What attributes may hold when a method runs that nothing here is seen to call.

Code that is not followed (a user interface, an event loop, another package) may call it at any time.  What the
program leaves in an attribute at last is then only one of the values that the classes give it: ``self.running`` is
true before somebody calls ``stop()``.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from archlint.interpreter.heap import Layer
from archlint.interpreter.values import ClassValue, Known, Unknown, Value, one_of
from archlint.libraries.run import Run
from archlint.programs.left_behind import is_plain
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

_CONSTRUCTOR = "__init__"


def attributes_at_any_time(run: Run) -> Layer:
    """What the plain attributes of the program's objects may hold, where a method gives them another value."""
    found: Layer = {}
    changed: dict[int, dict[str, tuple[Value, ...]]] = {}
    for instance in run.instances.values():
        if not isinstance(instance.cls, ClassValue):
            continue
        if instance.cls.key not in changed:
            changed[instance.cls.key] = _changed_of(instance.cls)
        for name, others in changed[instance.cls.key].items():
            value = run.store.get(instance.key, name)
            if isinstance(value, Value) and is_plain(run, value):
                joined = one_of([value, *others])
                if joined != value:
                    found[(instance.key, name)] = joined
    return found


def _changed_of(cls: ClassValue) -> dict[str, tuple[Value, ...]]:
    """The attributes that the methods of a class, and of those it derives from, change, and what they put there."""
    given: dict[str, list[tuple[bool, Value]]] = {}
    for base in cls.mro:
        if isinstance(base, ClassValue):
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
    methods = [one for one in key.fact.body if isinstance(one, facts.Function) and one.params]
    return tuple(
        (name, method.name != _CONSTRUCTOR, value)
        for method in methods
        for statement in everything_in(method)
        for name, value in _targets(statement, method.params[0].name)
    )


def _targets(statement: facts.Base, own: str) -> Iterator[tuple[str, Value]]:
    if isinstance(statement, facts.Assign):
        known = _literal(statement.value)
        for target in statement.targets:
            yield from ((name, known) for name in _names(target, own))
    elif isinstance(statement, facts.Augmented):
        yield from ((name, _CHANGES) for name in _names(statement.target, own))
    elif isinstance(statement, facts.Annotated) and statement.value is not None:
        yield from ((name, _literal(statement.value)) for name in _names(statement.target, own))


_CHANGES = Unknown("methods change it")


def _literal(value: facts.Expr) -> Value:
    return Known(value.value) if isinstance(value, facts.Literal) else _CHANGES


def _names(target: facts.Expr, own: str) -> Iterator[str]:
    """The attributes of ``own`` in the target of an assignment."""
    if isinstance(target, facts.Sequence):
        for element in target.elements:
            yield from _names(element, own)
    elif isinstance(target, facts.Attribute) and isinstance(target.value, facts.Name) and target.value.id == own:
        yield target.attr
