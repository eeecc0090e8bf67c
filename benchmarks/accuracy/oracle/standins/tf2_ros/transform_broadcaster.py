"""Stand-in for tf2_ros.transform_broadcaster."""

from tf2_ros import *  # noqa: F403
