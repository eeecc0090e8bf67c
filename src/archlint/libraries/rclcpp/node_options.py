"""``rclcpp::NodeOptions``: arguments, parameters and switches that the source gives a node.

Each setter changes the options and gives them back; a copy is an object of its own.  What is set is kept under the word
that rclpy's ``Node`` has for it, so that a node reads it as its own argument.
Source: ``rclcpp/node_options.hpp`` and ``node_options.cpp``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.containers import new_list
from archlint.interpreter.values import TRUE, External, Instance, ListValue, Unknown, Value
from archlint.libraries.rclpy.parameter_values import new_parameter

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

OPTIONS = "rclcpp.NodeOptions"
FIELDS = {
    "arguments": "cli_args",
    "use_global_arguments": "use_global_arguments",
    "enable_rosout": "enable_rosout",
    "start_parameter_services": "start_parameter_services",
    "allow_undeclared_parameters": "allow_undeclared_parameters",
    "automatically_declare_parameters_from_overrides": "automatically_declare_parameters_from_overrides",
}
"""The argument of rclpy's ``Node`` by the setter that decides it."""
PARAMETERS = "parameter_overrides"
_UNHEEDED = (
    "use_intra_process_comms",
    "start_parameter_event_publisher",
    "parameter_event_qos",
    "rosout_qos",
    "clock_type",
    "clock_qos",
    "use_clock_thread",
    "enable_topic_statistics",
    "enable_logger_service",
    "context",
    "allocator",
    "parameter_event_publisher_options",
    "parameter_event_publisher_enabled",
)
"""Setters of what the graph does not show."""


def _new(run: Run, site: CallSite) -> Value:
    """``NodeOptions()``, or a copy of others: of those that are not known, nothing is known either."""
    options = Instance(External(OPTIONS), run.store.new_key())
    copied = site.args[0] if site.args else None
    if isinstance(copied, Instance) and copied.cls.dotted == OPTIONS:
        for name in (*FIELDS.values(), PARAMETERS):
            value = run.store.get(copied.key, name)
            if value is not None:
                run.store.set(options.key, name, value)
    return options


def _sets(name: str) -> Method:
    def set_option(run: Run, receiver: Value, site: CallSite) -> Value:
        if isinstance(receiver, Instance):
            run.store.set(receiver.key, name, site.args[0] if site.args else TRUE)
        return receiver

    return set_option


def _set_parameters(run: Run, receiver: Value, site: CallSite) -> Value:
    """``parameter_overrides({{"rate", 5}, rclcpp::Parameter("name", "x")})``."""
    given = site.args[0].items(run) if site.args else None
    parameters = [_parameter(run, item) for item in given.values] if given is not None else []
    if isinstance(receiver, Instance):
        _keep(run, receiver, [parameter for parameter in parameters if parameter is not None])
    return receiver


def _append_parameter(run: Run, receiver: Value, site: CallSite) -> Value:
    """``append_parameter_override("rate", 5)``."""
    if isinstance(receiver, Instance) and len(site.args) == 2:
        before = run.store.get(receiver.key, PARAMETERS)
        values = list(before.items(run).values) if isinstance(before, ListValue) else []
        _keep(run, receiver, [*values, new_parameter(run, site.args[0], site.args[1])])
    return receiver


def _keep(run: Run, options: Instance, parameters: Sequence[Value]) -> None:
    run.store.set(options.key, PARAMETERS, new_list(run, parameters))


def _parameter(run: Run, item: Value) -> Value | None:
    if isinstance(item, Instance):
        return item
    pair = item.items(run)
    if pair is None or pair.open or len(pair.values) != 2:
        return None
    return new_parameter(run, pair.values[0], pair.values[1])


def _unchanged(run: Run, receiver: Value, site: CallSite) -> Value:
    return receiver if site.args else Unknown("an option of a node")


PLAIN: dict[str, Plain] = {OPTIONS: _new}
METHODS: dict[str, Method] = {
    **{f"{OPTIONS}.{setter}": _sets(name) for setter, name in FIELDS.items()},
    **{f"{OPTIONS}.{setter}": _unchanged for setter in _UNHEEDED},
    f"{OPTIONS}.{PARAMETERS}": _set_parameters,
    f"{OPTIONS}.append_parameter_override": _append_parameter,
}

__all__ = ["FIELDS", "METHODS", "OPTIONS", "PARAMETERS", "PLAIN"]
