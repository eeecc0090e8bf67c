"""Stand-in for rclpy.parameter_event_handler."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface
from benchmarks.accuracy.oracle.unknown import Unknown

from .node import Node, record
from .qos import normal_form, qos_profile_parameter_events


class ParameterEventHandler:
    """Listens to /parameter_events."""

    def __init__(self, node: Node, qos_profile: Any = qos_profile_parameter_events, *_: object, **__: object) -> None:
        type_ = interface("rcl_interfaces", "msg", "ParameterEvent")
        record(node, "subscriber", type_, "/parameter_events", normal_form(qos_profile))

    def _handle(self, *_: object, **__: object) -> Any:
        return Unknown("parameter callback handle")

    add_parameter_callback = add_parameter_event_callback = configure_nodes_filter = _handle
    remove_parameter_callback = remove_parameter_event_callback = _handle
