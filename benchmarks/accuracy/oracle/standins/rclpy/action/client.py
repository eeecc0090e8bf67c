"""Stand-in for rclpy.action.client: goals are accepted and have results at once."""

from __future__ import annotations

from typing import Any

from benchmarks.accuracy.oracle.later import finished
from benchmarks.accuracy.oracle.record import recorder
from benchmarks.accuracy.oracle.sandbox import waited
from benchmarks.accuracy.oracle.unknown import Unknown

from rclpy.entities import Entity
from rclpy.node import record
from rclpy.task import Future


class ClientGoalHandle:
    """A goal that was accepted."""

    accepted = True

    def __init__(self, action_type: Any = None) -> None:
        self._action_type = action_type
        self.goal_id = Unknown("goal_id")
        self.stamp = Unknown("stamp")
        self.status = 4

    def _response(self) -> Any:
        response = Unknown("result response")
        response.status = 4
        response.result = getattr(self._action_type, "Result", Unknown("Result"))()
        return response

    def get_result(self) -> Any:
        """A result."""
        return self._response()

    def get_result_async(self) -> Future:
        """A result."""
        return finished(self._response())

    def cancel_goal(self) -> Any:
        """Cancelled."""
        return Unknown("cancel response")

    def cancel_goal_async(self) -> Future:
        """Cancelled."""
        return finished(Unknown("cancel response"))


class ActionClient(Entity):
    """Record an action client."""

    def __init__(
        self,
        node: Any,
        action_type: Any,
        action_name: Any,
        *,
        callback_group: Any = None,
        goal_service_qos_profile: Any = None,
        result_service_qos_profile: Any = None,
        cancel_service_qos_profile: Any = None,
        feedback_sub_qos_profile: Any = None,
        status_sub_qos_profile: Any = None,
        enable_feedback_msg_optimization: bool = False,
    ) -> None:
        super().__init__()
        self._node, self._action_type, self._action_name = node, action_type, action_name
        record(node, "action_client", action_type, action_name, None)

    def server_is_ready(self) -> bool:
        """The server is there."""
        return True

    def wait_for_server(self, timeout_sec: object = None) -> bool:
        """The server is there."""
        waited(2)
        return True

    def send_goal(self, goal: object, **_: object) -> Any:
        """A result."""
        return ClientGoalHandle(self._action_type).get_result()

    def send_goal_async(self, goal: object, feedback_callback: Any = None, goal_uuid: object = None) -> Future:
        """Accepted; the feedback callback is called once, later."""
        if feedback_callback is not None:
            recorder.tasks.append((feedback_callback, (Unknown("feedback"),)))
        return finished(ClientGoalHandle(self._action_type))
