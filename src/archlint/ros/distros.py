"""The ROS distributions."""

from __future__ import annotations

DISTROS = ("humble", "jazzy", "kilted", "lyrical", "rolling")
"""Those that are supported, oldest first."""
