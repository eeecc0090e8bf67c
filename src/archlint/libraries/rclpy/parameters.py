"""ROS parameters: declared with a default, overridden from outside, read in every spelling."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter import containers
from archlint.interpreter.values import (
    FALSE,
    TRUE,
    DictValue,
    Instance,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.rclpy import nodes
from archlint.libraries.rclpy.fields import PARAMETERS
from archlint.libraries.rclpy.parameter_values import (
    from_parameter,
    new_parameter,
    value_from_python,
)

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run

BY_NAME = frozenset(f"rclpy.node.Node.{name}" for name in ("get_parameter", "get_parameter_or", "has_parameter"))
"""Calls that name one parameter."""


def read(run: Run, call: ApiUse, name: Value) -> Value:
    """The value of a parameter by name."""
    return one_of(_read_option(run, call, option.text) for option in alternatives(name))


def _read_option(run: Run, call: ApiUse, name: str | None) -> Value:
    if name is None:
        return Unknown("the parameter's name is not known")
    undeclared = Unknown(f"the parameter '{name}' is not declared in the code that was followed", name)
    return value_in_reach(run, call, name) or undeclared


def value_in_reach(run: Run, call: ApiUse, name: str) -> Value | None:
    """The value of a parameter that is declared, or set from outside; None of others."""
    value = run.store.get(nodes.node_key(run, call.receiver), PARAMETERS[name])
    if value is not None:
        return value
    node = nodes.known_node(run, call.receiver)
    for given in run.overrides.value(node, name):
        return from_parameter(run, value_from_python(run, given, run.overrides.look_at_value(node, name)), name)
    return Known(False, frozenset({name})) if name == "use_sim_time" else None


def get_parameter(run: Run, call: ApiUse) -> Value:
    name = call.get("name") or Unknown("no name is given")
    return new_parameter(run, name, read(run, call, name))


def get_parameters(run: Run, call: ApiUse) -> Value:
    names = (call.get("names") or Unknown("no names")).items(run)
    if names is None:
        return Unknown("the parameters that are read are not known")
    parameters: list[Value] = [new_parameter(run, name, read(run, call, name)) for name in names.values]
    return containers.new_list(run, parameters, "list", names.open)


def get_parameter_or(run: Run, call: ApiUse) -> Value:
    name = call.get("name") or Unknown("no name is given")
    value = read(run, call, name)
    alternative = call.get("alternative_value")
    text = name.text
    if text is not None and isinstance(alternative, Instance) and value_in_reach(run, call, text) is None:
        stored = run.store.get(alternative.key, "value")
        if stored is not None:
            value = from_parameter(run, stored, text)
    return new_parameter(run, name, value)


def get_parameters_by_prefix(run: Run, call: ApiUse) -> Value:
    prefix = call.get("prefix")
    node = nodes.known_node(run, call.receiver)
    if not isinstance(prefix, Known) or node is None:
        return Unknown("the parameters that are read are not known")
    start = f"{prefix.value!s}." if prefix.value else ""
    entries: dict[Hashable, tuple[Value, Value]] = {}
    for declared in node.parameters:
        text = declared.name.text
        if text is not None and text.startswith(start):
            key = Known(text[len(start) :])
            at = key.entry_key()
            if at is not None:
                entries[at] = (key, new_parameter(run, Known(text), read(run, call, Known(text))))
    parameters: DictValue = containers.new_dict(run, entries, True)
    return parameters


def has_parameter(run: Run, call: ApiUse) -> Value:
    name = call.get("name")
    if isinstance(name, Known):
        value = run.store.get(nodes.node_key(run, call.receiver), PARAMETERS[str(name.value)])
        if value is not None:
            return TRUE
        if run.context.role == model.Role.INIT and not run.branch_arms and run.overrides.are_none:
            return FALSE
    return Unknown("whether the parameter is declared")


def set_parameters(run: Run, call: ApiUse) -> Value:
    rows = (call.get("parameter_list") or Unknown("no parameters")).items(run)
    key = nodes.node_key(run, call.receiver)
    for row in rows.values if rows is not None else ():
        if isinstance(row, Instance):
            name, value = run.store.get(row.key, "name"), run.store.get(row.key, "value")
            if isinstance(name, Known) and value is not None:
                run.store.set(key, PARAMETERS[str(name.value)], from_parameter(run, value, str(name.value)))
    return Unknown("the result of setting parameters")
