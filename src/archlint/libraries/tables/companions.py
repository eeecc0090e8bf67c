"""Rows of what helpers create on a node that they are given: message_filters, tf2_ros, clients of parameters."""

from __future__ import annotations

from archlint import model
from archlint.libraries.tables.api import Api

ROWS = (
    Api(
        "message_filters.Subscriber",
        "node msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options raw "
        "content_filter_options",
        effect="endpoint",
        kind=model.EntityKind.SUBSCRIBER,
        node="node",
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        default_qos="default",
        returns="message_filters.Subscriber",
    ),
    Api(
        "tf2_ros.transform_broadcaster.TransformBroadcaster",
        "node qos",
        effect="endpoint",
        kind=model.EntityKind.PUBLISHER,
        node="node",
        qos="qos",
        default_qos="tf",
        fixed_name="/tf",
        fixed_type="tf2_msgs/msg/TFMessage",
        returns="tf2_ros.transform_broadcaster.TransformBroadcaster",
    ),
    Api(
        "tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
        "node qos",
        effect="endpoint",
        kind=model.EntityKind.PUBLISHER,
        node="node",
        qos="qos",
        default_qos="tf_static",
        fixed_name="/tf_static",
        fixed_type="tf2_msgs/msg/TFMessage",
        returns="tf2_ros.static_transform_broadcaster.StaticTransformBroadcaster",
    ),
    *(
        Api(f"tf2_ros.{broadcaster}.sendTransform", "transform", watched=True)
        for broadcaster in (
            "transform_broadcaster.TransformBroadcaster",
            "static_transform_broadcaster.StaticTransformBroadcaster",
        )
    ),
    Api(
        "tf2_ros.transform_listener.TransformListener",
        "buffer node * spin_thread qos static_qos tf_topic tf_static_topic static_only",
        effect="transform_listener",
        node="node",
        watched=True,
        returns="tf2_ros.transform_listener.TransformListener",
    ),
    Api(
        "tf2_ros.static_transform_listener.StaticTransformListener",
        "buffer node * spin_thread static_qos tf_static_topic",
        effect="static_transform_listener",
        node="node",
        returns="tf2_ros.static_transform_listener.StaticTransformListener",
    ),
    Api("tf2_ros.buffer.Buffer", "cache_time node", effect="transform_buffer", node="node"),
    Api("tf2_ros.buffer_h.Buffer", "clock cache_time node qos", effect="transform_buffer", node="node"),
    Api(
        "tf2_ros.buffer_client.BufferClient",
        "node ns check_frequency timeout_padding",
        effect="endpoint",
        kind=model.EntityKind.ACTION_CLIENT,
        node="node",
        name="ns",
        fixed_type="tf2_msgs/action/LookupTransform",
        default_qos="services_default",
        returns="tf2_ros.buffer_client.BufferClient",
    ),
    Api(
        "rclpy.parameter_client.AsyncParameterClient",
        "node remote_node_name qos_profile callback_group",
        effect="parameter_client",
        node="node",
        returns="rclpy.parameter_client.AsyncParameterClient",
    ),
    Api("rclpy.parameter_client.AsyncParameterClient.wait_for_services", "timeout_sec", watched=True),
    Api(
        "rclpy.parameter_event_handler.ParameterEventHandler",
        "node qos_profile callback_group event_callbacks qos_overriding_options raw",
        effect="endpoint",
        kind=model.EntityKind.SUBSCRIBER,
        node="node",
        qos="qos_profile",
        default_qos="parameter_events",
        fixed_name="/parameter_events",
        fixed_type="rcl_interfaces/msg/ParameterEvent",
        returns="rclpy.parameter_event_handler.ParameterEventHandler",
    ),
)

__all__ = ["ROWS"]
