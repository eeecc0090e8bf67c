"""Stand-in for rclpy.lifecycle.publisher."""

from rclpy.lifecycle import *  # noqa: F403
