"""Stand-in for nav2_simple_commander.robot_navigator; what its node creates by itself is not recorded."""

from __future__ import annotations

from enum import Enum
from typing import Any

from benchmarks.accuracy.oracle.unknown import Unknown
from rclpy.node import Node


class TaskResult(Enum):
    """How a task ended."""

    UNKNOWN = 0
    SUCCEEDED = 1
    CANCELED = 2
    FAILED = 3


class BasicNavigator(Node):
    """The node to derive from; its tasks are done at once."""

    def __init__(self, node_name: str = "basic_navigator", namespace: str = "") -> None:
        super().__init__(node_name, namespace=namespace)

    def isTaskComplete(self, *_: object, **__: object) -> bool:
        """Done."""
        return True

    def getResult(self, *_: object) -> TaskResult:
        """Well."""
        return TaskResult.SUCCEEDED

    def _task(self, *_: object, **__: object) -> Any:
        return Unknown("task")

    goToPose = goThroughPoses = followWaypoints = followPath = spin = backup = getPath = _task
    getFeedback = cancelTask = setInitialPose = waitUntilNav2Active = lifecycleStartup = _task
    lifecycleShutdown = changeMap = clearAllCostmaps = getGlobalCostmap = getLocalCostmap = _task
    clearGlobalCostmap = clearLocalCostmap = smoothPath = assistedTeleop = getPathThroughPoses = _task
    info = warn = error = debug = _task
