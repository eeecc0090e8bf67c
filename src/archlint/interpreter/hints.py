"""What annotations say of values that nothing here is seen to pass: the class of a node, or of what holds one."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.modules import Scope
from archlint.interpreter.values import AttributeOf, ClassValue, FunctionValue, ModuleValue, Unknown, Value
from archlint.syntax import facts
from archlint.syntax.parts import once_for

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

_OPTIONAL = ("Optional", "Annotated", "Final", "ClassVar")


def class_named(machine: Machine, scope: Scope, annotation: facts.Expr | None) -> ClassValue | None:
    """The class of the workspace that an annotation in a scope means, be it one of ours or nothing."""
    path: list[str] = []
    match annotation:
        case facts.Binary():
            return class_named(machine, scope, annotation.left) or class_named(machine, scope, annotation.right)
        case facts.Subscript():
            inside = annotation.index if annotation.value.last_name in _OPTIONAL else None
            return class_named(machine, scope, inside)
        case facts.Literal(value=str(text)):
            path = text.split(".")
        case facts.Name() | facts.Attribute():
            path = annotation.dotted.split(".")
    value = _lookup(machine, scope, path[0]) if path else None
    for name in path[1:]:
        value = machine.module_attribute(value.module, name) if isinstance(value, ModuleValue) else None
    return value if isinstance(value, ClassValue) else None


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


def declared(machine: Machine, cls: ClassValue, name: str) -> Unknown | None:
    """What the attribute of an object is where its class only says ``name: Supervisor``; None where it does not."""
    for base in cls.classes:
        annotation = _annotations_of(base.ir).get(name)
        if annotation is not None:
            meant = class_named(machine, base.scope, annotation)
            return None if meant is None else Unknown(f"nothing here sets '{name}'", annotation=meant)
    return None


@once_for
def _annotations_of(cls: facts.Class) -> dict[str, facts.Expr]:
    """The annotations in the body of a class, the first of each name."""
    annotations: dict[str, facts.Expr] = {}
    for statement in cls.body:
        match statement:
            case facts.Annotated(target=facts.Name(id=name)):
                annotations.setdefault(name, statement.annotation)
    return annotations


def attribute_of(machine: Machine, value: Unknown, name: str) -> Value | None:
    """What is known of an attribute of something of which only the class is known."""
    cls = value.annotation
    if not isinstance(cls, ClassValue):
        return None
    given = declared(machine, cls, name)
    return AttributeOf(cls, _behind_property(machine, cls, name)) if given is None else given.annotation


def _behind_property(machine: Machine, cls: ClassValue, name: str) -> str:
    """The attribute that a property gives: of ``return self._node``, ``_node``."""
    for base in cls.classes:
        match machine.store.get(base.key, name):
            case FunctionValue(ir=facts.Function(body=[*_, last])) as function if "property" in function.decorators:
                match last:
                    case facts.Return(value=facts.Attribute(value=facts.Name(), attr=attribute)):
                        return attribute
    return name


__all__ = ["annotated", "attribute_of", "class_named", "declared"]
