"""Topics that have one meaning in every ROS 2 system, and what follows from it.

Sources: rclpy ``node.py`` and ``time_source.py`` (``/rosout``, ``/parameter_events``, ``/clock``); tf2_ros
``transform_broadcaster.py`` and ``static_transform_broadcaster.py`` (``/tf``, ``/tf_static``); REP 107 and
diagnostic_updater (``/diagnostics``); robot_state_publisher and joint_state_publisher (``/joint_states``,
``/robot_description``); rviz_default_plugins, whose tools publish ``/initialpose`` and ``/clicked_point`` beside
whatever else sets a pose once.
"""

from __future__ import annotations

from archlint.records import dataclass


@dataclass(frozen=True)
class WellKnownTopic:
    """What everybody knows of a topic."""

    name: str
    absolute: bool = False
    """Whether code writes it with its slash, for it is the same topic for all robots."""
    many_publishers: bool = False
    """Whether it is made to be published by many."""
    of_every_node: bool = False
    """Whether any node may have it without a word of it in its own code."""
    of_rclpy: bool = False
    """Whether every node publishes it, as rclpy makes it so."""
    by_click: bool = False
    """Whether somebody clicks it into RViz: each message is an event, whoever else may send one."""
    of_transforms: bool = False
    """Whether tf2 publishes it."""
    for_tools: bool = False
    """Whether tools listen to it that no workspace holds: RViz, the diagnostics aggregator, loggers."""


TOPICS = (
    WellKnownTopic("/tf", absolute=True, many_publishers=True, of_every_node=True, of_transforms=True, for_tools=True),
    WellKnownTopic(
        "/tf_static", absolute=True, many_publishers=True, of_every_node=True, of_transforms=True, for_tools=True
    ),
    WellKnownTopic("/rosout", absolute=True, many_publishers=True, of_every_node=True, of_rclpy=True, for_tools=True),
    WellKnownTopic(
        "/parameter_events", absolute=True, many_publishers=True, of_every_node=True, of_rclpy=True, for_tools=True
    ),
    WellKnownTopic("/clock", absolute=True, of_every_node=True),
    WellKnownTopic("/diagnostics", absolute=True, many_publishers=True, for_tools=True),
    WellKnownTopic("/initialpose", by_click=True),
    WellKnownTopic("/clicked_point", by_click=True),
    WellKnownTopic("/joint_states", many_publishers=True, for_tools=True),
    WellKnownTopic("/robot_description", absolute=True, for_tools=True),
)

ABSOLUTE = frozenset(topic.name for topic in TOPICS if topic.absolute)
OF_MANY_PUBLISHERS = frozenset(topic.name for topic in TOPICS if topic.many_publishers)
BY_CLICK = frozenset(topic.name for topic in TOPICS if topic.by_click)
OF_EVERY_NODE = frozenset(topic.name for topic in TOPICS if topic.of_every_node)
OF_RCLPY = tuple(topic.name for topic in TOPICS if topic.of_rclpy)
OF_TRANSFORMS = frozenset(topic.name for topic in TOPICS if topic.of_transforms)
FOR_TOOLS = frozenset(topic.name for topic in TOPICS if topic.for_tools)

TYPES_OF_MANY_PUBLISHERS = frozenset(
    {
        "diagnostic_msgs/msg/DiagnosticArray",
        "moveit_msgs/msg/DisplayRobotState",
        "moveit_msgs/msg/DisplayTrajectory",
        "moveit_msgs/msg/PlanningScene",
        "px4_msgs/msg/VehicleCommand",
        "rcl_interfaces/msg/Log",
        "tf2_msgs/msg/TFMessage",
        "visualization_msgs/msg/Marker",
        "visualization_msgs/msg/MarkerArray",
    }
)
"""Each message of these says whose it is, so that the ones of several nodes add up, or is there to be looked at; RViz
and the diagnostics aggregator listen to them, whatever the topic is called.  PX4 takes a ``VehicleCommand`` of whoever
sends it as a request, and answers each."""
