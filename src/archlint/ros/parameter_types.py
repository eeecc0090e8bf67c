"""The types of parameters: those of ``rcl_interfaces/msg/ParameterType``, by the names that ``ros2 param`` prints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, Literal

ParameterType = Literal[
    "bool",
    "integer",
    "double",
    "string",
    "byte_array",
    "bool_array",
    "integer_array",
    "double_array",
    "string_array",
]

OF_PYTHON: Final[Mapping[type, ParameterType]] = {bool: "bool", int: "integer", float: "double", str: "string"}
"""What rclpy makes of a value of a class."""
OF_PARAMETER_LIBRARY: Final[Mapping[ParameterType, str]] = {
    "bool": "bool",
    "integer": "int",
    "double": "double",
    "string": "string",
    "bool_array": "bool_array",
    "integer_array": "int_array",
    "double_array": "double_array",
    "string_array": "string_array",
}
"""The types of ``generate_parameter_library``, which has no byte arrays."""
_ARRAYS: Final[Mapping[ParameterType | None, ParameterType]] = {
    "bool": "bool_array",
    "integer": "integer_array",
    "double": "double_array",
    "string": "string_array",
}


def array_of(types: set[ParameterType | None]) -> ParameterType | None:
    """The type of a list with items of ``types``; None where they are several, not known, or lists."""
    return _ARRAYS.get(next(iter(types))) if len(types) == 1 else None


def type_of(value: object) -> ParameterType | None:
    """The type of a value; None where that is not known, as of an empty list."""
    match value:
        case list() | tuple():
            return array_of({OF_PYTHON.get(type(item)) for item in value})
    return OF_PYTHON.get(type(value))
