"""What the code asks rclpy's times, durations, parameters and goal handles for, and they do not have."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_few_files
from archlint.analysis.own_names import is_defined_somewhere
from archlint.libraries.api_signatures import attributes_of
from archlint.place import Place
from archlint.python_code.absent_members import AbsentMember
from archlint.python_code.class_chains import targets_of
from archlint.python_code.rclpy_objects import Kind, Objects, Variables, objects_of
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import System

_CLASSES: Mapping[Kind, str] = {
    Kind.TIME: "rclpy.time.Time",
    Kind.DURATION: "rclpy.duration.Duration",
    Kind.PARAMETER: "rclpy.parameter.Parameter",
    Kind.GOAL: "rclpy.action.server.ServerGoalHandle",
}
_VALUE_FIELDS = frozenset(
    {"bool_array_value", "bool_value", "byte_array_value", "double_array_value", "double_value", "integer_array_value"}
    | {"integer_value", "string_array_value", "string_value", "type", "SLOT_TYPES", "get_fields_and_field_types"}
)
_PROPERTIES: Mapping[Kind, frozenset[str]] = {
    Kind.TIME: frozenset({"clock_type", "nanoseconds"}),
    Kind.DURATION: frozenset({"nanoseconds"}),
    Kind.PARAMETER: frozenset({"name", "type_", "value"}),
    Kind.GOAL: frozenset({"goal_id", "is_active", "is_cancel_requested", "request", "status"}),
}
"""What is read without parentheses, and no function."""
_IN_SECONDS = "nanoseconds / 1e9"
_INSTEAD: Mapping[tuple[Kind, str], str] = {
    **{
        (kind, name): _IN_SECONDS for kind in (Kind.TIME, Kind.DURATION) for name in ("to_sec", "seconds", "to_seconds")
    },
    **{(kind, "to_nsec"): "nanoseconds" for kind in (Kind.TIME, Kind.DURATION)},
    **{(kind, name): f"to_msg().{name}" for kind in (Kind.TIME, Kind.DURATION) for name in ("sec", "nanosec")},
    **{(kind, "secs"): "to_msg().sec" for kind in (Kind.TIME, Kind.DURATION)},
    **{(kind, "nsecs"): "to_msg().nanosec" for kind in (Kind.TIME, Kind.DURATION)},
    (Kind.TIME, "now"): "get_clock().now() of a node",
    (Kind.PARAMETER, "get_value"): "value",
    (Kind.VALUE, "float_value"): "double_value",
    (Kind.VALUE, "int_value"): "integer_value",
    (Kind.VALUE, "str_value"): "string_value",
    (Kind.VALUE, "boolean_value"): "bool_value",
    **{(Kind.GOAL, name): "abort" for name in ("set_aborted", "aborted")},
    **{(Kind.GOAL, name): "succeed" for name in ("set_succeeded", "succeeded")},
    **{(Kind.GOAL, name): "canceled" for name in ("set_canceled", "cancel", "cancelled")},
}
"""What people expect, much of it from ROS 1, and what there is."""


@dataclass(frozen=True)
class CalledProperty:
    """``now.nanoseconds()``: ``owner`` has ``name`` as a value."""

    place: Place
    owner: str
    name: str
    cure: str = ""
    """What to write, where it is not the name alone."""


def object_members(system: System) -> Iterator[AbsentMember | CalledProperty]:
    """Every such use in the Python files that were asked for, outside of test code."""
    workspace = system.workspace
    if workspace is None:
        return
    for path in workspace.python_files(mentioning="rclpy"):
        for row in _of_file(workspace, path):
            by_parameter = row.kind in (Kind.PARAMETER, Kind.VALUE)
            if by_parameter and is_defined_somewhere(system, path, "get_parameter"):
                continue
            place, owner = Place(path, *row.part.span), _owner(row.kind)
            if row.called:
                yield CalledProperty(place, owner, row.part.attr)
            else:
                yield AbsentMember(place, owner, row.part.attr, _near(row), False)


def _owner(kind: Kind) -> str:
    return "ParameterValue" if kind == Kind.VALUE else _CLASSES[kind].rpartition(".")[2]


@dataclass(frozen=True)
class _Row:
    kind: Kind
    part: facts.Attribute
    called: bool = False


def _near(row: _Row) -> str:
    known = _known(row.kind)
    return _INSTEAD.get((row.kind, row.part.attr)) or nearest(row.part.attr, sorted(known)) or ""


def _known(kind: Kind) -> frozenset[str]:
    names = _VALUE_FIELDS if kind == Kind.VALUE else attributes_of(_CLASSES[kind]) or frozenset()
    return frozenset(name for name in names if not name.startswith("_"))


@kept_for_few_files
def _of_file(file_facts: facts.Facts) -> list[_Row]:
    code = objects_of(file_facts)
    tried = code.tried | tried_for(file_facts.body, ("AttributeError",))
    rows = (
        row
        for function in everything_in(file_facts.body, facts.Function)
        for part in parts_of(function.body)
        if Itself(part) not in tried and (row := _of_part(code, code.scope(function), part)) is not None
    )
    given = {target.dotted for target in targets_of(file_facts.body)}
    return [row for row in rows if row.called or row.part.dotted not in given or not row.part.dotted]


def _of_part(code: Objects, scope: Variables, part: facts.Base) -> _Row | None:
    match part:
        case facts.Call(func=facts.Attribute(value=value, attr=name) as func):
            kind = scope.kind(value)
            if kind is not None and name in _PROPERTIES.get(kind, ()):
                return _Row(kind, func, called=True)
        case facts.Attribute(value=value, attr=name) if not name.startswith("_"):
            kind = code.classes.get(value.dotted) or scope.kind(value)
            if kind is not None and (kind in _CLASSES or kind == Kind.VALUE) and name not in _known(kind):
                return _Row(kind, part)
    return None


__all__ = ["CalledProperty", "object_members"]
