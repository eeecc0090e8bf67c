"""The parameters of a stand-in node: declared defaults and constructor overrides, nothing from outside."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle import unknown
from benchmarks.accuracy.oracle.interfaces import Interface, interface
from benchmarks.accuracy.oracle.record import recorder
from benchmarks.accuracy.oracle.unknown import Unknown

from .exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)
from .parameter import Parameter

_KINDS = Parameter.Type
OF_EVERY_NODE = {"use_sim_time": False, "start_type_description_service": True}
"""What rclpy declares for every node."""


class ParameterStore:
    """The parameter half of a node."""

    def _start_parameters(self, overrides: Any, allow_undeclared: bool, declare_overrides: bool) -> None:
        self._oracle_values: dict[str, Parameter] = {}
        self._parameters = self._oracle_values  # some nodes look into it
        self._oracle_descriptors: dict[str, Any] = {}
        self._oracle_kinds: dict[str, Any] = {}
        self._oracle_parameter_callbacks: list[Any] = []
        self._oracle_allow_undeclared = bool(allow_undeclared)
        self._oracle_overrides = {each.name: each for each in overrides or () if hasattr(each, "name")}
        for name, value in OF_EVERY_NODE.items():
            self._oracle_declare(name, value, None, False)
        if declare_overrides:
            self._oracle_values.update(self._oracle_overrides)

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare one parameter."""
        bare = value is None and descriptor is None
        return self.declare_parameters("", [(name,) if bare else (name, value, descriptor)], ignore_override)[0]

    def declare_parameters(self, namespace: str, parameters: Any, ignore_override: bool = False) -> list[Parameter]:
        """Declare several: (name[, value[, descriptor]]) each."""
        declared = []
        for name, *rest in parameters:
            if len(rest) > 2:
                raise TypeError("Invalid parameter tuple length; expecting length between 1 and 3")
            full = f"{namespace}.{name}" if namespace else name
            bare = not rest and _descriptor(dynamic_typing=True)
            value, descriptor = [*rest, None, None][:2]
            declared.append(self._oracle_declare(full, value, bare or descriptor, ignore_override))
        for each in declared:
            recorder.parameter(self, each.name, each.type_.name, each.value)
        return declared

    def _oracle_declare(self, name: Any, value: Any, descriptor: Any, ignore_override: bool) -> Parameter:
        descriptor = _checked(name, descriptor)
        if name in self._oracle_values:
            raise ParameterAlreadyDeclaredException(name)
        kind, dynamic = value if isinstance(value, _KINDS) else None, _is(descriptor, "dynamic_typing")
        if kind is not None:
            if kind is _KINDS.NOT_SET or dynamic:
                raise ValueError(f"Cannot declare parameter {name} as {kind}")
            # rclpy has no value until somebody gives one: to the run it is unknown.
            value = Unknown(f"parameter {name}")
        elif value is None and not dynamic:
            raise ValueError("Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET")
        if isinstance(value, bool) and name not in OF_EVERY_NODE:
            value ^= unknown.other_way
        parameter = Parameter(name, kind, value)
        self._oracle_kinds[name] = None if dynamic or (isinstance(value, Unknown) and kind is None) else parameter.type_
        self._oracle_descriptors[name] = descriptor
        parameter = parameter if ignore_override else self._oracle_overrides.get(name, parameter)
        if self._oracle_wrong_type(parameter):
            raise InvalidParameterTypeException(name, parameter.type_)
        if reason := self._oracle_refused(parameter):
            raise InvalidParameterValueException(f"{name} = {parameter.value!r}: {reason}")
        self._oracle_values[name] = parameter
        return parameter

    def _oracle_wrong_type(self, parameter: Parameter) -> bool:
        """Whether a value has another type than the one that its parameter was declared with."""
        expected = self._oracle_kinds.get(parameter.name)
        return expected is not None and parameter.type_ not in (expected, _KINDS.NOT_SET)

    def _oracle_refused(self, parameter: Parameter) -> str:
        """Why a value is not taken: its range, or what the program's callbacks say of it; empty where it is."""
        descriptor, value = self._oracle_descriptors.get(parameter.name), parameter.value
        for name in ("integer_range", "floating_point_range"):
            ranges = getattr(descriptor, name, None)
            for each in ranges if isinstance(ranges, list) and isinstance(value, (int, float)) else ():
                if not each.from_value <= value <= each.to_value:
                    return f"{value} is out of its range"
        for callback in self._oracle_parameter_callbacks:
            result = callback([parameter])
            if result.successful is False:
                return str(result.reason)
        return ""

    def undeclare_parameter(self, name: str) -> None:
        """Forget a parameter."""
        if name not in self._oracle_values:
            raise ParameterNotDeclaredException(name)
        del self._oracle_values[name]

    def has_parameter(self, name: str) -> bool:
        """Whether it is declared."""
        return name in self._oracle_values

    def get_parameter(self, name: str) -> Parameter:
        """A declared parameter."""
        if name in self._oracle_values:
            return self._oracle_values[name]
        if self._oracle_allow_undeclared:
            return Parameter(name, _KINDS.NOT_SET)
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: Any) -> list[Parameter]:
        """Several declared parameters."""
        return [self.get_parameter(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Any = None) -> Any:
        """A parameter, or what is given instead."""
        found = self._oracle_values.get(name)
        if found is None or found.value is None:
            return alternative_value if alternative_value is not None else Parameter(name, _KINDS.NOT_SET)
        return found

    def get_parameter_type(self, name: str) -> Any:
        """The type of a parameter, as a number of rcl_interfaces/msg/ParameterType."""
        return self.get_parameter(name).type_.value

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """The parameters below a prefix, by the rest of their name."""
        start = f"{prefix}." if prefix else ""
        return {name[len(start) :]: each for name, each in self._oracle_values.items() if name.startswith(start)}

    def set_parameters(self, parameter_list: Any) -> list[Any]:
        """Set parameters one after the other."""
        results = []
        for parameter in parameter_list:
            if parameter.name not in self._oracle_values and not self._oracle_allow_undeclared:
                raise ParameterNotDeclaredException(parameter.name)
            fixed = _is(self._oracle_descriptors.get(parameter.name), "read_only")
            reason = "is read-only" if fixed else "Wrong parameter type" if self._oracle_wrong_type(parameter) else ""
            reason = reason or self._oracle_refused(parameter)
            if not reason:
                self._oracle_values[parameter.name] = parameter
            results.append(_result(successful=not reason, reason=reason))
        return results

    def set_parameters_atomically(self, parameter_list: Any) -> Any:
        """Set parameters together."""
        refused = [each for each in self.set_parameters(parameter_list) if not each.successful]
        return refused[0] if refused else _result(successful=True, reason="")

    def add_on_set_parameters_callback(self, callback: Any) -> None:
        """Ask before a value is taken."""
        self._oracle_parameter_callbacks.append(callback)

    def _add_callback(self, callback: Any) -> None:
        return None

    add_pre_set_parameters_callback = add_post_set_parameters_callback = set_parameters_callback = _add_callback

    def _remove_callback(self, callback: Any) -> None:
        if callback in self._oracle_parameter_callbacks:
            self._oracle_parameter_callbacks.remove(callback)

    remove_on_set_parameters_callback = remove_pre_set_parameters_callback = _remove_callback
    remove_post_set_parameters_callback = _remove_callback

    def describe_parameter(self, name: str) -> Any:
        """The descriptor given at declaration."""
        self.get_parameter(name)
        return self._oracle_descriptors.get(name) or interface("rcl_interfaces", "msg", "ParameterDescriptor")(
            name=name
        )

    def describe_parameters(self, names: Any) -> list[Any]:
        """Several descriptors."""
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(self, name: str, descriptor: Any, alternative_value: Any = None) -> Any:
        """Replace a descriptor."""
        self._oracle_descriptors[name] = descriptor
        return self.get_parameter(name).get_parameter_value()


def _descriptor(**fields: Any) -> Any:
    return interface("rcl_interfaces", "msg", "ParameterDescriptor")(**fields)


def _result(**fields: Any) -> Any:
    return interface("rcl_interfaces", "msg", "SetParametersResult")(**fields)


def _checked(name: Any, descriptor: Any) -> Any:
    """A descriptor, or what stands for none; rclpy's refusals of a name and of what is none."""
    if not isinstance(name, str):
        raise TypeError(f"First element {name} in parameters list is not a str.")
    if not name:
        raise InvalidParameterException(name)
    if not isinstance(descriptor, (Interface, Unknown, type(None))):
        raise TypeError(f"Third element {descriptor} in parameters list is not a ParameterDescriptor.")
    return descriptor or _descriptor(dynamic_typing=False, read_only=False)


def _is(descriptor: Any, name: str) -> bool:
    return getattr(descriptor, name, False) is True
