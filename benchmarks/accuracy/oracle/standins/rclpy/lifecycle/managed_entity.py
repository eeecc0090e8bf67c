"""Stand-in for rclpy.lifecycle.managed_entity."""

from rclpy.lifecycle import *  # noqa: F403
