"""Stand-in for tf2_ros.buffer."""

from tf2_ros import *  # noqa: F403
