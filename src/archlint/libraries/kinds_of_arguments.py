"""What the parameters of a call take, and what values certainly are not that."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum

from archlint.interpreter.values import (
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
)
from archlint.libraries.rclpy import names, node_classes
from archlint.libraries.rclpy.profile_parts import PROFILE
from archlint.libraries.tables import Api
from archlint.libraries.values import EntityValue, MessageValue, NodeValue
from archlint.model import EntityKind, Role
from archlint.syntax import facts
from archlint.syntax.parts import once_for


class Kind(Enum):
    """What a parameter takes, in the words of a message."""

    MESSAGE = "a message class"
    SERVICE = "a service class"
    ACTION = "an action class"
    NAME = "a text"
    PROFILE = "a QoSProfile or a queue depth"
    CALLBACK = "a function"
    EXECUTE_CALLBACK = "a function that executes goals"
    """None of these is refused, too: ``ActionServer`` asks whether it is callable."""
    NODE = "a node"
    SECONDS = "a number of seconds"
    HERTZ = "a number of hertz"
    EXECUTOR = "an executor"
    PUBLISHER = "a publisher"
    SUBSCRIPTION = "a subscription"
    CLIENT = "a client"
    SERVER = "a service"
    TIMER = "a timer"
    ARGUMENTS = "a tuple of arguments"
    GROUP = "a callback group"
    PARAMETER_TYPE = "a Parameter.Type"


_INTERFACES = {
    EntityKind.PUBLISHER: Kind.MESSAGE,
    EntityKind.SUBSCRIBER: Kind.MESSAGE,
    EntityKind.SERVICE: Kind.SERVICE,
    EntityKind.CLIENT: Kind.SERVICE,
    EntityKind.ACTION_SERVER: Kind.ACTION,
    EntityKind.ACTION_CLIENT: Kind.ACTION,
}
_SECTIONS = {Kind.MESSAGE: "msg", Kind.SERVICE: "srv", Kind.ACTION: "action"}
_BY_NAME = {
    "timer_period_sec": Kind.SECONDS,
    "frequency": Kind.HERTZ,
    "executor": Kind.EXECUTOR,
}
_JUDGED = ("rclpy.", "message_filters.", "tf2_ros.")
_DESTROYED = {
    "rclpy.node.Node.destroy_publisher": Kind.PUBLISHER,
    "rclpy.node.Node.destroy_subscription": Kind.SUBSCRIPTION,
    "rclpy.node.Node.destroy_client": Kind.CLIENT,
    "rclpy.node.Node.destroy_service": Kind.SERVER,
    "rclpy.node.Node.destroy_timer": Kind.TIMER,
}
_CLASSES = {
    Kind.PUBLISHER: "rclpy.publisher.Publisher",
    Kind.SUBSCRIPTION: "rclpy.subscription.Subscription",
    Kind.CLIENT: "rclpy.client.Client",
    Kind.SERVER: "rclpy.service.Service",
    Kind.TIMER: "rclpy.timer.Timer",
}
_THREADS = {"threading.Thread": "target", "threading.Timer": "function"}
"""What runs a function in a thread of its own, and the parameter that takes it."""
_SPINNING = frozenset(
    {"rclpy.spin", "rclpy.spin_once", "rclpy.spin_until_future_complete", "rclpy.executors.Executor.add_node"}
)
_AS_A_NODE = frozenset({"__getattr__", "__getattribute__", "handle", "subscriptions"})
"""Methods with which a class answers what executors ask a node."""
_GONE_THROUGH = frozenset({"__iter__", "__getitem__", "__getattr__"})
"""Methods with which something can go through an object."""


@once_for
def kinds_of(api: Api) -> Mapping[str, Kind]:
    """What the parameters of an API take, as far as archlint judges it."""
    if api.path in _THREADS:
        return {"args": Kind.ARGUMENTS, _THREADS[api.path]: Kind.CALLBACK}
    if not api.path.startswith(_JUDGED):
        return {}
    if api.path in _DESTROYED:
        return {"entity": _DESTROYED[api.path]}
    if api.path == "rclpy.parameter.Parameter":
        return {"type_": Kind.PARAMETER_TYPE}
    kinds = {name: kind for name, kind in _BY_NAME.items() if name in api.params}
    if api.type is not None and api.kind is not None and not api.type_as_text:
        kinds[api.type] = _INTERFACES[api.kind]
    if api.name is not None:
        kinds[api.name] = Kind.NAME
    if api.qos in ("qos_profile", "qos") and api.kind in (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER):
        kinds[api.qos] = Kind.PROFILE
    if api.group is not None:
        kinds[api.group] = Kind.GROUP
    if api.node is not None or (api.path in _SPINNING):
        kinds[api.node or "node"] = Kind.NODE
    for name, role in api.callbacks:
        if role != Role.TASK:
            kinds[name] = Kind.EXECUTE_CALLBACK if role == Role.EXECUTE else Kind.CALLBACK
    return kinds


def is_other(api: Api, kind: Kind, value: Value, written: facts.Expr | None) -> bool:
    """Whether a value is certainly not what a parameter of this kind takes; ``written`` is the argument as it stands
    in the code."""
    if _is_parameter(value):
        return True
    if value.via:
        return False  # a parameter may have another value where the node runs
    if kind in _SECTIONS:
        return _is_no_interface(value, _SECTIONS[kind])
    if kind in _CLASSES:
        return _is_no_entity(value, _CLASSES[kind])
    if kind is Kind.NODE and api.path in _SPINNING and _is_other_object(value):
        return True
    return _IS_OTHER[kind](value, written)


def _is_other_object(value: Value) -> bool:
    """Whether a value is a class, or an object of a class that is no node and does not pass itself off as one."""
    match value:
        case ClassValue():
            return node_classes.has_only(value)
        case Instance(cls=ClassValue() as cls):
            return node_classes.has_only(cls) and not node_classes.is_node(cls) and not _passes_as_node(cls)
    return False


def _passes_as_node(cls: ClassValue) -> bool:
    """Whether a class, or its decorator, may answer what executors ask a node."""
    return any(base.ir.decorators for base in cls.classes) or _defines(cls, _AS_A_NODE)


def _defines(cls: ClassValue, methods: frozenset[str]) -> bool:
    """Whether a class, or one that it derives from, has one of some methods."""
    defined = (item for base in cls.classes for item in base.ir.body)
    return any(isinstance(item, facts.Function) and item.name in methods for item in defined)


def _is_parameter(value: Value) -> bool:
    """Whether it is what ``get_parameter()`` gives: the value is in it."""
    match value:
        case Instance(cls=External(path="rclpy.parameter.Parameter")):
            return True
    return False


def _is_no_interface(value: Value, section: str) -> bool:
    match value:
        case Known(value=constant):
            return constant is not None
        case Builtin(name=name, self_value=None):
            return name in _PYTHON_TYPES
        case ClassValue():
            return node_classes.has_only(value)
        case Instance(cls=External(path=path)):
            return names.canonical(path) == PROFILE
        case External(path=path):
            interface, part = names.interface_and_section(names.canonical(path))
            if interface is None:
                return names.canonical(path) in names.NODE_CLASSES or names.canonical(path) == PROFILE
            if section == "msg" and (part or names.is_part_of_interface(interface)):
                return False  # what a service or an action is made of are messages, too
            if section == "srv" and interface.endswith(("_SendGoal", "_GetResult")):
                return False  # and services, of an action
            return bool(part) or interface.split("/")[1] != section
    return _is_function(value) or isinstance(value, NodeValue)


def _is_no_text(value: Value, written: facts.Expr | None) -> bool:
    match value:
        case Known():
            return not (value.is_none or value.is_text)
    return _is_class(value) or _is_function(value) or isinstance(value, (MessageValue, NodeValue))


def _is_no_profile(value: Value, written: facts.Expr | None) -> bool:
    match value:
        case Known(value=int(depth)):
            return depth < 0
        case Known(value=None):
            return isinstance(written, facts.Literal)
        case Known():
            return True
    return _is_class(value) or _is_function(value)


def _is_no_callback(value: Value, written: facts.Expr | None) -> bool:
    match value:
        case Known(value=None):
            return isinstance(written, facts.Call)  # called, where it should be passed
        case Known():
            return True
    return isinstance(value, (MessageValue, EntityValue, NodeValue))


def _is_no_execute_callback(value: Value, written: facts.Expr | None) -> bool:
    match value:
        case Known(value=None):
            return isinstance(written, (facts.Literal, facts.Call))
    return _is_no_callback(value, written)


def _is_no_node(value: Value, written: facts.Expr | None) -> bool:
    return _is_constant(value) or _is_interface(value) or _is_function(value) or isinstance(value, MessageValue)


def _is_no_number(value: Value, written: facts.Expr | None) -> bool:
    match value:
        case Known(value=str(text)):
            return not _is_number(text)
    return _is_class(value) or _is_function(value) or isinstance(value, MessageValue)


def _is_no_entity(value: Value, path: str) -> bool:
    """Whether it is another endpoint than those of a class, or none."""
    match value:
        case EntityValue(path=own):
            return own != path and own in _CLASSES.values()
        case Known(value=str()):
            return True
    return _is_function(value) or isinstance(value, NodeValue)


def _is_no_tuple(value: Value, written: facts.Expr | None) -> bool:
    """Whether nothing can go through it: ``args=(node)`` is the node itself."""
    match value:
        case Known(value=bool() | int() | float()) | Unknown(of_class="int" | "float"):
            return True
        case Instance(cls=ClassValue() as cls):
            return node_classes.is_node(cls) and node_classes.has_only(cls) and not _defines(cls, _GONE_THROUGH)
    return _is_function(value) or isinstance(value, (EntityValue, MessageValue, NodeValue))


def _is_no_group(value: Value, written: facts.Expr | None) -> bool:
    """Whether it is the class of a group that is not called, a number, a text, a function or an endpoint."""
    match value:
        case External(path=path):
            return names.canonical(path).startswith("rclpy.callback_groups.")
        case Known(value=constant):
            return constant is not None
    return _is_function(value) or isinstance(value, (EntityValue, MessageValue, NodeValue))


_PYTHON_TYPES = frozenset({"str", "int", "float", "bool", "bytes", "list", "dict", "tuple", "set"})
"""Classes of Python that students give where a message class is wanted: ``create_publisher(str, ...)``."""


def _is_no_parameter_type(value: Value, written: facts.Expr | None) -> bool:
    """Source: ``Parameter.__init__`` of rclpy/parameter.py, in all distributions."""
    return _is_constant(value) or isinstance(value, (DictValue, ListValue))


_IS_OTHER: Mapping[Kind, Callable[[Value, facts.Expr | None], bool]] = {
    Kind.NAME: _is_no_text,
    Kind.PROFILE: _is_no_profile,
    Kind.CALLBACK: _is_no_callback,
    Kind.EXECUTE_CALLBACK: _is_no_execute_callback,
    Kind.NODE: _is_no_node,
    Kind.SECONDS: _is_no_number,
    Kind.HERTZ: _is_no_number,
    Kind.EXECUTOR: _is_no_node,
    Kind.ARGUMENTS: _is_no_tuple,
    Kind.GROUP: _is_no_group,
    Kind.PARAMETER_TYPE: _is_no_parameter_type,
}


def _is_constant(value: Value) -> bool:
    match value:
        case Known(value=constant):
            return constant is not None
        case Unknown(of_class="int" | "float" | "str"):
            return True
    return False


def _is_interface(value: Value) -> bool:
    return isinstance(value, External) and names.interface_and_section(names.canonical(value.path))[0] is not None


def _is_class(value: Value) -> bool:
    return _is_interface(value) or (isinstance(value, ClassValue) and node_classes.has_only(value))


def _is_function(value: Value) -> bool:
    match value:
        case FunctionValue() | BoundMethod(function=FunctionValue()):
            return True
    return False


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def described(value: Value, written: facts.Expr | None) -> str:
    """A value in the words of a message."""
    match value:
        case Known(value=str(text)):
            return f"the text '{text if len(text) <= 40 else text[:39] + '…'}'"
        case Known(value=None) if isinstance(written, facts.Call) and written.func.last_name:
            return f"what {written.func.last_name}() returns: None"
        case Known(value=bool() | None as constant):
            return str(constant)
        case Known(value=int() | float() as number):
            return f"the number {number}"
        case Instance(cls=External(path="rclpy.parameter.Parameter")):
            return "a Parameter without .value"
        case Instance(cls=External(path=path)) if names.canonical(path) == PROFILE:
            return "a QoSProfile"
        case External(path=path):
            return _class_in_words(path)
        case ClassValue(qualified=name):
            return f"the class {name}"
        case Builtin(name=name):
            return f"Python's {name}"
        case BoundMethod(function=FunctionValue(qualified=name)):
            return f"the method {name.rpartition('.')[2]}"
        case FunctionValue(ir=facts.Lambda()):
            return "a lambda"
        case FunctionValue(qualified=name):
            return f"the function {name.rpartition('.')[2]}"
        case MessageValue(type=type_, section_name=part):
            name = type_.rpartition("/")[2]
            return f"a message of class {name}.{part}" if part else f"a message of class {name}"
        case EntityValue(path=path):
            return f"a {path.rpartition('.')[2].lower()}"
        case NodeValue():
            return "a node"
        case ListValue(kind=("list" | "tuple") as kind):
            return f"a {kind}"
        case Unknown(of_class="str"):
            return "a text"
        case Unknown(of_class="int" | "float"):
            return "a number"
        case Instance(cls=ClassValue(qualified=name)):
            return f"an object of class {name}"
    return "something else"


def _class_in_words(path: str) -> str:
    interface, part = names.interface_and_section(names.canonical(path))
    name = (interface or path.replace(".", "/")).rpartition("/")[2]
    whole = interface is not None and not part and not names.is_part_of_interface(interface)
    if interface is not None and whole and interface.split("/")[1] == "action":
        return f"the action {name}"
    return f"the class {name}.{part}" if part else f"the class {name}"


__all__ = ["Kind", "described", "is_other", "kinds_of"]
