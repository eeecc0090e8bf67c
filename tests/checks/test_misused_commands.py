"""LCH008: commands whose parts run into each other, and descriptions of robots that reach no node."""

from __future__ import annotations

import pytest

from robot_package import SETUP

LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'config', 'robot.urdf.xacro')
    sim = LaunchConfiguration('sim')
    {lines}
    return LaunchDescription([
        DeclareLaunchArgument('sim', default_value='true'),
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters={given}),
    ])
"""
FILES = {"setup.py": SETUP, "config/robot.urdf.xacro": '<robot name="robot"/>'}
GIVEN = "[{'robot_description': ParameterValue(content, value_type=str)}]"


def launch(lines: str, given: str = GIVEN) -> dict[str, str]:
    return FILES | {"launch/robot.launch.py": LAUNCH.format(lines=lines, given=given)}


@pytest.mark.parametrize(
    ("parts", "word"),
    [
        ("'xacro', path", "xacro"),
        ("FindExecutable(name='xacro'), path", "xacro"),
        ("'ros2 run xacro xacro', str(path)", "xacro"),
        ("'cat', PathJoinSubstitution([FindPackageShare('robot'), 'config', 'robot.urdf'])", "cat"),
    ],
)
def test_a_program_that_the_path_runs_into(findings, parts: str, word: str):
    (told,) = findings("LCH008", **launch(f"content = Command([{parts}])"))
    assert told.message == (
        f"Command joins its parts as they are: '{word}' and what is behind it become one word, no program"
    )
    assert told.help == f"write a blank between them: Command(['{word} ', …])"
    assert (told.place.file, told.place.line) == ("launch/robot.launch.py", 15)


def test_an_argument_that_runs_into_the_path(findings):
    (told,) = findings("LCH008", **launch("content = Command(['xacro ', path, 'sim:=', sim])"))
    assert told.message == "Command joins its parts as they are: 'sim:=' becomes the end of the word in front of it"
    assert told.help == "write a blank in front of it: ' sim:='"


@pytest.mark.parametrize(
    "parts",
    [
        "'xacro ', path, ' sim:=', sim",
        "'xacro', ' ', path",
        "FindExecutable(name='xacro'), ' ', path, ' sim:=true'",
        "'xacro --inorder ', path, ' ', 'sim:=', sim",
        # What a value of unknown origin begins with is not known.
        "'xacro', os.environ['MODEL']",
        "'xacro ', path, os.environ['MORE'], 'sim:=true'",
        # No program that is known: the name goes on.
        "'/opt/robot/describe', sim",
    ],
)
def test_parts_with_blanks_between_them(findings, parts: str):
    assert findings("LCH008", **launch(f"content = Command([{parts}])")) == []


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("[content, {'use_sim_time': True}]", 1),
        ("[Command(['xacro ', path])]", 1),
        ("[ParameterFile(path)]", 0),
        ("[{'robot_description': ParameterValue(content, value_type=str)}]", 0),
        # A program that prints the path of a file.
        ("[Command(['find_parameters ', sim])]", 0),
    ],
)
def test_a_command_among_the_parameters(findings, given: str, told: int):
    rows = findings("LCH008", **launch("content = Command(['xacro ', path])", given))
    assert [row.message for row in rows] == [
        "launch_ros takes a Command in parameters= for the path of a parameter file: the node gets no description"
    ] * told


@pytest.mark.parametrize(
    ("lines", "given", "told"),
    [
        ("robot = {'robot_description': 'text'}", "[{'robot_description': robot}]", 1),
        ("robot = {'robot_description': 'text'}", "[robot]", 0),
        ("robot = 'text'", "[{'robot_description': robot}]", 0),
        ("robot = {'limits': {'limits': 1.0}}", "[robot]", 0),
        # Which of the two it is, is not known.
        ("robot = {'robot_description': 'text'}\n    robot = 'text'", "[{'robot_description': robot}]", 0),
    ],
)
def test_a_description_in_a_dict_of_the_same_key(findings, lines: str, given: str, told: int):
    rows = findings("LCH008", **launch(lines, given))
    assert [row.message for row in rows] == [
        "the value of 'robot_description' is a dict with the key 'robot_description': this sets "
        "'robot_description.robot_description', which no node reads"
    ] * told
