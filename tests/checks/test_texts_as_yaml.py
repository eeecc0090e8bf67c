"""LCH008: descriptions of robots that launch_ros reads as YAML."""

from __future__ import annotations

import pytest

from robot_package import SETUP

LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import Command, FindExecutable
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'robot.urdf.xacro')
    {lines}
    return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher', {given})])
"""
XACRO = """<?xml version="1.0"?>
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- {} -->
  <link name="base"/>
</robot>
"""
COMMAND = "Command(['xacro ', path])"
GIVEN = "parameters=[{'robot_description': content}]"


def files(lines: str, given: str = GIVEN, comment: str = "Frames: see REP 105") -> dict[str, str]:
    launch = LAUNCH.format(lines=lines, given=given)
    return {"setup.py": SETUP, "launch/robot.launch.py": launch, "config/robot.urdf.xacro": XACRO.format(comment)}


@pytest.mark.parametrize(
    ("lines", "given"),
    [
        ("pass", f"parameters=[{{'robot_description': {COMMAND}}}]"),
        (f"content = {COMMAND}", GIVEN),
        (f"robot = {{'robot_description': {COMMAND}}}", "parameters=[robot]"),
        ("content = Command([FindExecutable(name='xacro'), ' ', path])", GIVEN),
        ("content = Command(['cat ', path])", GIVEN),
    ],
)
def test_a_description_that_is_no_yaml(findings, lines, given):
    (told,) = findings("LCH008", **files(lines, given))
    assert told.message == (
        "launch_ros reads the value of 'robot_description' as YAML, and stops at the ':' in a comment of "
        "robot.urdf.xacro"
    )
    assert told.help == "write ParameterValue(Command(…), value_type=str), which takes the text as it is"
    assert told.place.file == "launch/robot.launch.py"
    assert [(row.place.file, row.place.line) for row in told.related] == [("config/robot.urdf.xacro", 3)]


@pytest.mark.parametrize(
    ("lines", "given", "comment"),
    [
        (f"content = ParameterValue({COMMAND}, value_type=str)", GIVEN, "Frames: see REP 105"),
        (f"content = {COMMAND}", GIVEN.replace("content", "ParameterValue(content, value_type=str)"), "Frames: two"),
        (f"content = {COMMAND}", GIVEN, "Frames, see REP 105"),
        (f"content = {COMMAND}", "name='it'", "Frames: see REP 105"),
        ("content = Command(['strip_comments ', path])", GIVEN, "Frames: see REP 105"),
        (f"content = {COMMAND}\n    content = str(content)", GIVEN, "Frames: see REP 105"),
    ],
)
def test_a_description_that_launch_takes_or_may(findings, lines, given, comment):
    assert findings("LCH008", **files(lines, given, comment)) == []
