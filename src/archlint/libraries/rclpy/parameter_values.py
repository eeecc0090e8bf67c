"""Values of parameters: from Python, from a Parameter, and the ROS type of each."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    External,
    Given,
    Holed,
    Instance,
    Known,
    ListValue,
    OneOf,
    Unknown,
    Value,
    one_of,
)
from archlint.libraries.rclpy import policies
from archlint.model.overrides import SHORT
from archlint.ros.parameter_types import OF_PYTHON, ParameterType, array_of
from archlint.syntax.parameter_files import NotKnown

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.model import Look

_PARAMETER = External("rclpy.parameter.Parameter")

_TYPE_NAMES: dict[str, ParameterType] = {
    "BOOL": "bool",
    "INTEGER": "integer",
    "DOUBLE": "double",
    "STRING": "string",
    "BYTE_ARRAY": "byte_array",
    "BOOL_ARRAY": "bool_array",
    "INTEGER_ARRAY": "integer_array",
    "DOUBLE_ARRAY": "double_array",
    "STRING_ARRAY": "string_array",
}


def new_parameter(run: Run, name: Value, value: Value) -> Instance:
    parameter = Instance(_PARAMETER, run.store.new_key())
    run.store.set(parameter.key, "name", name)
    run.store.set(parameter.key, "value", value)
    return parameter


def make_parameter(run: Run, call: ApiUse) -> Value:
    """``Parameter('name', Parameter.Type.STRING, 'value')``."""
    return new_parameter(run, call.get("name") or Unknown("no name"), call.get("value") or NONE)


def type_name(run: Run, value: Value | None) -> ParameterType | None:
    """The ROS type of a default, or of a ``Parameter.Type``."""
    match value:
        case Known(value=constant):
            return OF_PYTHON.get(type(constant))
        case External(path=path) if policies.policy_number(path) is not None:
            return "integer"
        case External(path=path) if ".Type." in path:
            return _TYPE_NAMES.get(path.rpartition(".")[2])
        case ListValue():
            items = value.items(run)
            return None if items.open else array_of({type_name(run, item) for item in items.values})
        case Unknown(of_class=str(number)):
            return _OF_NUMBERS.get(number)
    return None


_OF_NUMBERS: dict[str, ParameterType] = {"float": "double", "int": "integer"}
"""The types of numbers of which only the class is known."""


def is_type(value: Value | None) -> bool:
    return value is not None and (".Type." in value.dotted or ".ParameterType." in value.dotted)


def from_parameter(run: Run, value: Value, name: str) -> Value:
    """A default as the value of a parameter: known, but by way of the parameter."""
    match value:
        case External(path=path) if (number := policies.policy_number(path)) is not None:
            return Known(number, frozenset({name}))
        case Known():
            return value.chosen_by(frozenset({name}))
        case Holed():
            return Holed(value.parts, value.reason, value.via | {name}, value.origin)
        case ListValue():
            items = value.items(run)
            # An empty default waits for somebody to fill it, unless a launch file is seen to leave it so.
            open_ = items.open or not (items.values or run.overrides.are_settled(frozenset({name})))
            filled = [from_parameter(run, item, name) for item in items.values]
            return containers.new_list(run, filled, value.kind, open_)
        case Unknown(reason=why):
            return Unknown(f"the parameter '{name}' has a default that is not known: {why}", name)
        case OneOf(values=options):
            return one_of(from_parameter(run, option, name) for option in options)
    return Unknown(f"it depends on the parameter '{name}'", name)


def value_from_python(run: Run, value: object, look: Look, at: tuple[int, ...] = ()) -> Value:
    """A value of a parameter file or launch file; ``look`` is called when the program does something that depends on
    a constant of it."""
    why = "not known here"
    match value:
        case list() | tuple():
            rows = enumerate(value)
            return containers.new_list(run, [value_from_python(run, row, look, (*at, n)) for n, row in rows])
        case str() | int() | float():
            return Given(value, look=look, source=(look, at), longest=SHORT)
        case NotKnown(reason=why):
            pass
    return Unknown(f"it is set to an unknown value: {why}")


def to_python(run: Run, value: Value | None) -> tuple[object, bool]:
    """The Python value of a constant, and whether it is known."""
    match value:
        case Known(value=constant):
            return constant, True
        case ListValue():
            items = value.items(run)
            rows = [to_python(run, item) for item in items.values]
            if not items.open and all(known for _, known in rows):
                return [item for item, _ in rows], True
    return None, False
