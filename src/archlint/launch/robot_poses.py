"""``ParseMultiRobotPose`` of nav2_common: the robots that the words ``robots:="name={x: 1.0}; …"`` name.

Source: ``nav2_common/launch/parse_multirobot_pose.py`` of ros-navigation/navigation2 (branches jazzy and main).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Instance, Unknown, Value
from archlint.launch import read_files
from archlint.launch.objects import known_text
from archlint.syntax.safe_yaml import YamlError, YamlReader

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

_POSE = ("x", "y", "z", "roll", "pitch", "yaw")


def _poses(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``ParseMultiRobotPose('robots').value()``: a pose for each robot."""
    given = receiver.arguments if isinstance(receiver, Instance) else {}
    name = known_text(given.get("target_argument", given.get("0")))
    words = [known_text(word) for word in run.words]
    if name is None or run.argv is None:
        return Unknown("what the command line says")
    texts = [word.removeprefix(f"{name}:=") for word in words if word is not None and word.startswith(f"{name}:=")]
    try:
        return read_files.value_of(run, dict(_pose(robot) for robot in _robots(texts[0] if texts else "")))
    except (YamlError, RecursionError):
        return Unknown("poses that cannot be read")


def _robots(text: str) -> list[tuple[str, str]]:
    pairs = [robot.strip().split("=") for robot in text.split(";")]
    return [(pair[0].strip(), pair[1].strip()) for pair in pairs if len(pair) == 2]


def _pose(robot: tuple[str, str]) -> tuple[str, dict[str, object]]:
    reader = YamlReader(robot[1])
    given = None if reader.root is None else reader.value(reader.root)
    pose = given if isinstance(given, dict) else {}
    return robot[0], {**pose, **{key: pose.get(key, 0.0) for key in _POSE}}


METHODS = {"nav2_common.launch.ParseMultiRobotPose.value": _poses}

__all__ = ["METHODS"]
