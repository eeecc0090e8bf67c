"""Stand-in for rclpy.parameter_client."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.interfaces import interface
from benchmarks.accuracy.oracle.later import finished
from benchmarks.accuracy.oracle.unknown import Unknown

from .node import Node, record
from .qos import normal_form, qos_profile_parameter_events, qos_profile_services_default
from .task import Future

_SERVICES = {
    "get_parameters": "GetParameters",
    "get_parameter_types": "GetParameterTypes",
    "list_parameters": "ListParameters",
    "describe_parameters": "DescribeParameters",
    "set_parameters": "SetParameters",
    "set_parameters_atomically": "SetParametersAtomically",
}


class AsyncParameterClient:
    """Six clients of another node's parameter services."""

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: Any = qos_profile_services_default,
        callback_group: Any = None,
    ) -> None:
        self.node, self.remote_node_name = node, remote_node_name
        for name, type_name in _SERVICES.items():
            type_ = interface("rcl_interfaces", "srv", type_name)
            record(node, "client", type_, f"{remote_node_name}/{name}", normal_form(qos_profile))

    def services_are_ready(self) -> bool:
        """They are there."""
        return True

    def wait_for_services(self, timeout_sec: Any = None) -> bool:
        """They are there."""
        return True

    def _answer(self, *_: object, callback: Any = None, **__: object) -> Future:
        future = finished(Unknown("parameter response"))
        if callback is not None:
            future.add_done_callback(callback)
        return future

    list_parameters = get_parameters = set_parameters = describe_parameters = get_parameter_types = _answer
    set_parameters_atomically = delete_parameters = load_parameter_file = load_parameter_file_atomically = _answer

    def on_parameter_event(self, callback: Any, qos_profile: Any = qos_profile_parameter_events, **_: object) -> Any:
        """Record the subscription to the events."""
        type_ = interface("rcl_interfaces", "msg", "ParameterEvent")
        return self.node.create_subscription(type_, "/parameter_events", callback, qos_profile)
