"""Stand-in for rclpy.experimental."""

from rclpy.executors import EventsExecutor
from rclpy.node import Node as AsyncNode

__all__ = ["AsyncNode", "EventsExecutor"]
