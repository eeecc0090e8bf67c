"""Stand-in for rclpy.action.server."""

from __future__ import annotations

from enum import Enum
from typing import Any

from benchmarks.accuracy.oracle.record import recorder
from benchmarks.accuracy.oracle.unknown import Unknown

from rclpy.entities import Entity
from rclpy.node import record


class GoalResponse(Enum):
    """Whether a goal is taken."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """Whether a goal may be cancelled."""

    REJECT = 1
    ACCEPT = 2


class GoalEvent(Enum):
    """What happens to a goal."""

    EXECUTE = 1
    CANCEL_GOAL = 2
    SUCCEED = 3
    ABORT = 4
    CANCELED = 5


class ServerGoalHandle(Entity):
    """A goal that a server executes."""

    is_active = True
    is_cancel_requested = False

    def publish_feedback(self, feedback: object) -> None:
        """Nobody listens."""

    def succeed(self, response: object = None) -> None:
        """Done."""

    abort = canceled = succeed

    def execute(self, execute_callback: Any = None) -> None:
        """Later."""


def default_handle_accepted_callback(goal_handle: Any) -> None:
    """Execute it."""
    goal_handle.execute()


def default_goal_callback(goal_request: object) -> GoalResponse:
    """Take it."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: object) -> CancelResponse:
    """Do not cancel."""
    return CancelResponse.REJECT


class ActionServer(Entity):
    """Record an action server; its callbacks are called once, later."""

    def __init__(
        self,
        node: Any,
        action_type: Any,
        action_name: Any,
        execute_callback: Any = None,
        *,
        callback_group: Any = None,
        goal_callback: Any = default_goal_callback,
        handle_accepted_callback: Any = default_handle_accepted_callback,
        cancel_callback: Any = default_cancel_callback,
        goal_service_qos_profile: Any = None,
        result_service_qos_profile: Any = None,
        cancel_service_qos_profile: Any = None,
        feedback_pub_qos_profile: Any = None,
        status_pub_qos_profile: Any = None,
        result_timeout: Any = 900,
    ) -> None:
        super().__init__()
        for callback in (goal_callback, handle_accepted_callback, cancel_callback, execute_callback):
            if not callable(callback):
                raise TypeError("Failed to register a callback: not callable")
        self._action_type = action_type
        record(node, "action_server", action_type, action_name, None, execute_callback)
        goal = getattr(action_type, "Goal", Unknown("Goal"))()
        handle = ServerGoalHandle(request=goal, goal_id=Unknown("goal_id"), status=2)
        recorder.tasks.append((goal_callback, (goal,)))
        recorder.tasks.append((handle_accepted_callback, (handle,)))
        recorder.tasks.append((execute_callback, (handle,)))

    def _register(self, callback: Any) -> None:
        return None

    register_goal_callback = register_cancel_callback = register_handle_accepted_callback = _register
    register_execute_callback = _register
