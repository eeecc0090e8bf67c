"""What a header of C++ declares and a source defines: functions, variables, and default arguments.

A declaration at the top of a file is a value of its own, which other files get with their includes; whoever reads it
finds the definition.  That stands in one source: where several define it, which of them is linked is not known.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from archlint.interpreter.values import ClassValue, Declared, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.heap import Store
    from archlint.interpreter.modules import ModuleIndex, Scope
    from archlint.syntax import facts


class Defaults(NamedTuple):
    """The default arguments of one declaration of a function."""

    accepted: int
    """How many parameters it has."""
    values: tuple[Value, ...]
    """Those of the last ones."""


def declare(index: ModuleIndex, store: Store, scope: Scope, name: str, row: Defaults) -> Value:
    """What a declaration at the top of a file, or in a class, binds; what is known under the name already stays."""
    known = store.get(scope.key, name)
    value = Declared(scope.key, name) if known is None or scope.kind == "class" else known
    if row.values:
        rows = index.defaults.setdefault(_key(value, scope, name), [])
        if row.accepted not in [other.accepted for other in _defaults(rows)]:
            rows.append(row)
    return value


def _key(value: Value, scope: Scope, name: str) -> tuple[int, str]:
    return (value.owner, value.name) if isinstance(value, Declared) else (scope.key, name)


def _defaults(rows: Sequence[object]) -> list[Defaults]:
    return [row for row in rows if isinstance(row, Defaults)]


def note_definition(index: ModuleIndex, store: Store, scope: Scope, name: str, value: Value) -> None:
    """A file is about to bind a name that it may have a declaration of; of what stands in a namespace, the name with it
    counts."""
    before = store.get(scope.key, name)
    if isinstance(before, Declared) and not isinstance(value, Declared) and before.name == name:
        index.definitions.setdefault((before.owner, before.name), {})[scope.module.file.path] = scope


def defining_scope(index: ModuleIndex, declared: Declared) -> Scope | None:
    """The file that defines what a declaration stands for; None where that is not one file here."""
    rows = index.definitions.get((declared.owner, declared.name), {})
    return next(iter(rows.values())) if len(rows) == 1 else None


def definition_of(index: ModuleIndex, store: Store, declared: Declared) -> Value:
    """What a declaration stands for."""
    scope = defining_scope(index, declared)
    value = None if scope is None else store.get(scope.key, declared.name)
    if value is not None and not isinstance(value, Declared):
        return value
    where = "in several files" if index.definitions.get((declared.owner, declared.name)) else "elsewhere"
    return Unknown(f"'{declared.name}' is declared here and defined {where}", name=declared.name)


def nested_class(store: Store, scope: Scope, name: str) -> Value | None:
    """A class in a class of C++, which the methods of both know, and those beside it; None for anything else."""
    value = store.get(scope.key, name) if scope.module.file.kind == "cpp" else None
    return value if isinstance(value, ClassValue) else None


def defaults_of(index: ModuleIndex, store: Store, scope: Scope, function: facts.Function) -> list[tuple[str, Value]]:
    """The default arguments that a function has by its declaration alone, with the names of its parameters."""
    if not index.defaults:
        return []
    owner, mark, name = function.name.rpartition("::")
    before = store.get(scope.key, owner if mark else name)
    names = [param.name for param in function.params if param.kind == "normal"]
    match before:
        case ClassValue() if mark:
            key, names = (before.key, "__init__" if name == owner else name), names[1:]
        case Declared():
            key = (before.owner, before.name)
        case _:
            return []
    rows = _defaults(index.defaults.get(key, []))
    values = next((row.values for row in rows if row.accepted == len(names)), ())
    return list(zip(names[len(names) - len(values) :], values, strict=True))


__all__ = ["Defaults", "declare", "defaults_of", "defining_scope", "definition_of", "nested_class", "note_definition"]
