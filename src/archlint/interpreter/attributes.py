"""Attributes: of modules, classes and objects; of what is foreign, the library says what they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers, hints, overloads, path_parts, registries, text_methods
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.classes import SETTERS
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
    Member,
    ModuleValue,
    OneOf,
    Partial,
    PythonValue,
    SuperValue,
    Unknown,
    Value,
    alternatives,
    chosen_with,
    one_of,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine


def get_attribute(machine: Machine, value: Value, name: str, expression: facts.Attribute | None = None) -> Value:
    """``value.name``."""
    if expression is not None and isinstance(value, (OneOf, External, ForeignValue, ApiMethod)):
        machine.library.read(value, name, expression.span)
    match value:
        case Instance():
            result = _of_instance(machine, value, name)
            if expression is not None and isinstance(value.cls, ClassValue):
                machine.library.note_own_read(value, name, expression.span, result)
            return result
        case External():
            return _of_external(machine, value, name)
        case ModuleValue():
            return _of_module(machine, value, name)
        case ClassValue():
            return _of_class(machine, value, name)
        case ForeignValue():
            return machine.library.attribute_of_value(value, name)
        case Unknown():
            return _of_unknown(machine, value, name)
        case OneOf():
            result = chosen_with(one_of(get_attribute(machine, option, name) for option in value.values), value)
            if expression is not None and any(option.own_class is not None for option in value.values):
                machine.library.note_own_read(value, name, expression.span, result)
            return result
        case SuperValue():
            return _of_super(machine, value, name)
        case BoundMethod() | FunctionValue():
            return _of_function(value, name)
        case ApiMethod() if machine.activation.module.file.kind == "cpp":  # a field of a base from elsewhere
            return _of_unknown(machine, Unknown(f"'{value.path}' is not followed"), name)
        case Partial(function=ClassValue() as cls) if machine.activation.module.file.kind == "cpp":
            return _of_named_template(machine, value, cls, name)
    return _of_builtin_type(machine, value, name)


def has_member(machine: Machine, value: Value, name: str) -> bool:
    """Whether an object has an attribute of its own, or one that a class of the workspace gives it."""
    if value.heap_key and machine.store.get(value.heap_key, name) is not None:
        return True
    cls = value.own_class
    return cls is not None and cls.lookup(machine, name)[0] is not None


def method_of(machine: Machine, value: Value, name: str) -> BoundMethod | None:
    """A method that an object has from a class of the workspace; None of other values."""
    method = None if value.own_class is None else get_attribute(machine, value, name)
    return method if isinstance(method, BoundMethod) else None


def _of_builtin_type(machine: Machine, value: Value, name: str) -> Value:
    """Of a text, a number, a list …, whose types are Python's own: a method, whether there is one or not."""
    match value:
        case ListValue(kind=kind):
            return Builtin(f"{kind}.{name}", value)
        case DictValue():
            return Builtin(f"dict.{name}", value)
        case Known() if name == "parent" and value.is_text:  # of a pathlib.Path
            return path_parts.folder_of(machine, value)
        case Known(kind="path") if name in path_parts.ATTRIBUTES:
            return path_parts.attribute(machine, value, name)
        case Known():
            return Builtin(f"{value.python_type.__name__}.{name}", value)
        case Holed():
            return Builtin(f"str.{name}", value)
        case Builtin():
            return Builtin(f"{value.name}.{name}")
    return _not_followed(name)


def _of_named_template(machine: Machine, value: Partial, cls: ClassValue, name: str) -> Value:
    """What ``using ScanRelay = Relay<LaserScan>`` has: what the class has, its constructor with these arguments."""
    member = _of_class(machine, cls, name)
    return Partial(member, value.args, value.keywords) if name == "__init__" else member


def _of_function(value: BoundMethod | FunctionValue, name: str) -> Value:
    match value:
        case BoundMethod() if name == "__func__":
            return value.function
        case BoundMethod(function=FunctionValue(ir=facts.Function() as ir)) | FunctionValue(ir=facts.Function() as ir):
            if name in ("__name__", "__qualname__"):
                return Known(ir.name)
    return _not_followed(name)


