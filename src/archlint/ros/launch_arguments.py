"""The arguments that launch files of well-known packages take, which are included without being in the workspace.

The table is what ``scripts/generate_launch_arguments`` reads in their sources, all distributions since humble together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import msgspec

FILE = Path(__file__).with_suffix(".json")


class LaunchArguments(msgspec.Struct, frozen=True):
    """The table: by package and name of the launch file what it takes, None where that is not known."""

    packages: Mapping[str, Mapping[str, Sequence[str] | None]]


@cache
def well_known() -> LaunchArguments:
    """Read the table, once."""
    return msgspec.json.decode(FILE.read_bytes(), type=LaunchArguments)


__all__ = ["FILE", "LaunchArguments", "well_known"]
