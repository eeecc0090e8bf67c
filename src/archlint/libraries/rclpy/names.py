"""The names of rclpy: where a class is defined, under which other names it is imported, what nodes can do."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from archlint.libraries import tables

if TYPE_CHECKING:
    from archlint.ros.interfaces import MessageClass

NODE = "rclpy.node.Node"
LIFECYCLE_NODE = "rclpy.lifecycle.node.LifecycleNode"
LIFECYCLE_MIXIN = "rclpy.lifecycle.node.LifecycleNodeMixin"
"""What LifecycleNode adds to Node, for classes that derive from both; its constructor takes no name."""

NODE_CLASSES = frozenset(
    {NODE, LIFECYCLE_NODE, LIFECYCLE_MIXIN, "rclpy.node.BaseNode", "rclpy.experimental.async_node.AsyncNode"}
)

FOREIGN_NODES = frozenset(
    {
        "nav2_simple_commander.robot_navigator.BasicNavigator",
        "turtlebot4_navigation.turtlebot4_navigator.TurtleBot4Navigator",
    }
)
"""Node classes of other packages whose name does not say so."""

_OF_OTHER_SYSTEMS = ("gz.", "ignition.", "dora.")
"""Gazebo's transport and dora have nodes of their own."""


def is_of_other_system(path: str) -> bool:
    """Whether a foreign class that is called a node is none of ROS."""
    return path.startswith(_OF_OTHER_SYSTEMS)


BUFFER = "tf2_ros.buffer.Buffer"
_ALIASES = {
    "rclpy.Node": NODE,
    "rclpy.lifecycle.LifecycleNode": LIFECYCLE_NODE,
    "rclpy.lifecycle.Node": LIFECYCLE_NODE,
    "rclpy.lifecycle.LifecycleNodeMixin": LIFECYCLE_MIXIN,
    "rclpy.lifecycle.NodeMixin": LIFECYCLE_MIXIN,
    "rclpy.lifecycle.managed_entity.ManagedEntity": "rclpy.lifecycle.ManagedEntity",
    "rclpy.action.ActionServer": "rclpy.action.server.ActionServer",
    "rclpy.action.ActionClient": "rclpy.action.client.ActionClient",
    "rclpy.action.GoalResponse": "rclpy.action.server.GoalResponse",
    "rclpy.action.CancelResponse": "rclpy.action.server.CancelResponse",
    "rclpy.Parameter": "rclpy.parameter.Parameter",
    "rclpy.node.Parameter": "rclpy.parameter.Parameter",
    "rclpy.Future": "rclpy.task.Future",
    "rclpy.executors.Future": "rclpy.task.Future",
    "rclpy.experimental.AsyncNode": "rclpy.experimental.async_node.AsyncNode",
    "rclpy.experimental.EventsExecutor": "rclpy.experimental.events_executor.EventsExecutor",
    "rclpy.node.Publisher": "rclpy.publisher.Publisher",
    "rclpy.node.Subscription": "rclpy.subscription.Subscription",
    "rclpy.node.Client": "rclpy.client.Client",
    "rclpy.node.QoSProfile": "rclpy.qos.QoSProfile",
    "rclpy.node.MutuallyExclusiveCallbackGroup": "rclpy.callback_groups.MutuallyExclusiveCallbackGroup",
    "rclpy.node.ReentrantCallbackGroup": "rclpy.callback_groups.ReentrantCallbackGroup",
    "rclpy.executors.ReentrantCallbackGroup": "rclpy.callback_groups.ReentrantCallbackGroup",
    "rclpy.executors.MutuallyExclusiveCallbackGroup": "rclpy.callback_groups.MutuallyExclusiveCallbackGroup",
    "tf2_ros.Buffer": "tf2_ros.buffer.Buffer",
    "tf2_ros.TransformListener": "tf2_ros.transform_listener.TransformListener",
    "tf2_ros.TransformBroadcaster": "tf2_ros.transform_broadcaster.TransformBroadcaster",
    "tf2_ros.StaticTransformListener": "tf2_ros.static_transform_listener.StaticTransformListener",
    "tf2_ros.StaticTransformBroadcaster": ("tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster"),
    "tf2_ros.transform_broadcaster.StaticTransformBroadcaster": (
        "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster"
    ),
    "tf2_ros.BufferClient": "tf2_ros.buffer_client.BufferClient",
    "message_filters.subscriber.Subscriber": "message_filters.Subscriber",
    "rclpy.qos.QoSReliabilityPolicy": "rclpy.qos.ReliabilityPolicy",
    "rclpy.qos.QoSDurabilityPolicy": "rclpy.qos.DurabilityPolicy",
    "rclpy.qos.QoSHistoryPolicy": "rclpy.qos.HistoryPolicy",
    "rclpy.qos.QoSLivelinessPolicy": "rclpy.qos.LivelinessPolicy",
    "rclpy.expand_topic_name.expand_topic_name": "rclpy.expand_topic_name",
}

