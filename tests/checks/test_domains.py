"""Nodes of different DDS domains do not see each other: rules that hold the nodes of one system against each other."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

SETUP = """\
from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main']},
)
"""
TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'state', 10)
        self.create_subscription(String, 'orders', print, 10)
        self.create_service(Trigger, 'reset', self.reset)

    def reset(self, request, response):
        return response


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, ExecuteProcess, GroupAction, OpaqueFunction, SetEnvironmentVariable, TimerAction)
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace


def group(*actions):
    return GroupAction(scoped=True, actions=list(actions))


def domain(value):
    return SetEnvironmentVariable('ROS_DOMAIN_ID', value)


def talker(name='talker', **more):
    return Node(package='robot', executable='talker', name=name, **more)


def start(context):
    first = int(LaunchConfiguration('first').perform(context))
    return [group(domain(str(first + i)), talker()) for i in range(3)]


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('first', default_value='40'), %s])
"""


@pytest.fixture
def codes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)

    def run(launch: str, file: str = "launch/robot.launch.py", select: str = "NME004") -> list[str]:
        texts = {
            "archlint.toml": f'select = ["{select}"]',
            "package.xml": "<package format='3'><name>robot</name><exec_depend>rclpy</exec_depend>"
            "<export><build_type>ament_python</build_type></export></package>",
            "setup.py": SETUP,
            "robot/talker.py": TALKER,
            file: launch,
        }
        for name, text in texts.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return [finding.code for finding in check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings]

    return run


@pytest.mark.parametrize(
    "actions",
    [
        "OpaqueFunction(function=start)",
        "group(domain('1'), talker()), group(domain('2'), talker())",
        "group(domain('1'), talker()), talker()",
        "group(domain(LaunchConfiguration('left')), talker()), group(domain(LaunchConfiguration('right')), talker())",
        "talker(additional_env={'ROS_DOMAIN_ID': '1'}), talker(additional_env={'ROS_DOMAIN_ID': '2'})",
        "talker(env={'ROS_DOMAIN_ID': '1'}), talker()",
        "ExecuteProcess(cmd=['ros2', 'run', 'robot', 'talker'], additional_env={'ROS_DOMAIN_ID': '1'}), talker()",
    ],
)
def test_nodes_of_different_domains_may_have_one_name(codes, actions: str):
    assert codes(LAUNCH % actions) == []


@pytest.mark.parametrize(
    "actions",
    [
        "group(domain('1'), talker()), group(domain('1'), talker())",
        "domain('1'), talker(), domain('1'), talker()",
        "group(domain(LaunchConfiguration('it')), talker()), group(domain(LaunchConfiguration('it')), talker())",
        "group(SetEnvironmentVariable('RMW', '1'), talker()), group(SetEnvironmentVariable('RMW', '2'), talker())",
        # The group has ended when the timer fires, and with it its environment.
        "group(domain('1'), TimerAction(period=1.0, actions=[talker()])), talker()",
    ],
)
def test_nodes_of_one_domain_need_names_of_their_own(codes, actions: str):
    declared = f"DeclareLaunchArgument('it'), {actions}"
    assert codes(LAUNCH % declared) == ["NME004"]


@pytest.mark.parametrize(("right", "told"), [("1", []), ("0", ["NME004"])])
def test_domains_in_launch_files_in_xml(codes, right: str, told: list[str]):
    node = '<node pkg="robot" exec="talker" name="talker"><env name="ROS_DOMAIN_ID" value="{}"/></node>'
    launch = f"<launch>{node.format(0)}{node.format(right)}</launch>"
    assert codes(launch, "launch/robot.launch.xml") == told


@pytest.mark.parametrize(("right", "told"), [("2", []), ("1", ["OWN001", "OWN002"])])
def test_owners_in_different_domains(codes, right: str, told: list[str]):
    actions = f"group(domain('1'), talker('left')), group(domain('{right}'), talker('right'))"
    assert codes(LAUNCH % actions, select="OWN") == told