def _not_followed(name: str) -> Unknown:
    return Unknown(f"the attribute '{name}' of a value that is not followed")


def _of_module(machine: Machine, value: ModuleValue, name: str) -> Value:
    attribute = machine.module_attribute(value.module, name)
    return Unknown(f"{value.module.name} has no '{name}'") if attribute is None else attribute


def _of_unknown(machine: Machine, value: Unknown, name: str) -> Value:
    if value.of_class == "str" and name in text_methods.METHODS:
        return Builtin(f"str.{name}", value)
    method = machine.library.method_of_unknown(value, name)
    return method or Unknown(value.reason, value.parameter, hints.attribute_of(machine, value, name))


def bind(machine: Machine, value: Value, instance: Value, cls: Value) -> Value:
    """What a class attribute is when it is read from an instance."""
    if not isinstance(value, FunctionValue) or "staticmethod" in value.decorators:
        return value
    if "classmethod" in value.decorators:
        return BoundMethod(value, cls)
    bound = BoundMethod(value, instance)
    return machine.call(bound) if "property" in value.decorators else bound


def _of_instance(machine: Machine, value: Instance, name: str) -> Value:
    stored = machine.store.get(value.key, name)
    if isinstance(stored, Member):
        return _made(machine, value, name, stored)
    if stored is not None:
        return stored
    if isinstance(value.cls, External):
        return machine.library.attribute_of_object(value, value.cls, name)
    return _of_own_object(machine, value, value.cls, name)


def _made(machine: Machine, owner: Instance, name: str, member: Member) -> Value:
    """A member that nothing has made with arguments, as an object."""
    value = machine.call(member.cls, CallSite([], dict(member.keywords)))
    machine.store.set(owner.key, name, value)
    return value


def _of_own_object(machine: Machine, value: Instance, cls: ClassValue, name: str) -> Value:
    """Of an object of a class of the workspace, by way of the class."""
    attribute, owner = cls.lookup(machine, name)
    if attribute is None and isinstance(owner, External):
        attribute = _behind(machine, value, cls, owner, name)
    if attribute is not None:
        return bind(machine, attribute, value, cls)
    if name == "__class__":
        return cls
    if name == "__dict__":
        return AttributesValue(value)
    only_annotated = hints.declared(machine, cls, name)
    if only_annotated is not None:
        return only_annotated
    match owner:
        case External():
            return machine.library.inherited(value, owner, name)
        case Unknown():
            return machine.library.method_of_unknown(value, name) or Unknown(owner.reason)
    getter, _ = cls.lookup(machine, "__getattr__")
    if getter is not None:
        return machine.call(bind(machine, getter, value, cls), CallSite([Known(name)]))
    missing = Unknown(f"'{cls.ir.name}' has no attribute '{name}'", missing=name)
    return machine.library.method_mixed_in(value, name) or missing


def _behind(machine: Machine, value: Value, cls: ClassValue, base: External, name: str) -> Value | None:
    """What a class of ours has that comes after a foreign base, as in ``class Robot(Node, Arms)``, where that base
    certainly has no attribute of this name."""
    if not machine.library.lacks(ApiMethod(f"{base.path}.{name}", value)):
        return None
    return cls.lookup(machine, name, after=base)[0]


def _of_external(machine: Machine, value: External, name: str) -> Value:
    path = f"{value.path}.{name}"
    if machine.activations:
        module = machine.index.find(machine.activation.module, path)
        if module is not None:
            return machine.import_module(module)
        if (included := _of_namespace(machine, value.path, name)) is not None:
            return included
    if len(path) > TEXT_LIMIT:
        return Unknown("a name too long to follow")
    return machine.library.attribute_of_external(value, name)


def _of_namespace(machine: Machine, namespace: str, name: str) -> Value | None:
    """What a C++ file calls ``nav2_util::LifecycleNode`` where it includes a file of the package nav2_util that defines
    that; None where the library is not of this workspace."""
    scope = machine.activation.module.scope
    if machine.activation.module.file.kind != "cpp" or scope is None:
        return None
    included = machine.store.get(scope.key, name)
    if not isinstance(included, (ClassValue, FunctionValue)) or included.scope.module.file.package != namespace:
        return None
    return included


