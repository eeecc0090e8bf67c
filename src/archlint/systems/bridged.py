"""What a bridge to a simulator has in ROS: its arguments say so, ``/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan``,
or a file that a parameter names; and the topic from which a program that spawns something in it is told what that is,
``-topic robot_description``.

Source: ros_gz_bridge, ``parameter_bridge.cpp``: ``@`` is for both ways, ``[`` from Gazebo to ROS, ``]`` the other way;
a type of a service stands for one that the bridge offers.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.launch.bridges import FILE
from archlint.launch.parameter_sources import ParameterSetting
from archlint.ros.external_nodes import EndKind, ExternalEnd, ExternalQos

if TYPE_CHECKING:
    from archlint.launch.started import Started

BRIDGES = frozenset({("ros_gz_bridge", "parameter_bridge"), ("ros_ign_bridge", "parameter_bridge")})
"""Programs that are told on their command line what to bridge, or in a file."""
_OF_FILES = frozenset({("ros_gz_bridge", "bridge_node"), ("ros_gz_bridge", "ros_gz_bridge::RosGzBridge")})
"""Programs that are told in a file alone, or by parameters."""
_OTHERS = ("bridge_names", "bridges.")
"""How the parameters begin that say more of what is bridged."""
_BRIDGED = re.compile(r"(?P<name>[~/\w]+)@(?P<type>\w+/(?P<kind>msg|srv)/\w+)(?P<way>[@\[\]])?[\w.]*")
_ENDS: dict[str, tuple[EndKind, ...]] = {"[": ("publisher",), "]": ("subscriber",), "@": ("subscriber", "publisher")}
_SPAWNERS = frozenset({("ros_gz_sim", "create"), ("gazebo_ros", "spawn_entity.py")})
_OF_IMAGES = ("ros_gz_image", "image_bridge")
_TOPIC = re.compile(r"--?topic(?:=(?P<name>.+))?")
_LATCHED = ExternalQos("keep_last", 1, "reliable", "transient_local")


def ends_of_arguments(started: Started) -> Iterator[ExternalEnd]:
    """The ends that the command line of a program names which is no bridge of any type: the topic with the description
    of what to spawn, or the images that are bridged."""
    program = (started.package.text, started.executable.text)
    if program in _SPAWNERS:
        words = [*(word or "" for word in started.arguments), ""]
        for word, following in pairwise(words):
            match = _TOPIC.fullmatch(word)
            name = "" if match is None else match["name"] or following
            if name:
                yield ExternalEnd("subscriber", name, "std_msgs/msg/String", _LATCHED)
    elif program == _OF_IMAGES:
        for name in started.arguments:
            if name and not name.startswith("-"):
                yield ExternalEnd("publisher", name, "sensor_msgs/msg/Image")


def is_bridge(started: Started) -> bool:
    """Whether a process is such a program."""
    return (started.package.text, started.executable.text) in BRIDGES | _OF_FILES


def bridged_ends(started: Started) -> Iterator[ExternalEnd]:
    """The ends that a bridge has in ROS."""
    for topic in started.bridged or ():
        if topic.subscribes:
            yield ExternalEnd("subscriber", topic.name, topic.type)
        if topic.publishes:
            yield ExternalEnd("publisher", topic.name, topic.type, conditional=topic.subscribes)
    if (started.package.text, started.executable.text) not in BRIDGES:
        return
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
    """Whether all that a bridge has stands on its command line and in its file, and each word there is known."""
    if not (started.arguments or started.bridged) or not started.knows_all_arguments:
        return False
    settings = [row for row in started.parameters if isinstance(row, ParameterSetting) and row.name is not None]
    words = [*_settings_left_out([*started.arguments, "--ros-args", *started.ros_arguments])]
    of_file = [row for row in settings if row.name == FILE]
    if len(settings) < len(started.parameters) or any((row.name or "").startswith(_OTHERS) for row in settings):
        return False
    names_file = bool(of_file) or len(words) < len(started.arguments) + len(started.ros_arguments)
    if names_file and started.bridged is None:
        return False
    return all(word is not None and _BRIDGED.fullmatch(word) is not None for word in words)


def _settings_left_out(words: Sequence[str | None]) -> Iterator[str | None]:
    """The words of a command line without ``--ros-args -p config_file:=…``."""
    inside = False
    for number, word in enumerate(words):
        before = words[number - 1] if number else None
        if word in ("--ros-args", "--"):
            inside = word == "--ros-args"
        elif not (inside and (word in ("-p", "--param") or (before in ("-p", "--param") and _is_of_file(word)))):
            yield word


def _is_of_file(word: str | None) -> bool:
    return word is not None and word.startswith(f"{FILE}:=")


__all__ = ["bridged_ends", "ends_of_arguments", "is_bridge", "is_told_all"]
