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
PYTHON: Mapping[str, str] = {"focal": "3.8", "jammy": "3.10", "noble": "3.12", "resolute": "3.14"}
"""The version of Python that each release of Ubuntu has."""
