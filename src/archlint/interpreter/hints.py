"""What annotations tell of values that nothing here is seen to pass: the class of a node, or of what holds one."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.modules import Scope
from archlint.interpreter.values import AttributeOf, ClassValue, FunctionValue, ModuleValue, Unknown, Value
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

_OPTIONAL = ("Optional", "Annotated", "Final", "ClassVar")


def class_named(machine: Machine, scope: Scope, annotation: facts.Expr | None) -> ClassValue | None:
    """The class of the workspace that an annotation in a scope means, be it one of ours or nothing."""
    if isinstance(annotation, facts.Binary):
        return class_named(machine, scope, annotation.left) or class_named(machine, scope, annotation.right)
    if isinstance(annotation, facts.Subscript):
        inside = annotation.index if _last(annotation.value) in _OPTIONAL else None
        return class_named(machine, scope, inside)
    if isinstance(annotation, facts.Literal) and isinstance(annotation.value, str):
        path = annotation.value.split(".")
    else:
        path = _path(annotation)
    value = _lookup(machine, scope, path[0]) if path else None
    for name in path[1:]:
        value = machine.module_attribute(value.module, name) if isinstance(value, ModuleValue) else None
    return value if isinstance(value, ClassValue) else None


def _path(expression: facts.Expr | None) -> list[str]:
    if isinstance(expression, facts.Name):
        return [expression.id]
    if isinstance(expression, facts.Attribute):
        above = _path(expression.value)
        return [*above, expression.attr] if above else []
    return []


def _last(expression: facts.Expr) -> str:
    return (_path(expression) or [""])[-1]


def _lookup(machine: Machine, scope: Scope | None, name: str) -> Value | None:
    while scope is not None:
        value = machine.store.get(scope.key, name)
        if value is not None:
            return value
        scope = scope.parent
    return None


def annotated(machine: Machine, value: Value, annotation: facts.Expr) -> Value:
    """A value that is given to an annotated target."""
    if not isinstance(value, Unknown) or value.annotation is not None:
        return value
    return replace(value, annotation=class_named(machine, machine.activation.scope, annotation))


def declared(machine: Machine, cls: ClassValue, name: str) -> Value | None:
    """What the attribute of an object is where its class only says ``name: Supervisor``; None where it does not."""
    for base in cls.mro:
        for statement in base.ir.body if isinstance(base, ClassValue) else ():
            if not isinstance(statement, facts.Annotated) or not isinstance(base, ClassValue):
                continue
            if isinstance(statement.target, facts.Name) and statement.target.id == name:
                meant = class_named(machine, base.scope, statement.annotation)
                return None if meant is None else Unknown(f"nothing here sets '{name}'", annotation=meant)
    return None


def attribute_of(machine: Machine, value: Unknown, name: str) -> Value | None:
    """What is known of an attribute of something of which only the class is known."""
    cls = value.annotation
    if not isinstance(cls, ClassValue):
        return None
    given = declared(machine, cls, name)
    if isinstance(given, Unknown):
        return given.annotation
    return AttributeOf(cls, _behind_property(machine, cls, name))


def _behind_property(machine: Machine, cls: ClassValue, name: str) -> str:
    """The attribute that a property gives: of ``return self._node``, ``_node``."""
    for base in cls.mro:
        found = machine.store.get(base.key, name) if isinstance(base, ClassValue) else None
        if isinstance(found, FunctionValue) and "property" in found.decorators and isinstance(found.ir, facts.Function):
            last = found.ir.body[-1]
            given = last.value if isinstance(last, facts.Return) else None
            if isinstance(given, facts.Attribute) and isinstance(given.value, facts.Name):
                return given.attr
    return name


__all__ = ["annotated", "attribute_of", "class_named", "declared"]
