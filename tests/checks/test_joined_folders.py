"""LCH004: paths and search paths that a launch file joins without a slash or a colon."""

from __future__ import annotations

import pytest

from robot_package import node

LAUNCH = """\
import os

from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch import LaunchDescription
from launch.actions import AppendEnvironmentVariable, IncludeLaunchDescription, SetEnvironmentVariable
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import EnvironmentVariable, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

VARIABLE = 'GAZEBO_MODEL_PATH'


def generate_launch_description():
    share = get_package_share_directory('robot')
    prefix = get_package_prefix('robot')
    nav2 = get_package_share_directory('nav2_bringup')
    LINE
    return LaunchDescription([ACTION])
"""


def _told(findings, action: str = "", line: str = "pass") -> list[str]:
    text = LAUNCH.replace("LINE", line).replace("ACTION", action)
    files = {"launch/a.launch.py": text, "config/p.yaml": "talker:\n  ros__parameters:\n    rate: 1.0\n"}
    return [told.message for told in findings("LCH004", node(), **files)]


@pytest.mark.parametrize(
    ("action", "message"),
    [
        (
            "Node(package='robot', executable='talker', parameters=[share + 'config/p.yaml'])",
            "the parameter file 'config/p.yaml' stands right behind the share folder of 'robot', so that this looks "
            "for '…/robotconfig/p.yaml'",
        ),
        (
            "IncludeLaunchDescription(PythonLaunchDescriptionSource([nav2, 'launch/navigation_launch.py']))",
            "the launch file 'launch/navigation_launch.py' stands right behind the share folder of 'nav2_bringup', so "
            "that this looks for '…/nav2_bringuplaunch/navigation_launch.py'",
        ),
        (
            "IncludeLaunchDescription(PythonLaunchDescriptionSource([os.path.join(share, 'launch'), 'it.launch.xml']))",
            "package 'robot' has no launch file 'launchit.launch.xml'; did you mean 'launch/it.launch.xml'?",
        ),
    ],
)
def test_a_path_without_a_slash(findings, action: str, message: str):
    assert _told(findings, action) == [message]


@pytest.mark.parametrize(
    "action",
    [
        "Node(package='robot', executable='talker', parameters=[share + '/config/p.yaml'])",
        "IncludeLaunchDescription(PythonLaunchDescriptionSource([share, '/launch/it.launch.xml']))",
        "IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('robot'), 'launch', 'it.launch.xml']))",
        # The folder of another package beside this one, in a merged install.
        "IncludeLaunchDescription(PythonLaunchDescriptionSource([nav2, '_extras/launch/it.launch.py']))",
        "Node(package='robot', executable='talker', parameters=[get_package_share_directory('nav2') + '_amcl/p.yaml'])",
    ],
)
def test_a_path_with_one_or_to_another_package(findings, action: str):
    assert _told(findings, action) == []


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "os.environ[VARIABLE] = os.environ[VARIABLE] + share + '/models'",
            "GAZEBO_MODEL_PATH gets what it was before and '…/robot/models' without a colon between them: where it was "
            "set, the two become one folder that is not there",
        ),
        (
            "os.environ[VARIABLE] += share",
            "GAZEBO_MODEL_PATH gets what it was before and '…/robot' without a colon between them: where it was set, "
            "the two become one folder that is not there",
        ),
        (
            "os.environ[VARIABLE] = os.environ[VARIABLE] + ':' + prefix + 'share'",
            "GAZEBO_MODEL_PATH gets 'share' right behind the folder '…/robot': there is no such folder",
        ),
        (
            "os.environ[VARIABLE] = 'models' + share",
            "GAZEBO_MODEL_PATH gets 'models' in front of the folder '…/robot': there is no such folder",
        ),
    ],
)
def test_a_search_path_that_code_joins(findings, line: str, message: str):
    assert _told(findings, line=line) == [message]


@pytest.mark.parametrize(
    "line",
    [
        "os.environ[VARIABLE] = os.environ[VARIABLE] + ':' + share + '/models'",
        "os.environ[VARIABLE] = os.environ[VARIABLE] + os.pathsep + share",
        "os.environ[VARIABLE] = os.pathsep.join([os.environ[VARIABLE], share])",
        "os.environ[VARIABLE] = os.environ.get(VARIABLE, '') + (';' if os.name == 'nt' else ':') + share",
        "os.environ[VARIABLE] = share + '/models'",
        "os.environ[VARIABLE] = os.environ['HOME'] + '/models'",
        "os.environ['WORLD'] = 'file' + share",
        "os.environ[VARIABLE] = get_package_share_directory('nav2') + '_amcl'",
        "os.environ['NAV2_PATH'] = get_package_share_directory('nav2_') + 'amcl'",  # a package of this name is there
    ],
)
def test_a_search_path_that_code_joins_well(findings, line: str):
    assert _told(findings, line=line) == []


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (
            "[EnvironmentVariable(VARIABLE, default_value=''), share]",
            "GAZEBO_MODEL_PATH gets what it was before and '…/robot' without a colon between them: where it was set, "
            "the two become one folder that is not there",
        ),
        (
            "[PathJoinSubstitution([share, 'models']), EnvironmentVariable(VARIABLE)]",
            "GAZEBO_MODEL_PATH gets '…/robot/models' and what it was before without a colon between them: where it was "
            "set, the two become one folder that is not there",
        ),
    ],
)
def test_a_search_path_of_substitutions(findings, value: str, message: str):
    assert _told(findings, f"SetEnvironmentVariable(VARIABLE, {value})") == [message]


@pytest.mark.parametrize(
    "action",
    [
        "SetEnvironmentVariable(VARIABLE, [EnvironmentVariable(VARIABLE, default_value=''), ':', share])",
        "SetEnvironmentVariable(VARIABLE, [share, ':', EnvironmentVariable(VARIABLE, default_value='')])",
        "SetEnvironmentVariable(VARIABLE, [EnvironmentVariable('HOME'), '/models'])",
        "SetEnvironmentVariable('WORLD', [EnvironmentVariable('WORLD'), share])",
        "AppendEnvironmentVariable(VARIABLE, share)",
    ],
)
def test_a_search_path_of_substitutions_that_is_right(findings, action: str):
    assert _told(findings, action) == []
