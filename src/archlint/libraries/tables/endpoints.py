"""Rows of what creates on a node: publishers, subscriptions, services, clients, actions, timers."""

from __future__ import annotations

from archlint import model
from archlint.libraries.tables.api import Api
from archlint.model import Role

_ACTION_QOS = "goal_service_qos_profile result_service_qos_profile cancel_service_qos_profile"

ROWS = (
    Api(
        "rclpy.node.Node.create_publisher",
        "msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options publisher_class",
        effect="endpoint",
        kind=model.EntityKind.PUBLISHER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        returns="rclpy.publisher.Publisher",
    ),
    Api(
        "rclpy.lifecycle.node.LifecycleNode.create_lifecycle_publisher",
        "msg_type topic qos_profile * callback_group event_callbacks qos_overriding_options publisher_class",
        effect="endpoint",
        kind=model.EntityKind.PUBLISHER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        returns="rclpy.publisher.Publisher",
    ),
    Api(
        "rclpy.node.Node.create_subscription",
        "msg_type topic callback qos_profile * callback_group event_callbacks qos_overriding_options raw "
        "content_filter_options acceptable_buffer_backends",
        effect="endpoint",
        kind=model.EntityKind.SUBSCRIBER,
        type="msg_type",
        name="topic",
        qos="qos_profile",
        group="callback_group",
        callbacks=(("callback", Role.SUBSCRIPTION),),
        returns="rclpy.subscription.Subscription",
    ),
    Api(
        "rclpy.node.Node.create_client",
        "srv_type srv_name * qos_profile callback_group",
        effect="endpoint",
        kind=model.EntityKind.CLIENT,
        type="srv_type",
        name="srv_name",
        qos="qos_profile",
        group="callback_group",
        default_qos="services_default",
        returns="rclpy.client.Client",
    ),
    Api(
        "rclpy.node.Node.create_service",
        "srv_type srv_name callback * qos_profile callback_group",
        effect="endpoint",
        kind=model.EntityKind.SERVICE,
        type="srv_type",
        name="srv_name",
        qos="qos_profile",
        group="callback_group",
        default_qos="services_default",
        callbacks=(("callback", Role.SERVICE),),
        returns="rclpy.service.Service",
    ),
    Api(
        "rclpy.action.server.ActionServer",
        "node action_type action_name execute_callback * callback_group goal_callback "
        f"handle_accepted_callback cancel_callback {_ACTION_QOS} feedback_pub_qos_profile "
        "status_pub_qos_profile result_timeout",
        effect="endpoint",
        kind=model.EntityKind.ACTION_SERVER,
        node="node",
        type="action_type",
        name="action_name",
        qos="goal_service_qos_profile",
        group="callback_group",
        default_qos="services_default",
        callbacks=(
            ("execute_callback", Role.EXECUTE),
            ("goal_callback", Role.GOAL),
            ("handle_accepted_callback", Role.ACCEPTED),
            ("cancel_callback", Role.CANCEL),
        ),
        returns="rclpy.action.server.ActionServer",
    ),
    Api(
        "rclpy.action.client.ActionClient",
        f"node action_type action_name * callback_group {_ACTION_QOS} feedback_sub_qos_profile "
        "status_sub_qos_profile enable_feedback_msg_optimization",
        effect="endpoint",
        kind=model.EntityKind.ACTION_CLIENT,
        node="node",
        type="action_type",
        name="action_name",
        qos="goal_service_qos_profile",
        group="callback_group",
        default_qos="services_default",
        returns="rclpy.action.client.ActionClient",
    ),
    Api(
        "rclpy.node.Node.create_timer",
        "timer_period_sec callback callback_group clock autostart",
        effect="timer",
        kind=model.EntityKind.TIMER,
        group="callback_group",
        callbacks=(("callback", Role.TIMER),),
        returns="rclpy.timer.Timer",
    ),
    Api("rclpy.node.Node.create_rate", "frequency clock", effect="rate", returns="rclpy.timer.Rate"),
    Api(
        "rclpy.node.Node.create_guard_condition",
        "callback callback_group",
        effect="callbacks",
        group="callback_group",
        callbacks=(("callback", Role.GUARD),),
    ),
)

__all__ = ["ROWS"]
