"""The ROS distributions."""

from __future__ import annotations

from collections.abc import Mapping

DISTROS = ("humble", "jazzy", "kilted", "lyrical", "rolling")
"""Those that are supported, oldest first."""
UBUNTU: Mapping[str, str] = {
    "foxy": "focal",
    "galactic": "focal",
    "humble": "jammy",
    "iron": "jammy",
    "jazzy": "noble",
    "kilted": "noble",
    "lyrical": "resolute",
    "rolling": "resolute",
}
"""The release of Ubuntu that each is built for, by REP 2000."""
