"""Attributes: of modules, classes and objects; of what is foreign, the library says what they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers, hints, registries
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.classes import SETTERS, class_lookup
from archlint.interpreter.values import (
    MEMBERS,
    NONE,
    TEXT_LIMIT,
    ApiMethod,
    AttributesValue,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    ForeignValue,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    ModuleValue,
    OneOf,
    PythonValue,
    SuperValue,
    Unknown,
    Value,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def get_attribute(machine: Machine, value: Value, name: str, expression: facts.Attribute | None = None) -> Value:
    """``value.name``."""
    if expression is not None and isinstance(value, (OneOf, External, ForeignValue)):
        machine.library.read(value, name, expression.span)
    if isinstance(value, OneOf):
        return one_of(get_attribute(machine, option, name) for option in value.values)
    if isinstance(value, Instance):
        return _of_instance(machine, value, name)
    if isinstance(value, ModuleValue):
        found = machine.module_attribute(value.module, name)
        return Unknown(f"{value.module.name} has no '{name}'") if found is None else found
    if isinstance(value, External):
        return _of_external(machine, value, name)
    if isinstance(value, ClassValue):
        return _of_class(machine, value, name)
    if isinstance(value, SuperValue):
        return _of_super(machine, value, name)
    if isinstance(value, ForeignValue):
        return machine.library.attribute_of_value(value, name)
    if isinstance(value, Known) and name == "parent" and isinstance(value.value, str):
        return Known(value.value.rpartition("/")[0] or "/", value.via, kind="path")  # of a pathlib.Path
    if isinstance(value, (ListValue, DictValue, Known, Holed)):
        return Builtin(f"{_type_name(value)}.{name}", value)
    if isinstance(value, BoundMethod) and name == "__func__":
        return value.function
    if isinstance(value, (FunctionValue, BoundMethod)) and name in ("__name__", "__qualname__"):
        function = value.function if isinstance(value, BoundMethod) else value
        if isinstance(function, FunctionValue) and isinstance(function.ir, facts.Function):
            return Known(function.ir.name)
    if isinstance(value, Unknown):
        method = machine.library.method_of_unknown(value, name)
        if method is not None:
            return method
        return Unknown(value.reason, value.parameter, hints.attribute_of(machine, value, name))
    if isinstance(value, Builtin):
        return Builtin(f"{value.name}.{name}")
    return Unknown(f"the attribute '{name}' of a value that is not followed")


def _type_name(value: Value) -> str:
    if isinstance(value, ListValue):
        return value.kind
    if isinstance(value, DictValue):
        return "dict"
    if isinstance(value, Known):
        return type(value.value).__name__
    return "str"


def bind(machine: Machine, value: Value, instance: Value, cls: Value) -> Value:
    """What a class attribute is when it is read from an instance."""
    if isinstance(value, FunctionValue):
        if "staticmethod" in value.decorators:
            return value
        if "classmethod" in value.decorators:
            return BoundMethod(value, cls)
        bound = BoundMethod(value, instance)
        if "property" in value.decorators:
            return machine.call(bound)
        return bound
    return value


def _of_instance(machine: Machine, value: Instance, name: str) -> Value:
    stored = machine.store.get(value.key, name)
    if stored is not None:
        return stored
    if isinstance(value.cls, External):
        return machine.library.attribute_of_object(value, value.cls, name)
    found, owner = class_lookup(machine, value.cls, name)
    if found is not None:
        return bind(machine, found, value, value.cls)
    if name == "__class__":
        return value.cls
    if name == "__dict__":
        return AttributesValue(value)
    only_annotated = hints.declared(machine, value.cls, name)
    if only_annotated is not None:
        return only_annotated
    if isinstance(owner, External):
        return machine.library.inherited(value, owner, name)
    if isinstance(owner, Unknown):
        return machine.library.method_of_unknown(value, name) or Unknown(owner.reason)
    getter, _ = class_lookup(machine, value.cls, "__getattr__")
    if getter is not None:
        return machine.call(bind(machine, getter, value, value.cls), CallSite([Known(name)]))
    mixed_in = machine.library.method_mixed_in(value, name)
    if mixed_in is not None:
        return mixed_in
    return Unknown(f"'{value.cls.ir.name}' has no attribute '{name}'", missing=name)


def _of_external(machine: Machine, value: External, name: str) -> Value:
    path = f"{value.path}.{name}"
    if machine.activations:
        module = machine.index.find(machine.activation.module, path)
        if module is not None:
            return machine.import_module(module)
    if len(path) > TEXT_LIMIT:
        return Unknown("a name too long to follow")
    return machine.library.attribute_of_external(value, name)


def _of_class(machine: Machine, value: ClassValue, name: str) -> Value:
    found, owner = class_lookup(machine, value, name)
    if found is not None:
        if isinstance(found, FunctionValue) and "classmethod" in found.decorators:
            return BoundMethod(found, value)
        return found
    if name == "__name__":
        return Known(value.ir.name)
    names = machine.store.get(value.key, MEMBERS) if name == "__members__" else None
    if names:
        entries = {
            containers.hashable(Known(member)): (Known(member), _of_class(machine, value, member)) for member in names
        }
        return containers.new_dict(machine, {k: v for k, v in entries.items() if k is not None})
    if name == "__mro__":
        return Unknown("the bases of a class")
    if name == "__subclasses__":
        return registries.subclasses(machine, value)
    if isinstance(owner, External):
        return External(f"{owner.path}.{name}")
    if isinstance(owner, Unknown):
        return Unknown(owner.reason)
    return Unknown(f"'{value.ir.name}' has no attribute '{name}'")


def _of_super(machine: Machine, value: SuperValue, name: str) -> Value:
    instance = value.self_value
    cls = instance.cls if isinstance(instance, Instance) else instance if isinstance(instance, ClassValue) else None
    if not isinstance(cls, ClassValue):
        cls = value.owner
    if name == "__init__":
        found, owner = _next_init(machine, cls, value.owner)
    else:
        found, owner = class_lookup(machine, cls, name, after=value.owner)
    if found is not None:
        return bind(machine, found, instance, cls)
    if name == "__new__":
        return Builtin("object.__new__")
    if isinstance(owner, External):
        if name == "__init__":
            return ApiMethod(f"{owner.path}.__init__", instance)
        return machine.library.inherited(instance, owner, name)
    if isinstance(owner, Unknown):
        return ApiMethod(f"?.{name}", instance)
    return PythonValue(f"object.{name}", lambda *_, **__: NONE)


def _next_init(machine: Machine, cls: ClassValue, owner: ClassValue) -> tuple[Value | None, Value]:
    return class_lookup(machine, cls, "__init__", after=owner)


def set_attribute(
    machine: Machine, target: Value, name: str, value: Value, expression: facts.Attribute | None = None
) -> None:
    """``target.name = value``; where the target is one of several, each may now hold it."""
    if expression is not None:
        machine.library.written(target, name, expression.span)
    if isinstance(target, OneOf):
        for option in target.values:
            if isinstance(option, External):
                _set_one(machine, option, name, Unknown("it is set on one of several objects"))
                continue
            before = _stored(machine, option, name)
            _set_one(machine, option, name, value if before is None else one_of((before, value)))
        return
    _set_one(machine, target, name, value)


def _stored(machine: Machine, target: Value, name: str) -> Value | None:
    return machine.store.get(target.heap_key, name) if target.heap_key else None


def _set_one(machine: Machine, target: Value, name: str, value: Value) -> None:
    if isinstance(target, Instance) and isinstance(target.cls, ClassValue):
        found, _ = class_lookup(machine, target.cls, name)
        if isinstance(found, FunctionValue) and "property" in found.decorators:
            setter = machine.store.get(_owner_key(machine, target.cls, name), SETTERS[name])
            if setter is not None:
                machine.call(BoundMethod(setter, target), CallSite([value]))
            return
    machine.library.assigned(target, name, value)
    if isinstance(target, ModuleValue):
        assert target.module.scope is not None
        machine.store.set(target.module.scope.key, name, value)
        return
    if target.heap_key:
        machine.store.set(target.heap_key, name, value)


def _owner_key(machine: Machine, cls: ClassValue, name: str) -> int:
    setter = SETTERS[name]
    return next((base.key for base in cls.classes if machine.store.get(base.key, setter) is not None), cls.key)


__all__ = ["bind", "get_attribute", "set_attribute"]
