"""The parameters of a stand-in node: declared defaults and constructor overrides, nothing from outside."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle import unknown
from benchmarks.accuracy.oracle.interfaces import interface
from benchmarks.accuracy.oracle.unknown import Unknown

from .exceptions import (
    InvalidParameterTypeException,
    ParameterAlreadyDeclaredException,
    ParameterNotDeclaredException,
)
from .parameter import Parameter

_KINDS = Parameter.Type


class ParameterStore:
    """The parameter half of a node."""

    def _start_parameters(self, overrides: Any, allow_undeclared: bool, declare_overrides: bool) -> None:
        self._oracle_values: dict[str, Parameter] = {}
        self._parameters = self._oracle_values  # some nodes look into it
        self._oracle_descriptors: dict[str, Any] = {}
        self._oracle_parameter_callbacks: list[Any] = []
        self._oracle_allow_undeclared = bool(allow_undeclared)
        self._oracle_overrides = {each.name: each for each in overrides or () if hasattr(each, "name")}
        self.declare_parameter("use_sim_time", False)
        if declare_overrides:
            self._oracle_values.update(self._oracle_overrides)

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare one parameter."""
        return self._oracle_declare(name, value, descriptor, ignore_override)

    def declare_parameters(self, namespace: str, parameters: Any, ignore_override: bool = False) -> list[Parameter]:
        """Declare several: (name[, value[, descriptor]]) each."""
        declared = []
        for name, *rest in parameters:
            full = f"{namespace}.{name}" if namespace else name
            declared.append(self._oracle_declare(full, *[*rest, None, None][:2], ignore_override))
        return declared

    def _oracle_declare(self, name: Any, value: Any, descriptor: Any, ignore_override: bool) -> Parameter:
        if name in self._oracle_values:
            raise ParameterAlreadyDeclaredException(name)
        kind = value if isinstance(value, _KINDS) else None
        if kind is not None:
            # rclpy has no value until somebody gives one: to the run it is unknown.
            value = None if kind is _KINDS.NOT_SET else Unknown(f"parameter {name}")
        if isinstance(value, bool) and name != "use_sim_time":
            value ^= unknown.other_way
        parameter = Parameter(name, kind, value)
        override = None if ignore_override else self._oracle_overrides.get(name)
        if override is not None:
            dynamic = getattr(descriptor, "dynamic_typing", False) is True
            known = _KINDS.NOT_SET not in (parameter.type_, override.type_)
            if known and parameter.type_ != override.type_ and not dynamic:
                raise InvalidParameterTypeException(name, override.type_)
            parameter = override
        self._oracle_values[name] = parameter
        self._oracle_descriptors[name] = descriptor
        return parameter

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
            return self._oracle_overrides.get(name) or Parameter(name, _KINDS.NOT_SET)
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
        """The type of a parameter."""
        return self.get_parameter(name).type_

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """The parameters below a prefix, by the rest of their name."""
        start = f"{prefix}." if prefix else ""
        return {name[len(start) :]: each for name, each in self._oracle_values.items() if name.startswith(start)}

    def set_parameters(self, parameter_list: Any) -> list[Any]:
        """Set parameters one after the other."""
        for parameter in parameter_list:
            if parameter.name not in self._oracle_values and not self._oracle_allow_undeclared:
                raise ParameterNotDeclaredException(parameter.name)
            self._oracle_values[parameter.name] = parameter
        return [interface("rcl_interfaces", "msg", "SetParametersResult")(successful=True) for _ in parameter_list]

    def set_parameters_atomically(self, parameter_list: Any) -> Any:
        """Set parameters together."""
        self.set_parameters(parameter_list)
        return interface("rcl_interfaces", "msg", "SetParametersResult")(successful=True)

    def _add_callback(self, callback: Any) -> None:
        self._oracle_parameter_callbacks.append(callback)

    add_on_set_parameters_callback = add_pre_set_parameters_callback = _add_callback
    add_post_set_parameters_callback = set_parameters_callback = _add_callback

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