PARAMETER_VALUES = frozenset({"rcl_interfaces.msg.ParameterValue"})

NODE_METHODS = frozenset(tables.NODE_ROWS)

_OTHER_NODE_ATTRIBUTES = frozenset(
    [
        "get_logger",
        "get_clock",
        "context",
        "handle",
        "executor",
        "default_callback_group",
        "publishers",
        "subscriptions",
        "clients",
        "services",
        "timers",
        "guards",
        "waitables",
        "create_task",
        "count_publishers",
        "count_subscribers",
        "count_clients",
        "count_services",
        "get_topic_names_and_types",
        "get_service_names_and_types",
        "get_node_names",
        "get_node_names_and_namespaces",
        "get_publishers_info_by_topic",
        "get_subscriptions_info_by_topic",
        "get_publisher_names_and_types_by_node",
        "get_subscriber_names_and_types_by_node",
        "get_service_names_and_types_by_node",
        "get_client_names_and_types_by_node",
        "add_waitable",
        "remove_waitable",
        "add_on_set_parameters_callback",
        "remove_on_set_parameters_callback",
        "describe_parameter",
        "describe_parameters",
        "get_parameter_type",
        "get_parameter_types",
        "set_descriptor",
        "set_parameters_callback",
        "list_parameters",
        "destroy_node",
        "destroy_guard_condition",
        "destroy_rate",
        "add_post_set_parameters_callback",
        "wait_for_node",
        "trigger_configure",
        "trigger_activate",
        "trigger_deactivate",
        "trigger_cleanup",
        "trigger_shutdown",
        "add_managed_entity",
    ]
)


PRIVATE_NODE_METHODS = frozenset(
    [
        "_apply_descriptor",
        "_apply_descriptor_and_set",
        "_apply_descriptors",
        "_apply_floating_point_range",
        "_apply_integer_range",
        "_call_post_set_parameters_callback",
        "_call_pre_set_parameters_callback",
        "_check_undeclared_parameters",
        "_count_clients_or_servers",
        "_count_publishers_or_subscribers",
        "_declare_parameter_common",
        "_get_info_by_topic",
        "_set_parameters",
        "_set_parameters_atomically",
        "_set_parameters_atomically_common",
        "_validate_qos_or_depth_parameter",
        "_validate_topic_or_service_name",
        "_wake_executor",
    ]
)
"""Methods of Node that are not meant for others, in every distribution from Foxy on (rclpy ``node.py``)."""

LIFECYCLE_METHODS = frozenset(
    [
        "add_managed_entity",
        "create_lifecycle_publisher",
        "destroy_lifecycle_publisher",
        "on_activate",
        "on_cleanup",
        "on_configure",
        "on_deactivate",
        "on_error",
        "on_shutdown",
        "trigger_activate",
        "trigger_cleanup",
        "trigger_configure",
        "trigger_deactivate",
        "trigger_shutdown",
    ]
)
"""What LifecycleNode has besides, in every distribution (rclpy ``lifecycle/node.py``)."""


