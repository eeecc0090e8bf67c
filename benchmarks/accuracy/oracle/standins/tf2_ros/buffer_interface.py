"""Stand-in for tf2_ros.buffer_interface."""

from tf2_ros import *  # noqa: F403
