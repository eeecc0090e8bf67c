"""Stand-in for rclpy.lifecycle.node."""

from rclpy.lifecycle import *  # noqa: F403