def is_node_attribute(name: str) -> bool:
    """Whether rclpy's Node (or LifecycleNode) may have an attribute of this name; private ones are not ours to
    know, but for those that code uses to store its own."""
    return name in NODE_METHODS or name in _OTHER_NODE_ATTRIBUTES or name.startswith("__") or name.startswith("on_")


def is_missing_method(path: str) -> bool:
    """Whether a node is asked for an attribute that rclpy's does not have: something else put it there."""
    owner, _, name = path.rpartition(".")
    return owner in NODE_CLASSES and not is_node_attribute(name)


_PREFIX = re.compile(r"^(rclpy|tf2_ros|message_filters|rclpy_action)\b")

_API_CLASSES = (
    "rclpy.client.Client",
    "rclpy.publisher.Publisher",
    "rclpy.subscription.Subscription",
    "rclpy.service.Service",
    "rclpy.timer.Timer",
    "rclpy.timer.Rate",
    "rclpy.task.Future",
    "rclpy.action.client.ActionClient",
    "rclpy.action.server.ActionServer",
    "rclpy.parameter.Parameter",
    "tf2_ros.buffer.Buffer",
)


@lru_cache(maxsize=4096)
def canonical(path: str) -> str:
    """The name a class or function of rclpy has where it is defined."""
    if path in _ALIASES:
        return _ALIASES[path]
    head, _, tail = path.rpartition(".")
    if head in _ALIASES:
        return f"{_ALIASES[head]}.{tail}"
    return path


def is_api_class(path: str) -> bool:
    return path in _API_CLASSES or path.startswith(("message_filters.", "tf2_ros."))


_LIFECYCLE_ONLY = frozenset({"create_lifecycle_publisher", "trigger_configure", "trigger_activate"})


def method(cls: str, name: str) -> str:
    """The canonical name of a node's method: what LifecycleNode inherits is Node's, wherever it stands among bases."""
    if cls not in NODE_CLASSES or name == "__init__" or name.startswith("on_"):
        return f"{cls}.{name}"
    return f"{LIFECYCLE_NODE if name in _LIFECYCLE_ONLY else NODE}.{name}"


_INTERFACE = re.compile(r"^([a-z][a-z0-9_]*)\.(msg|srv|action)\.(?:_\w+\.)?([A-Z]\w*)((?:\.\w+)*)$")
_PARTS: Final[dict[str, MessageClass]] = {
    "Request": "Request",
    "Response": "Response",
    "Event": "Event",
    "Goal": "Goal",
    "Result": "Result",
    "Feedback": "Feedback",
    "Impl": "Impl",
}
_PART_NAME = re.compile(r"^(\w+)_(Request|Response|Goal|Result|Feedback)$")


def is_part_of_interface(name: str) -> bool:
    """Whether a class name is that of a request, response, goal … rather than of an interface."""
    return (
        re.search(r"_(Request|Response|Event|Goal|Result|Feedback|FeedbackMessage|SendGoal|GetResult)", name)
        is not None
    )


def is_interface(text: str) -> bool:
    """Whether a text is the full name of an interface, ``std_msgs/msg/String``."""
    return "." not in text and interface_and_section(text.replace("/", ".")) == (text, "")


@lru_cache(maxsize=4096)
def interface_and_section(path: str) -> tuple[str | None, MessageClass]:
    """``std_msgs.msg.String`` → ``("std_msgs/msg/String", "")``; with ``.Request`` and the like as part."""
    match = _INTERFACE.match(path)
    if match is None:
        return None, ""
    package, kind, name, rest = match.groups()
    parts = [part for part in rest.split(".") if part]
    if not parts:
        flat = _PART_NAME.match(name)
        if flat is not None and kind != "msg":
            return f"{package}/{kind}/{flat.group(1)}", _PARTS[flat.group(2)]
        return f"{package}/{kind}/{name}", ""
    if len(parts) == 1 and parts[0] in _PARTS:
        return f"{package}/{kind}/{name}", _PARTS[parts[0]]
    return None, ""
