"""Rows of executors and of what spins."""

from __future__ import annotations

from archlint.libraries.tables.api import Api
from archlint.model import ExecutorKind, Role

ROWS = (
    Api("rclpy.spin", "node executor", effect="spin", watched=True),
    Api("rclpy.spin_once", "node * executor timeout_sec", effect="spin", watched=True),
    Api(
        "rclpy.spin_until_future_complete",
        "node future executor timeout_sec",
        effect="spin",
        watched=True,
    ),
    Api(
        "rclpy.executors.SingleThreadedExecutor", "* context", effect="executor", executor=ExecutorKind.SINGLE_THREADED
    ),
    Api(
        "rclpy.executors.MultiThreadedExecutor",
        "num_threads * context",
        effect="executor",
        executor=ExecutorKind.MULTI_THREADED,
    ),
    Api(
        "rclpy.experimental.events_executor.EventsExecutor",
        "* context",
        effect="executor",
        executor=ExecutorKind.EVENTS,
    ),
    Api("rclpy.executors.Executor", "* context", effect="executor", executor=ExecutorKind.UNKNOWN),
    Api("rclpy.executors.Executor.add_node", "node", effect="add_node"),
    Api("rclpy.executors.Executor.remove_node", "node", effect="remove_node"),
    Api("rclpy.executors.Executor.spin", effect="executor_spin", watched=True),
    Api("rclpy.executors.Executor.spin_once", "timeout_sec", effect="executor_spin", watched=True),
    Api(
        "rclpy.executors.Executor.spin_until_future_complete",
        "future timeout_sec",
        effect="executor_spin",
        watched=True,
    ),
    Api(
        "rclpy.executors.Executor.spin_once_until_future_complete",
        "future timeout_sec",
        effect="executor_spin",
        watched=True,
    ),
    Api(
        "rclpy.executors.Executor.create_task",
        "callback",
        effect="callbacks",
        callbacks=(("callback", Role.TASK),),
    ),
)

__all__ = ["ROWS"]
