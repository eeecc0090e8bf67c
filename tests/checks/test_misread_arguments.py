"""LCH003: launch arguments that a file reads by almost the name under which it declares them."""

from __future__ import annotations

import pytest

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    value = {read}
    return LaunchDescription([
        DeclareLaunchArgument('{declared}', default_value='a'),
        Node(package='robot', executable='talker', arguments=[value{more}]),
    ])
"""


def _files(read: str, declared: str, more: str = "", **others: str) -> dict[str, str]:
    return {"launch/it.launch.py": LAUNCH.format(read=read, declared=declared, more=more), **others}


@pytest.mark.parametrize(
    ("read", "declared"),
    [
        ("use_tim_time", "use_sim_time"),
        ("slam_toolbox_mode", "slam_mode"),
        ("robot_config_directory", "robot_configuration_directory"),
    ],
)
def test_an_argument_that_is_read_by_another_name(findings, read: str, declared: str):
    files = _files(f"LaunchConfiguration('{read}', default='b')", declared)
    (told,) = findings("LCH003", **files)
    assert told.message == f"no launch argument '{read}' is declared, and nothing reads '{declared}', which is"
    assert (told.place.line, told.related[0].place.line) == (7, 9)
    assert findings("LCH011", **files) == []


@pytest.mark.parametrize(
    ("declared", "more", "help"),
    [
        ("arm_yaml", "", "read 'arm_yaml', or declare 'base_yaml'"),
        ("arm_yaml", ", LaunchConfiguration('arm_yaml')", "declare it before it is read"),
        ("speed", "", "declare it before it is read"),
    ],
    ids=["unread", "read", "of another kind"],
)
def test_an_undeclared_argument_where_the_file_declares_one_that_nothing_reads(findings, declared, more, help):
    """A line that was copied from the launch file of another node still has the name of its file."""
    (told,) = findings("LCH003", **_files("LaunchConfiguration('base_yaml')", declared, more))
    assert told.message.startswith("no launch argument 'base_yaml' is declared, and nothing ")
    assert (told.help or "").startswith(help)


@pytest.mark.parametrize(
    "files",
    [
        _files("LaunchConfiguration('mode', default='b')", "mode"),
        _files("LaunchConfiguration('mode', default='b')", "speed"),
        _files("LaunchConfiguration('left_mode', default='b')", "right_mode"),
        _files(
            "LaunchConfiguration('use_tim_time', default='b')", "use_sim_time", ", LaunchConfiguration('use_sim_time')"
        ),
        _files("LaunchConfiguration('use_tim_time', default='b')", "use_sim_time", ", {'use_sim_time': 'x'}"),
        _files(
            "LaunchConfiguration('use_tim_time', default='b')",
            "use_sim_time",
            **{"launch/other.launch.xml": '<launch><arg name="use_tim_time" default="c"/></launch>'},
        ),
    ],
    ids=["the same", "nothing alike", "two names", "read, too", "said, too", "of another file"],
)
def test_an_argument_that_may_come_from_elsewhere(findings, files: dict[str, str]):
    assert [told for told in findings("LCH003", **files) if "which is" in told.message] == []
