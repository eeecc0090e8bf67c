"""Stand-in for tf2_py: the exceptions."""

from tf2_ros import *  # noqa: F403
