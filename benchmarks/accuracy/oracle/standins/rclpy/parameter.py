"""Stand-in for rclpy.parameter."""

from __future__ import annotations

from enum import Enum
from pathlib import Path
from typing import Any

import yaml
from benchmarks.accuracy.oracle.interfaces import interface
from benchmarks.accuracy.oracle.unknown import Unknown

PARAMETER_SEPARATOR_STRING = "."

_FIELDS = (
    "",
    "bool_value",
    "integer_value",
    "double_value",
    "string_value",
    "byte_array_value",
    "bool_array_value",
    "integer_array_value",
    "double_array_value",
    "string_array_value",
)


class Parameter:
    """A parameter: a name, a type and a value."""

    class Type(Enum):
        """The types of rcl_interfaces/msg/ParameterType."""

        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, value: Any) -> Parameter.Type:
            """The type that a Python value has as a parameter."""
            return _type_of(value)

        def check(self, value: Any) -> bool:
            """Whether a value is of this type."""
            kinds = Parameter.Type
            if self is kinds.NOT_SET:
                return value is None
            if self in _PYTHON:
                return isinstance(value, _PYTHON[self])
            allowed: Any = bytes if self is kinds.BYTE_ARRAY else _PYTHON[kinds(self.value - 5)]
            return hasattr(value, "__iter__") and all(isinstance(item, (allowed, Unknown)) for item in value)

    def __init__(self, name: str, type_: Any = None, value: Any = None) -> None:
        if type_ is not None and not isinstance(type_, (Parameter.Type, Unknown)):
            raise TypeError(f"type must be an instance of {Parameter.Type!r}")
        if isinstance(type_, Parameter.Type) and not isinstance(value, Unknown) and not type_.check(value):
            raise ValueError(f"Type {type_!r} and value {value!r} do not agree")
        self._name = name
        self._value = value
        self._type = type_ if isinstance(type_, Parameter.Type) else _type_of(value)

    @property
    def name(self) -> str:
        """The name."""
        return self._name

    @property
    def type_(self) -> Any:
        """The type."""
        return self._type

    type = type_

    @property
    def value(self) -> Any:
        """The value as Python has it."""
        return self._value

    def get_parameter_value(self) -> Any:
        """As rcl_interfaces/msg/ParameterValue: one field holds the value, the others are empty."""
        empty: tuple[Any, ...] = (None, False, 0, 0.0, "", [], [], [], [], [])
        fields = {name: empty[index] for index, name in enumerate(_FIELDS) if name}
        if isinstance(self._value, Unknown):
            fields = dict.fromkeys(fields, self._value)
        elif self._type.value:
            fields[_FIELDS[self._type.value]] = self._value
        return interface("rcl_interfaces", "msg", "ParameterValue")(type=self._type.value, **fields)

    def to_parameter_msg(self) -> Any:
        """As rcl_interfaces/msg/Parameter."""
        return interface("rcl_interfaces", "msg", "Parameter")(name=self._name, value=self.get_parameter_value())

    @classmethod
    def from_parameter_msg(cls, msg: Any) -> Parameter:
        """From rcl_interfaces/msg/Parameter."""
        return cls(msg.name, value=parameter_value_to_python(msg.value))


_PYTHON = {
    Parameter.Type.BOOL: bool,
    Parameter.Type.INTEGER: int,
    Parameter.Type.DOUBLE: float,
    Parameter.Type.STRING: str,
}


def _type_of(value: Any) -> Parameter.Type:
    kinds = Parameter.Type
    if value is None or isinstance(value, Unknown):
        return kinds.NOT_SET
    scalars: tuple[tuple[type, Parameter.Type], ...] = (
        (bool, kinds.BOOL),
        (int, kinds.INTEGER),
        (float, kinds.DOUBLE),
        (str, kinds.STRING),
    )
    for python, kind in scalars:
        if isinstance(value, python):
            return kind
    if hasattr(value, "typecode"):
        return kinds.DOUBLE_ARRAY if value.typecode in "fd" else kinds.INTEGER_ARRAY
    if isinstance(value, (list, tuple)):
        if all(isinstance(item, bytes) for item in value):
            return kinds.BYTE_ARRAY
        for python, kind in scalars:
            if all(isinstance(item, (python, Unknown)) for item in value):
                return kinds(kind.value + 5)
    raise TypeError(f"The given value is not one of the allowed types '{value!r}'.")


def parameter_value_to_python(value: Any) -> Any:
    """The Python value of a rcl_interfaces/msg/ParameterValue."""
    kind = value.type
    return getattr(value, _FIELDS[kind]) if isinstance(kind, int) and 0 < kind < len(_FIELDS) else None


def get_parameter_value(string_value: str) -> Any:
    """A rcl_interfaces/msg/ParameterValue from text, read as YAML."""
    return Parameter("value", value=yaml.safe_load(string_value)).get_parameter_value()


def parameter_dict_from_yaml_file(parameter_file: str, *_: object, **__: object) -> dict[str, Any]:
    """The parameters of a file, as messages by name."""
    content = yaml.safe_load(Path(parameter_file).read_text(encoding="utf-8")) or {}
    found: dict[str, Any] = {}
    for node in content.values():
        for name, value in _flat(node.get("ros__parameters", {})):
            found[name] = Parameter(name, value=value).to_parameter_msg()
    return found


def _flat(values: dict[str, Any], prefix: str = "") -> list[tuple[str, Any]]:
    flat: list[tuple[str, Any]] = []
    for name, value in values.items():
        flat.extend(_flat(value, f"{prefix}{name}.") if isinstance(value, dict) else [(prefix + name, value)])
    return flat
