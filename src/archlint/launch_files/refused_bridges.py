"""Arguments of a bridge between ROS and Gazebo that it does not understand.

Source: ros_gz_bridge, ``parameter_bridge.cpp``: without an ``@`` the program prints its usage and ends; where it has no
factory for a pair of types, it says so and goes on with the next argument.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.ros.bridged_types import pairs
from archlint.suggestions import nearest

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.place import Place
    from archlint.systems.model import System

_PROGRAMS = frozenset({("ros_gz_bridge", "parameter_bridge"), ("ros_ign_bridge", "parameter_bridge")})
_ARGUMENT = re.compile(r"(?P<topic>[^@\s]+)@(?P<ros>[^@\[\]\s]+)(?P<way>[@\[\]])(?P<gz>[^@\[\]\s]+)(?:@[^@\s]+)?")
_OF_GAZEBO = re.compile(r"(?:gz|ignition)\.msgs\.(?P<name>\w+)")
_OF_ROS = re.compile(r"\w+/msg/\w+")
_WITHOUT_MSG = re.compile(r"(?P<package>\w+)/(?P<name>\w+)")


@dataclass(frozen=True)
class RefusedBridge:
    """An ``argument`` with what is wrong in it, and what is to be written instead, where that is known."""

    place: Place
    argument: str
    wrong: str
    instead: str = ""
    ends: bool = False
    """Whether the whole program ends, and not only this bridge is missing."""
    help: str = ""
    """What is to be done where nothing stands for the argument as a whole."""


def refused_bridges(system: System) -> Iterator[RefusedBridge]:
    """All such arguments of what a launch file starts."""
    for started in system.launched.started if system.launched is not None else ():
        if (started.package.text, started.executable.text) in _PROGRAMS:
            for word in _own_words(started):
                refused = _refused(started.places.get("arguments", started.place), word)
                if refused is not None:
                    yield refused


def _own_words(started: Started) -> Iterator[str]:
    """The words of its command line that are for the program, and known."""
    for_ros = False
    for word in started.arguments:
        if word in ("--ros-args", "--"):
            for_ros = word == "--ros-args"
        elif word and not for_ros and not word.startswith("-") and ":=" not in word:
            yield word


def _refused(place: Place, word: str) -> RefusedBridge | None:
    if "@" not in word:
        return RefusedBridge(place, word, "it names no types", ends=True)
    match = _ARGUMENT.fullmatch(word)
    if match is None:
        return None
    ros, gz = match["ros"], match["gz"]
    of_gazebo = _OF_GAZEBO.fullmatch(gz)
    if _OF_GAZEBO.fullmatch(ros) and _OF_ROS.fullmatch(gz):
        instead = word.replace(ros, "\0").replace(gz, ros).replace("\0", gz)
        return RefusedBridge(place, word, "the type of ROS comes first, then that of Gazebo", instead)
    plain = _WITHOUT_MSG.fullmatch(ros)
    if plain is not None and of_gazebo is not None:
        right = f"{plain['package']}/msg/{plain['name']}"
        if right in pairs():
            return RefusedBridge(place, word, f"the bridge knows no type '{ros}'", word.replace(ros, right))
    if of_gazebo is None or not _OF_ROS.fullmatch(ros):
        return None
    return _of_no_pair(place, word, ros, of_gazebo["name"])


def _of_no_pair(place: Place, word: str, ros: str, name: str) -> RefusedBridge | None:
    """Types that the bridge does not know as each other: one that it may know since is left alone."""
    known = pairs()
    if ros not in known:
        near = nearest(ros, [other for other in known if name in known[other]])
        wrong = f"the bridge knows no type '{ros}'"
        return None if near is None else RefusedBridge(place, word, wrong, word.replace(ros, near))
    if name in known[ros]:
        return None
    every = {other for others in known.values() for other in others}
    near = nearest(name, known[ros])
    if name not in every and near is None:
        return None
    right = near or min(known[ros])
    wrong = f"the bridge does not know '{ros}' and '{name}' as each other"
    return RefusedBridge(place, word, wrong, re.sub(rf"\.{name}\b", f".{right}", word))


def refused_pair(place: Place, ros: str, gz: str) -> RefusedBridge | None:
    """Two types, each in a line of its own, that the bridge does not know as each other."""
    of_gazebo = _OF_GAZEBO.fullmatch(gz)
    plain = _WITHOUT_MSG.fullmatch(ros)
    if plain is not None and of_gazebo is not None:
        right = f"{plain['package']}/msg/{plain['name']}"
        known = right in pairs()
        return RefusedBridge(place, ros, f"the bridge knows no type '{ros}'", right) if known else None
    if of_gazebo is None or not _OF_ROS.fullmatch(ros):
        return None
    refused = _of_no_pair(place, f"{ros}@{gz}", ros, of_gazebo["name"])
    if refused is None:
        return None
    own, _, other = refused.instead.partition("@")
    return replace(refused, instead=own if own != ros else other)


__all__ = ["RefusedBridge", "refused_bridges", "refused_pair"]
