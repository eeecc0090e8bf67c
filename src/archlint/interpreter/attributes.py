"""Attributes: of modules, classes, instances, foreign objects and what rclpy makes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import hints
from archlint.interpreter.heap import Items
from archlint.interpreter.values import (
    NONE,
    TEXT_LIMIT,
    ApiMethod,
    AttributesValue,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    EntityValue,
    ExecutorValue,
    External,
    FunctionValue,
    FutureValue,
    Holed,
    Instance,
    Known,
    ListValue,
    MessageValue,
    ModuleValue,
    NodeValue,
    OneOf,
    PythonValue,
    SuperValue,
    Unknown,
    Value,
    one_of,
)
from archlint.libraries.python import command_line
from archlint.libraries.rclpy import escapes, messages, profiles
from archlint.libraries.rclpy import names as rclpy_names
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.machine import Run


def get_attribute(run: Run, value: Value, name: str, expression: facts.Attribute | None = None) -> Value:
    """``value.name``."""
    if isinstance(value, OneOf):
        if expression is not None:
            messages.note_use(run, value, name, expression.span, "read")
        return one_of(get_attribute(run, option, name) for option in value.values)
    if isinstance(value, Instance):
        return _of_instance(run, value, name)
    if isinstance(value, ModuleValue):
        found = run.module_attribute(value.module, name)
        return Unknown(f"{value.module.name} has no '{name}'") if found is None else found
    if isinstance(value, External):
        if expression is not None and value.path.endswith((".msg", ".srv", ".action")):
            messages.note_interface(run, f"{value.path}.{name}", expression.span)
        if expression is not None:
            messages.note_constant(run, value.path, name, expression.span)
        return _of_external(run, value, name)
    if isinstance(value, ClassValue):
        return _of_class(run, value, name)
    if isinstance(value, SuperValue):
        return _of_super(run, value, name)
    if isinstance(value, (NodeValue,)):
        return _of_node(run, value, name)
    if isinstance(value, EntityValue):
        return _of_entity(run, value, name)
    if isinstance(value, ExecutorValue):
        return ApiMethod(f"{value.path}.{name}", value)
    if isinstance(value, FutureValue):
        return ApiMethod(f"rclpy.task.Future.{name}", value)
    if isinstance(value, MessageValue):
        if expression is not None:
            messages.note_use(run, value, name, expression.span, "read")
        return _of_message(run, value, name)
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
    if isinstance(value, Unknown) and name in rclpy_names.NODE_METHODS:
        return ApiMethod(f"rclpy.node.Node.{name}", value)
    if isinstance(value, Unknown):
        return Unknown(value.reason, value.parameter, hints.attribute_of(run, value, name))
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


def class_lookup(run: Run, cls: ClassValue, name: str, after: ClassValue | None = None) -> tuple[Value | None, Value]:
    """A class attribute through the MRO: ``(value, class it was found on)``; value None where it is not found.

    A foreign base that may define the name ends the search with that base.
    """
    started = after is None
    for base in cls.mro:
        if not started:
            started = base is after
            continue
        if isinstance(base, ClassValue):
            value = run.store.get(base.key, name)
            if isinstance(value, Value):
                return value, base
        elif isinstance(base, External):
            if base.path in ("builtins.object", "object"):
                continue
            if base.path not in rclpy_names.PLAIN_BASES:
                return None, base
        elif isinstance(base, Unknown):
            return None, base
    return None, cls


def bind(run: Run, value: Value, instance: Value, cls: Value) -> Value:
    """What a class attribute is when it is read from an instance."""
    if isinstance(value, FunctionValue):
        if "staticmethod" in value.decorators:
            return value
        if "classmethod" in value.decorators:
            return BoundMethod(value, cls)
        bound = BoundMethod(value, instance)
        if "property" in value.decorators:
            return run.call(bound, [], {})
        return bound
    return value


def _of_instance(run: Run, value: Instance, name: str) -> Value:
    stored = run.store.get(value.key, name)
    if isinstance(stored, Value):
        return stored
    if isinstance(value.cls, External):
        return _of_foreign_instance(run, value, value.cls, name)
    found, owner = class_lookup(run, value.cls, name)
    if found is not None:
        return bind(run, found, value, value.cls)
    if name == "__class__":
        return value.cls
    if name == "__dict__":
        return AttributesValue(value)
    only_annotated = hints.declared(run, value.cls, name)
    if only_annotated is not None:
        return only_annotated
    if isinstance(owner, External):
        return _inherited(run, value, rclpy_names.canonical(owner.path), name)
    if isinstance(owner, Unknown):
        if name in rclpy_names.NODE_METHODS:
            return ApiMethod(f"rclpy.node.Node.{name}", value)
        return Unknown(owner.reason)
    getter, _ = class_lookup(run, value.cls, "__getattr__")
    if getter is not None:
        return run.call(bind(run, getter, value, value.cls), [Known(name)], {})
    if name in rclpy_names.NODE_METHODS and name.startswith("create_"):
        return ApiMethod(f"rclpy.node.Node.{name}", value)
    return Unknown(f"'{value.cls.ir.name}' has no attribute '{name}'", name=f"missing:{name}")


def _inherited(run: Run, value: Value, base: str, name: str) -> Value:
    """An attribute that a foreign base class gives an object of ours."""
    if base in rclpy_names.NODE_CLASSES:
        special = _node_attribute(run, value, name)
        if special is not None:
            return special
        return ApiMethod(rclpy_names.method(base, name), value)
    if name in rclpy_names.NODE_METHODS and not rclpy_names.is_api_class(base):
        return ApiMethod(f"rclpy.node.Node.{name}", value)
    return ApiMethod(f"{base}.{name}", value)


def _node_attribute(run: Run, value: Value, name: str) -> Value | None:
    """Attributes of every node that are values rather than methods."""
    if name == "default_callback_group":
        return External("rclpy.node.Node.default_callback_group")
    if name == "executor":
        from archlint.libraries.rclpy import executors

        use = executors.running(run, run.blueprints.get(value.key) if isinstance(value, Instance) else None)
        if use is not None:
            return ExecutorValue(use, "rclpy.executors.Executor", run.store.new_key())
        return Unknown("the executor is set when the node is spun")
    return None


def _of_foreign_instance(run: Run, value: Instance, cls: External, name: str) -> Value:
    path = rclpy_names.canonical(cls.path)
    if path == "rclpy.parameter.Parameter" and name in ("value", "get_parameter_value"):
        held = run.store.get(value.key, "value")
        if name == "value":
            return held if isinstance(held, Value) else Unknown("the parameter has no value here")
        answer = held if isinstance(held, Value) else Unknown("the parameter has no value here")
        return PythonValue("get_parameter_value", lambda *_, **__: answer_of(run, answer))
    if path in rclpy_names.PARAMETER_VALUES:
        held = run.store.get(value.key, "value")
        if isinstance(held, Value) and name.endswith("_value"):
            return held
        if name == "type":
            if isinstance(held, Known) and type(held.value) in _PARAMETER_TYPES:
                # A declared parameter keeps its type, whatever is set.
                return Known(_PARAMETER_TYPES[type(held.value)])
            return Unknown("the type of a parameter")
    if path == "launch.LaunchDescription" and name == "entities":
        from archlint.interpreter import containers

        actions = run.store.get(value.key, "#entities")
        if isinstance(actions, Items):
            return containers.new_list(run, actions.values, "list", actions.open)
    return ApiMethod(f"{path}.{name}", value)


_PARAMETER_TYPES: dict[type, int] = {bool: 1, int: 2, float: 3, str: 4}
"""The constants of ``rcl_interfaces/msg/ParameterType``."""


def answer_of(run: Run, held: Value) -> Value:
    """A ``rcl_interfaces/msg/ParameterValue`` that holds a value: ``.string_value`` and the like read it."""
    made = Instance(External("rcl_interfaces.msg.ParameterValue"), run.store.new_key())
    run.store.set(made.key, "value", held)
    return made


def _of_external(run: Run, value: External, name: str) -> Value:
    path = f"{value.path}.{name}"
    if path == "sys.argv":
        return command_line.program_arguments(run)
    if run.activations:
        module = run.index.find(run.activation.module, path)
        if module is not None:
            return run.import_module(module)
    if len(path) > TEXT_LIMIT:
        return Unknown("a name too long to follow")
    constant = _interface_constant(run, value.path, name)
    if constant is not None:
        return constant
    known = rclpy_names.CONSTANTS.get(rclpy_names.canonical(path))
    if known is not None:
        return Known(known)
    return messages.missing_interface(run, path) or External(path, value.via)


def _interface_constant(run: Run, path: str, name: str) -> Value | None:
    """A constant of a ``.msg``, ``.srv`` or ``.action`` file, or the name of the class made from it."""
    if run.interfaces is None:
        return None
    interface, part = rclpy_names.interface_and_part(path)
    if interface is None:
        return None
    if name == "__name__" and not part:
        return Known(interface.rpartition("/")[2])
    value = run.interfaces.constant(interface, part, name)
    return None if value is None else Known(value)


def _of_class(run: Run, value: ClassValue, name: str) -> Value:
    found, owner = class_lookup(run, value, name)
    if found is not None:
        if isinstance(found, FunctionValue) and "classmethod" in found.decorators:
            return BoundMethod(found, value)
        return found
    if name == "__name__":
        return Known(value.ir.name)
    if name == "__members__" and run.store.get(value.key, "#members"):
        from archlint.interpreter import containers

        names = run.store.get(value.key, "#members")
        assert isinstance(names, tuple)
        entries = {
            containers.hashable(Known(member)): (Known(member), _of_class(run, value, member)) for member in names
        }
        return containers.new_dict(run, {k: v for k, v in entries.items() if k is not None})
    if name == "__mro__":
        return Unknown("the bases of a class")
    if name == "__subclasses__":
        from archlint.interpreter import registries

        return registries.subclasses(run, value)
    if isinstance(owner, External):
        return External(f"{owner.path}.{name}")
    if isinstance(owner, Unknown):
        return Unknown(owner.reason)
    return Unknown(f"'{value.ir.name}' has no attribute '{name}'")


def _of_super(run: Run, value: SuperValue, name: str) -> Value:
    instance = value.self_value
    cls = instance.cls if isinstance(instance, Instance) else instance if isinstance(instance, ClassValue) else None
    if not isinstance(cls, ClassValue):
        cls = value.owner
    if name == "__init__":
        found, owner = _next_init(run, cls, value.owner)
    else:
        found, owner = class_lookup(run, cls, name, after=value.owner)
    if found is not None:
        return bind(run, found, instance, cls)
    if name == "__new__":
        return Builtin("object.__new__")
    if isinstance(owner, External):
        path = rclpy_names.canonical(owner.path)
        return _inherited(run, instance, path, name) if name != "__init__" else ApiMethod(f"{path}.__init__", instance)
    if isinstance(owner, Unknown):
        return ApiMethod(f"?.{name}", instance)
    return PythonValue(f"object.{name}", lambda *_, **__: NONE)


def _next_init(run: Run, cls: ClassValue, owner: ClassValue) -> tuple[Value | None, Value]:
    return class_lookup(run, cls, "__init__", after=owner)


def _of_node(run: Run, value: NodeValue, name: str) -> Value:
    stored = run.store.get(value.key, name)
    if isinstance(stored, Value):
        return stored
    special = _node_attribute(run, value, name)
    if special is not None:
        return special
    base = "rclpy.lifecycle.node.LifecycleNode" if value.blueprint.lifecycle else "rclpy.node.Node"
    return ApiMethod(rclpy_names.method(base, name), value)


_NAME_ATTRIBUTES = {"topic", "topic_name", "srv_name", "service_name", "_action_name", "_topic", "_srv_name"}


def _of_entity(run: Run, value: EntityValue, name: str) -> Value:
    stored = run.store.get(value.key, name)
    if isinstance(stored, Value):
        return stored
    if name in _NAME_ATTRIBUTES and len(value.creations) == 1:
        text = value.creations[0].name
        if text.resolution == "exact" and text.text is not None and text.text.startswith("/"):
            return Known(text.text)
        return Unknown("the full name of an endpoint depends on its node")
    return ApiMethod(f"{value.path}.{name}", value)


def _of_message(run: Run, value: MessageValue, name: str) -> Value:
    stored = run.store.get(value.key, name) if value.key else None
    if isinstance(stored, Value):
        return stored
    if run.interfaces is not None:
        constant = run.interfaces.constant(value.type, value.part, name)
        if constant is not None:
            return Known(constant)
    nested = messages.nested(run, value, name)
    return Unknown(f"the field '{name}' of a message") if nested is None else nested


def set_attribute(run: Run, target: Value, name: str, value: Value, expression: facts.Attribute | None = None) -> None:
    """``target.name = value``; where the target is one of several, each may now hold it."""
    if expression is not None:
        messages.note_use(run, target, name, expression.span, "write")
    if isinstance(target, OneOf):
        for option in target.values:
            if isinstance(option, External):
                _set_one(run, option, name, Unknown("it is set on one of several objects"))
                continue
            before = _stored(run, option, name)
            _set_one(run, option, name, value if before is None else one_of((before, value)))
        return
    _set_one(run, target, name, value)


def _stored(run: Run, target: Value, name: str) -> Value | None:
    key = getattr(target, "key", None)
    value = run.store.get(key, name) if isinstance(key, int) else None
    return value if isinstance(value, Value) else None


def _set_one(run: Run, target: Value, name: str, value: Value) -> None:
    if isinstance(target, Instance) and isinstance(target.cls, ClassValue):
        found, _ = class_lookup(run, target.cls, name)
        if isinstance(found, FunctionValue) and "property" in found.decorators:
            setter = run.store.get(_owner_key(run, target.cls, name), f"#setter:{name}")
            if isinstance(setter, FunctionValue):
                run.call(BoundMethod(setter, target), [value], {})
            return
    escapes.assigned(run, target, name, value)
    if isinstance(target, ModuleValue):
        assert target.module.scope is not None
        run.store.set(target.module.scope.key, name, value)
        return
    if isinstance(target, MessageValue) and not target.key:
        return
    if isinstance(target, External):
        profiles.change_preset(run, target, name, value)
        return
    key = getattr(target, "key", None)
    if isinstance(key, int):
        run.store.set(key, name, value)


def _owner_key(run: Run, cls: ClassValue, name: str) -> int:
    for base in cls.mro:
        if isinstance(base, ClassValue) and run.store.get(base.key, f"#setter:{name}") is not None:
            return base.key
    return cls.key


__all__ = ["bind", "class_lookup", "get_attribute", "set_attribute"]
