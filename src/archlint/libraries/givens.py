"""From the values of a run to what a program says of them: plain data, which outlives the run."""

from __future__ import annotations

from archlint.interpreter.values import (
    ClassValue,
    DictValue,
    EachValue,
    External,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
)
from archlint.libraries.values import EntityValue, ExecutorValue, FutureValue, MessageValue, NodeValue
from archlint.model import given

_DURATION = "rclpy.duration.Duration"
_GOAL_HANDLE = "rclpy.action.server.ServerGoalHandle"


def given_by(value: Value, process: given.Process) -> given.Given:
    """What a program says of a value that one of its calls is given."""
    match value:
        case Known():
            return given.Constant(value.value, value.via, value.origin, value.kind)
        case OneOf():
            return given.OneOf(tuple(given_by(option, process) for option in value.values))
        case EntityValue():
            return given.Entity(value.creations)
        case FutureValue():
            return given.Future(value.creations, value.api)
        case Instance():
            return _object(value, process)
        case MessageValue():
            return given.Message(value.type, value.section_name)
        case NodeValue():
            return given.Node(value.blueprint)
        case ExecutorValue():
            return given.Executor(value.use)
        case External():
            return given.ForeignClass(value.path)
        case ListValue():
            return given.Collection(value.kind)
        case EachValue():
            return given.Collection("list")
        case DictValue():
            return given.Collection("dict")
        case Unknown(of_class="bool" | "float" | "int" | "str" as name) if not value.via:
            return given.PlainValue(name)
        case _:
            return given.UNKNOWN


def _object(value: Instance, process: given.Process) -> given.Given:
    if isinstance(value.cls, ClassValue):
        return given.Object(value.key, None, value.place, process)
    if value.cls.path == _DURATION:
        return given.Duration(_seconds(value))
    if value.cls.path == _GOAL_HANDLE:
        goal = value.arguments.get("request")
        return given.GoalHandle(goal.type if isinstance(goal, MessageValue) else None)
    return given.Object(value.key, value.cls.path, value.place, process)


def _seconds(duration: Instance) -> float | None:
    """``Duration(seconds=1, nanoseconds=500)`` in seconds."""
    total = 0.0
    for name, scale in (("seconds", 1.0), ("nanoseconds", 1e-9)):
        part = duration.arguments.get(name)
        if part is None:
            continue
        if not isinstance(part, Known) or not isinstance(part.value, (int, float)):
            return None
        total += part.value * scale
    return total


__all__ = ["given_by"]
