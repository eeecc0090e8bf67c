"""Launched processes in which something works on a node that is not known."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check, graph
from archlint.systems.model import System

FILES = {
    "package.xml": """\
<package format="3"><name>robot</name><version>0.1.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license></package>
""",
    "setup.py": """\
from setuptools import setup
setup(name='robot', packages=['robot'], data_files=[('share/robot/launch', ['launch/robot.launch.py'])],
      entry_points={'console_scripts': ['talker = robot.talker:main', 'thing = robot.thing:main']})
""",
    "robot/__init__.py": "",
    "robot/talker.py": """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Plugin:
    def start(self, context):
        self.node = context.node
        self.node.create_publisher(String, "status", 10)

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.out = self.create_publisher(String, "chatter", 10)
        self.plugin = Plugin()

def main():
    rclpy.init()
    rclpy.spin(Talker())
""",
    "robot/thing.py": """\
from framework import Robot, run
from std_msgs.msg import String

class Thing(Robot):
    def __init__(self):
        super().__init__()
        self.out = self.create_publisher(String, "thing", 10)

def main():
    run(Thing())
""",
    "launch/robot.launch.py": """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='talker', name='speaker', remappings=[('status', 'state'), ('no', 'x')]),
        Node(package='robot', executable='thing', name='thing'),
    ])
""",
}


@pytest.fixture
def request_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Request:
    for name, text in FILES.items():
        path = tmp_path / "src" / "robot" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    monkeypatch.chdir(tmp_path)
    return Request((".",), load(tmp_path), cached=False, jobs=1, launch="src/robot/launch/robot.launch.py")


@pytest.fixture
def system(request_for: Request) -> System:
    return graph(request_for)


def test_a_helper_is_not_renamed_with_its_process(system):
    [plugin] = [one for one in system.unowned if one.blueprint.class_name == "Plugin"]
    assert plugin.name is None
    assert [end.name for end in plugin.endpoints] == ["/state"]  # but remapped, whoever its node is


def test_a_process_with_nothing_but_a_helper_is_still_a_node(system):
    assert [(node.name, node.external) for node in system.nodes] == [("/speaker", False), ("/thing", True)]
    assert system.nodes[1].unfollowed


def test_no_remapping_of_such_a_process_is_called_dead(request_for):
    assert [found.code for found in check(request_for).findings if found.code.startswith("LCH")] == []