def _of_class(machine: Machine, value: ClassValue, name: str) -> Value:
    attribute, owner = value.lookup(machine, name)
    if attribute is not None:
        of_class = isinstance(attribute, FunctionValue) and "classmethod" in attribute.decorators
        return BoundMethod(attribute, value) if of_class else attribute
    match name:
        case "__name__":
            return Known(value.ir.name)
        case "__members__" if machine.store.get(value.key, MEMBERS):
            return _members(machine, value)
        case "__mro__":
            return Unknown("the bases of a class")
        case "__subclasses__":
            return registries.subclasses(machine, value)
    match owner:
        case External():
            return External(f"{owner.path}.{name}")
        case Unknown():
            return Unknown(owner.reason)
    return Unknown(f"'{value.ir.name}' has no attribute '{name}'")


def _members(machine: Machine, cls: ClassValue) -> Value:
    """The members of an enum by name."""
    names = machine.store.get(cls.key, MEMBERS) or ()
    return containers.dict_of_names(machine, {name: _of_class(machine, cls, name) for name in names})


def _of_super(machine: Machine, value: SuperValue, name: str) -> Value:
    instance = value.self_value
    cls = instance if isinstance(instance, ClassValue) else instance.own_class or value.owner
    attribute, owner = cls.lookup(machine, name, after=value.owner)
    if attribute is None and isinstance(owner, External):
        attribute = _behind(machine, instance, cls, owner, name)
    if attribute is not None:
        return bind(machine, attribute, instance, cls)
    match name, owner:
        case "__new__", _:
            return Builtin("object.__new__")
        case "__init__", External():
            return ApiMethod(f"{owner.dotted}.__init__", instance)
        case _, External():
            return machine.library.inherited(instance, owner, name)
        case _, Unknown():
            return ApiMethod(f"?.{name}", instance)
    return PythonValue(f"object.{name}", lambda *_, **__: NONE)


def set_attribute(
    machine: Machine, target: Value, name: str, value: Value, expression: facts.Attribute | None = None
) -> None:
    """``target.name = value``; where the target is one of several, each may now hold it."""
    if expression is not None:
        machine.library.written(target, name, expression.span, value)
    options = alternatives(target)
    if len(options) == 1:
        _set_one(machine, target, name, value)
        return
    for option in options:
        if isinstance(option, External):
            _set_one(machine, option, name, Unknown("it is set on one of several objects"))
            continue
        before = machine.store.get(option.heap_key, name) if option.heap_key else None
        _set_one(machine, option, name, value if before is None else one_of((before, value)))


def _set_one(machine: Machine, target: Value, name: str, value: Value) -> None:
    cls = target.own_class
    if cls is not None and _is_property(cls.lookup(machine, name)[0]):
        setter = _setter(machine, cls, name)
        if setter is not None:
            machine.call(BoundMethod(setter, target), CallSite([value]))
        return
    if _defines_method(target, value):
        overloads.note(machine.index.overloads, target.heap_key or 0, name, value)
    else:
        machine.library.assigned(target, name, value)
    if isinstance(target, ModuleValue):
        if target.module.scope is not None:
            machine.store.set(target.module.scope.key, name, value)
    elif target.heap_key:
        machine.store.set(target.heap_key, name, value)


def _defines_method(target: Value, value: Value) -> bool:
    """Whether a class gets a method that C++ defines outside of it."""
    if not isinstance(target, ClassValue) or not isinstance(value, FunctionValue):
        return False
    return value.scope.module.file.kind == "cpp"


def _is_property(attribute: Value | None) -> bool:
    return isinstance(attribute, FunctionValue) and "property" in attribute.decorators


def _setter(machine: Machine, cls: ClassValue, name: str) -> FunctionValue | None:
    """The setter of a property, of a class or the first of those it derives from."""
    setters = (machine.store.get(base.key, SETTERS[name]) for base in cls.classes)
    return next((setter for setter in setters if setter is not None), None)


__all__ = ["bind", "get_attribute", "has_member", "method_of", "set_attribute"]
