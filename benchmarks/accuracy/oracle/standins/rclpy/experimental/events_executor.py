"""Stand-in for rclpy.experimental.events_executor."""

from rclpy.executors import EventsExecutor

__all__ = ["EventsExecutor"]
