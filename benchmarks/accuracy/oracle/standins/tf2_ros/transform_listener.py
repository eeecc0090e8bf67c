"""Stand-in for tf2_ros.transform_listener."""

from tf2_ros import *  # noqa: F403
