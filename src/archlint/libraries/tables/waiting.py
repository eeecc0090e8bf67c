"""Rows of what waits for an answer, a message or a transform, and of what answers: clients, goals, futures."""

from __future__ import annotations

from archlint import model
from archlint.libraries.tables.api import Api
from archlint.model import Role

_FULL = "target_frame target_time source_frame source_time fixed_frame timeout"

ROWS = (
    # ---- clients
    Api("rclpy.client.Client.call", "request timeout_sec", effect="wait_answer", watched=True),
    Api("rclpy.client.Client.call_async", "request", effect="call_async", watched=True),
    Api("rclpy.client.Client.wait_for_service", "timeout_sec", watched=True),
    Api("rclpy.client.Client.service_is_ready", watched=True),
    Api("rclpy.action.client.ActionClient.wait_for_server", "timeout_sec", watched=True),
    Api("rclpy.action.client.ActionClient.server_is_ready", watched=True),
    Api(
        "rclpy.action.client.ActionClient.send_goal",
        "goal feedback_callback goal_uuid",
        effect="wait_answer",
        callbacks=(("feedback_callback", Role.FEEDBACK),),
        watched=True,
    ),
    Api(
        "rclpy.action.client.ActionClient.send_goal_async",
        "goal feedback_callback goal_uuid",
        effect="call_async",
        callbacks=(("feedback_callback", Role.FEEDBACK),),
        watched=True,
    ),
    Api("rclpy.action.client.ClientGoalHandle.get_result", effect="wait_answer", watched=True),
    Api("rclpy.action.client.ClientGoalHandle.get_result_async", effect="call_async", watched=True),
    Api("rclpy.action.client.ClientGoalHandle.cancel_goal", effect="wait_answer", watched=True),
    Api("rclpy.action.client.ClientGoalHandle.cancel_goal_async", effect="call_async", watched=True),
    Api("rclpy.action.server.ServerGoalHandle.publish_feedback", "feedback", watched=True),
    Api("rclpy.action.server.ServerGoalHandle.succeed", "response", watched=True),
    Api("rclpy.action.server.ServerGoalHandle.abort", "response", watched=True),
    Api("rclpy.action.server.ServerGoalHandle.canceled", "response", watched=True),
    Api("rclpy.task.Future.result", effect="future_result", watched=True),
    Api("rclpy.task.Future.done", watched=True),
    Api("rclpy.task.Future.set_result", "result", watched=True),
    Api("rclpy.task.Future.set_exception", "exception", watched=True),
    Api("rclpy.task.Future.cancel", watched=True),
    Api("rclpy.publisher.Publisher.publish", "msg", watched=True),
    # ---- waiting and sleeping
    Api(
        "rclpy.wait_for_message.wait_for_message",
        "msg_type node topic * qos_profile time_to_wait",
        effect="endpoint",
        kind=model.EntityKind.SUBSCRIBER,
        node="node",
        type="msg_type",
        name="topic",
        qos="qos_profile",
        default_qos="1",
        watched=True,
    ),
    Api("rclpy.timer.Rate.sleep", watched=True),
    Api("rclpy.node.Node.wait_for_node", "fully_qualified_node_name timeout", watched=True),
    *(
        Api(f"tf2_ros.buffer.Buffer.{method}", signature, watched=True)
        for method, signature in (
            ("lookup_transform", "target_frame source_frame time timeout"),
            ("lookup_transform_async", "target_frame source_frame time"),
            ("lookup_transform_full", _FULL),
            ("wait_for_transform_async", "target_frame source_frame time"),
            ("can_transform", "target_frame source_frame time timeout return_debug_tuple"),
            ("can_transform_full", f"{_FULL} return_debug_tuple"),
            ("transform", "object_stamped target_frame timeout new_type"),
        )
    ),
    *(  # C++'s buffer, which other names are for: tf2_ros/buffer.h
        Api(f"tf2_ros.buffer_h.Buffer.{method}", "target_frame source_frame time timeout", watched=True)
        for method in ("lookupTransform", "canTransform")
    ),
)

__all__ = ["ROWS"]
