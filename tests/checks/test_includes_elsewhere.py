"""LCH003 and LCH011 with launch files from elsewhere of which the arguments are known."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import node

LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def include(package, file, **arguments):
    path = get_package_share_directory(package) + '/launch/' + file
    return IncludeLaunchDescription(PythonLaunchDescriptionSource(path), launch_arguments=arguments.items())


def generate_launch_description():
    return LaunchDescription([
        {},
    ])
"""


def _told(findings, code: str, *actions: str, **files: str):
    return findings(code, node(), **{"launch/a.launch.py": LAUNCH.format(",\n        ".join(actions))}, **files)


@pytest.mark.parametrize(
    ("include", "message", "help"),
    [
        (
            "include('slam_toolbox', 'online_async_launch.py', slam_param_file='a.yaml')",
            "online_async_launch.py of slam_toolbox takes no launch argument 'slam_param_file' since Humble; did you "
            "mean 'slam_params_file'?",
            "write 'slam_params_file': the value has no effect",
        ),
        (
            "include('slam_toolbox', 'online_async_launch.py', params_file='a.yaml')",
            "online_async_launch.py of slam_toolbox takes no launch argument 'params_file' since Humble; did you "
            "mean 'slam_params_file'?",
            "write 'slam_params_file': the value has no effect",
        ),
        (
            "include('slam_toolbox', 'online_async_launch.py', maps='a.yaml')",
            "online_async_launch.py of slam_toolbox takes no launch argument 'maps' since Humble",
            "the value has no effect: correct the name or remove it; ros2 launch slam_toolbox online_async_launch.py "
            "--show-args lists those that it takes",
        ),
        (
            "include('gazebo_ros', 'gzserver.launch.py', world='a.world', headless='true', x_pose='1.0')",
            "gzserver.launch.py of gazebo_ros takes none of these launch arguments since Humble: 'headless', 'x_pose'",
            "the value has no effect: correct the name or remove it; ros2 launch gazebo_ros gzserver.launch.py "
            "--show-args lists those that it takes",
        ),
    ],
)
def test_an_argument_that_the_file_does_not_take(findings, include: str, message: str, help: str):
    (told,) = _told(findings, "LCH003", include)
    assert (told.message, told.help, told.severity) == (message, help, Severity.WARNING)


@pytest.mark.parametrize(
    "actions",
    [
        ("include('slam_toolbox', 'online_async_launch.py', slam_params_file='a.yaml')",),
        ("include('nav2_bringup', 'bringup_launch.py', slam_params_file='a.yaml')",),  # for a file that it includes
        ("include('slam_toolbox', 'my_launch.py', params_file='a.yaml')",),
        ("include('elsewhere', 'online_async_launch.py', params_file='a.yaml')",),
        # Includes are not scoped: another file may read it.
        (
            "include('slam_toolbox', 'online_async_launch.py', params_file='a.yaml')",
            "include('nav2_bringup', 'navigation_launch.py')",
        ),
        ("include('slam_toolbox', 'online_async_launch.py', params='a.yaml')", "include('elsewhere', 'a.launch.py')"),
        (
            "include('slam_toolbox', 'online_async_launch.py', speed='1.0')",
            "Node(package='robot', executable='talker', arguments=[LaunchConfiguration('speed')])",
        ),
    ],
)
def test_an_argument_that_somebody_takes(findings, actions: tuple[str, ...]):
    assert _told(findings, "LCH003", *actions) == []


def test_a_file_in_front_of_one_that_takes_other_arguments(findings):
    slam = "include('slam_toolbox', 'online_async_launch.py', params_file='a.yaml')"
    (told,) = _told(findings, "LCH003", slam, "include('gazebo_ros', 'gzclient.launch.py')")
    assert "'params_file'" in told.message


def test_parameter_files_and_older_distributions_may_read_it(findings):
    slam = "include('nav2_bringup', 'navigation_launch.py', robot='left')"
    assert len(_told(findings, "LCH003", slam)) == 1
    assert _told(findings, "LCH003", slam, **{"config/nav2.yaml": "amcl: {frame: $(var robot)/odom}\n"}) == []
    assert _told(findings, "LCH003", slam, **{"config/nav2.yaml": "", "README.md": "For ROS 2 Foxy."}) == []


def test_use_sim_time_is_handed_to_all_by_habit(findings):
    (told,) = _told(findings, "LCH003", "include('gazebo_ros', 'gzserver.launch.py', use_sim_time='true')")
    assert told.severity == Severity.INFO


@pytest.mark.parametrize(
    ("name", "includes", "times"),
    [
        ("with_gui", ("include('gazebo_ros', 'gzserver.launch.py')",), 1),
        ("with_gui", ("include('gazebo_ros', 'gzserver.launch.py')", "include('gazebo_ros', 'gzclient.launch.py')"), 1),
        ("verbose", ("include('gazebo_ros', 'gzserver.launch.py')",), 0),
        ("with_gui", ("include('elsewhere', 'gzserver.launch.py')",), 0),
        ("with_gui", ("include('gazebo_ros', 'gzserver.launch.py')", "include('elsewhere', 'a.launch.py')"), 0),
    ],
)
def test_an_argument_that_nothing_reads(findings, name: str, includes: tuple[str, ...], times: int):
    told = _told(findings, "LCH011", f"DeclareLaunchArgument('{name}', default_value='true')", *includes)
    assert len(told) == times


SWITCH = "DeclareLaunchArgument('slam_params', default_value={})"


@pytest.mark.parametrize(("default", "near"), [("'True'", False), ("'slam.yaml'", True)])
def test_a_switch_is_meant_for_no_argument_with_words_behind_its_name(findings, default: str, near: bool):
    include = "include('slam_toolbox', 'online_async_launch.py', slam_params=LaunchConfiguration('slam_params'))"
    (told,) = _told(findings, "LCH003", SWITCH.format(default), include)
    assert ("write 'slam_params_file'" in told.help) is near
