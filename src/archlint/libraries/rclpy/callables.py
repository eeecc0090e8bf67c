"""What a callable runs in the end, and what it is for people."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.values import (
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    External,
    FunctionValue,
    Instance,
    Partial,
    Unknown,
    Value,
)
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.rclpy import node_classes
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def without_partials(value: Value) -> tuple[Value, list[Value]]:
    """A callable without its partials, and what these give it."""
    given: list[Value] = []
    while isinstance(value, Partial):
        given += [*value.args, *(argument for _, argument in value.keywords)]
        value = value.function
    return value, given


def describe(run: Run, value: Value, role: model.Role) -> model.Callback:
    """What a callable is, for people: its name and where it is defined."""
    here = run.place((1, 1, 1, 1))
    match value:
        case FunctionValue(ir=ir, qualified=qualified):
            place = Place(value.scope.module.path, *ir.name_span)
            code = model.FunctionRef(qualified, place, isinstance(ir, facts.Lambda))
            callback = model.Callback(role, qualified, place, code, is_async=ir.is_async, file=place.file)
            callback.docstring = ir.docstring if isinstance(ir, facts.Function) else ""
        case BoundMethod(function=function):
            callback = describe(run, function, role)
            callback.bound_arguments += 1
        case Partial(function=function):
            callback = describe(run, function, role)
            callback.bound_arguments += len(value.args)
            callback.bound_keywords |= {name for name, _ in value.keywords}
        case Instance(cls=ClassValue(qualified=qualified)):
            method = get_attribute(run, value, "__call__")
            bound = isinstance(method, BoundMethod)
            callback = describe(run, method, role) if bound else model.Callback(role, qualified, here, None)
        case ApiMethod(path=name) | External(path=name) | Builtin(name=name):
            callback = model.Callback(role, name, here, None)
            callback.missing = _missing_method(value)
        case Unknown():
            callback = model.Callback(role, "?", here, None)
            callback.missing = value.missing
        case _:
            callback = model.Callback(role, "?", here, None)
    return callback


def function_of(run: Run, value: Value) -> FunctionValue | None:
    """The function that a callable runs in the end, whatever is bound to it."""
    match callee := value.callee:
        case FunctionValue():
            return callee
        case Instance(cls=ClassValue()):
            method = get_attribute(run, callee, "__call__")
            return function_of(run, method) if isinstance(method, BoundMethod) else None
    return None


def _missing_method(value: Value) -> str | None:
    """The name of a method that a node of ours is asked for and that neither its class nor rclpy's has."""
    match value:
        case ApiMethod(path=path, self_value=Instance(cls=ClassValue() as cls)):
            base, _, name = path.rpartition(".")
        case _:
            return None
    if base not in rclpy_names.NODE_CLASSES or (name.startswith("__") and name.endswith("__")):
        return None
    public = rclpy_names.is_node_attribute(name) and not name.startswith(("on_", "__"))
    of_rclpy = public or name in rclpy_names.PRIVATE_NODE_METHODS
    if node_classes.is_lifecycle(cls):
        of_rclpy = of_rclpy or name in rclpy_names.LIFECYCLE_METHODS
    return None if of_rclpy or not node_classes.has_only(cls) else name
