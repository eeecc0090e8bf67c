"""What the arguments of a bridge to a simulator say: ``/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan``.

Source: ros_gz_bridge, ``parameter_bridge.cpp``: ``@`` is for both ways, ``[`` from Gazebo to ROS, ``]`` the other way;
a type of a service stands for one that the bridge offers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.parameter_sources import ParameterSetting
from archlint.ros.external_nodes import EndKind, ExternalEnd

if TYPE_CHECKING:
    from archlint.launch.started import Started

BRIDGES = frozenset(
    {("ros_gz_bridge", "parameter_bridge"), ("ros_ign_bridge", "parameter_bridge"), ("ros_gz_bridge", "ros_gz_bridge")}
)
"""Programs that are told on their command line what to bridge."""

_FILE = "config_file"
"""The parameter that names a file with more of what is bridged."""
_BRIDGED = re.compile(r"(?P<name>[~/\w]+)@(?P<type>\w+/(?P<kind>msg|srv)/\w+)(?P<way>[@\[\]])?[\w.]*")
_ENDS: dict[str, tuple[EndKind, ...]] = {"[": ("publisher",), "]": ("subscriber",), "@": ("subscriber", "publisher")}


def bridged_ends(started: Started) -> Iterator[ExternalEnd]:
    """The ends that a bridge has in ROS."""
    for word in started.arguments:
        match = None if word is None else _BRIDGED.fullmatch(word)
        if match is None:
            continue
        if match["kind"] == "srv":
            yield ExternalEnd("service", match["name"], match["type"])
            continue
        way = match["way"] or "@"
        for kind in _ENDS[way]:
            # Of both ways, nobody says which one is used.
            yield ExternalEnd(kind, match["name"], match["type"], conditional=way == "@" and kind == "publisher")


def is_told_all(started: Started) -> bool:
    """Whether all that a bridge has stands on its command line, and each word there is known."""
    if not started.arguments or not started.knows_all_arguments or started.ros_arguments:
        return False
    if not all(isinstance(row, ParameterSetting) and row.name not in (None, _FILE) for row in started.parameters):
        return False
    return all(word is not None and _BRIDGED.fullmatch(word) is not None for word in started.arguments)


__all__ = ["BRIDGES", "bridged_ends", "is_told_all"]
