"""Stand-in for tf2_ros.buffer_client."""

from tf2_ros import *  # noqa: F403
