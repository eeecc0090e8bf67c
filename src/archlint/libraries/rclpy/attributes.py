"""Attributes of what rclpy makes, and of what classes of ours have from its classes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    ApiMethod,
    External,
    ForeignValue,
    Instance,
    Known,
    PythonValue,
    Unknown,
    Value,
)
from archlint.libraries.rclpy import clocks, executors, messages, names
from archlint.libraries.values import EntityValue, ExecutorValue, FutureValue, MessageValue, NodeValue

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def of_value(run: Run, value: ForeignValue, name: str) -> Value:
    """``value.name`` of a node, an entity, an executor, a future or a message."""
    match value:
        case ExecutorValue(path=path):
            return ApiMethod(f"{path}.{name}", value)
        case FutureValue():
            return ApiMethod(f"rclpy.task.Future.{name}", value)
    key = value.heap_key
    stored = run.store.get(key, name) if key else None
    if stored is not None:
        return stored
    match value:
        case NodeValue():
            return _of_node(run, value, name)
        case EntityValue():
            return _of_entity(value, name)
        case MessageValue():
            return _of_message(run, value, name)
    raise TypeError(f"a value of rclpy that nobody knows: {value!r}")


def of_unknown(value: Value, name: str) -> Value | None:
    """A method that only a node has: something of which nothing is known is one; and what a clock is asked."""
    known = clocks.of_clock_or_time(value, name) if isinstance(value, Unknown) else None
    if known is not None:
        return known
    return ApiMethod(f"{names.NODE}.{name}", value) if name in names.NODE_METHODS else None


def mixed_in(value: Instance, name: str) -> Value | None:
    """``self.create_timer(…)`` in a class that is no node: another class derives from it and from Node."""
    return of_unknown(value, name) if name.startswith("create_") else None


def inherited(run: Run, value: Value, base: str, name: str) -> Value:
    """An attribute that a foreign base class gives an object of ours."""
    if base in names.NODE_CLASSES:
        special = _node_attribute(run, value, name)
        return special or ApiMethod(names.method(base, name), value)
    if name in names.NODE_METHODS and not names.is_api_class(base) and not names.is_of_other_system(base):
        return ApiMethod(f"{names.NODE}.{name}", value)
    return ApiMethod(f"{base}.{name}", value)


def _node_attribute(run: Run, value: Value, name: str) -> Value | None:
    """Attributes of every node that are values rather than methods."""
    if name == "default_callback_group":
        return External("rclpy.node.Node.default_callback_group")
    if name == "executor":
        use = executors.running(run, run.nodes.by_object.get(value.heap_key or 0))
        if use is not None:
            return ExecutorValue(use, "rclpy.executors.Executor", run.store.new_key())
        return Unknown("the executor is set when the node is spun")
    return None


def of_object(run: Run, value: Instance, path: str, name: str) -> Value:
    """``value.name`` of an object of a class of rclpy's."""
    stored = run.store.get(value.key, "value")
    if path == "rclpy.parameter.Parameter" and name in ("value", "get_parameter_value"):
        answer = stored if stored is not None else Unknown("the parameter has no value here")
        if name == "value":
            return answer
        return PythonValue("get_parameter_value", lambda *_, **__: _parameter_value(run, answer))
    if path in names.PARAMETER_VALUES:
        if stored is not None and name.endswith("_value"):
            return stored
        if name == "type":
            if isinstance(stored, Known) and type(stored.value) in _PARAMETER_TYPES:
                # A declared parameter keeps its type, whatever is set.
                return Known(_PARAMETER_TYPES[type(stored.value)])
            return Unknown("the type of a parameter")
    return ApiMethod(f"{path}.{name}", value)


_PARAMETER_TYPES: dict[type, int] = {bool: 1, int: 2, float: 3, str: 4}
"""The constants of ``rcl_interfaces/msg/ParameterType``."""


def _parameter_value(run: Run, value: Value) -> Value:
    """A ``rcl_interfaces/msg/ParameterValue`` that holds a value: ``.string_value`` and the like read it."""
    instance = Instance(External("rcl_interfaces.msg.ParameterValue"), run.store.new_key())
    run.store.set(instance.key, "value", value)
    return instance


def interface_constant(run: Run, path: str, name: str) -> Value | None:
    """A constant of a ``.msg``, ``.srv`` or ``.action`` file, or the name of the class made from it."""
    if run.interfaces is None:
        return None
    interface, section_name = names.interface_and_section(path)
    if interface is None:
        return None
    if name == "__name__" and not section_name:
        return Known(interface.rpartition("/")[2])
    value = run.interfaces.constant(interface, section_name, name)
    return None if value is None else Known(value)


def _of_node(run: Run, value: NodeValue, name: str) -> Value:
    special = _node_attribute(run, value, name)
    if special is not None:
        return special
    return ApiMethod(names.method(names.LIFECYCLE_NODE if value.blueprint.lifecycle else names.NODE, name), value)


_NAME_ATTRIBUTES = {"topic", "topic_name", "srv_name", "service_name", "_action_name", "_topic", "_srv_name"}


def _of_entity(value: EntityValue, name: str) -> Value:
    if name in _NAME_ATTRIBUTES and len(value.creations) == 1:
        text = value.creations[0].name
        if text.resolution == "exact" and text.text is not None and text.text.startswith("/"):
            return Known(text.text)
        return Unknown("the full name of an endpoint depends on its node")
    return ApiMethod(f"{value.path}.{name}", value)


def _of_message(run: Run, value: MessageValue, name: str) -> Value:
    if run.interfaces is not None:
        constant = run.interfaces.constant(value.type, value.section_name, name)
        if constant is not None:
            return Known(constant)
    return messages.content(run, value, name)


__all__ = ["inherited", "interface_constant", "mixed_in", "of_object", "of_unknown", "of_value"]
