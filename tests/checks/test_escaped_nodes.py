"""What is said of a node that lacks something, and not said of one that code which is not here has got hold of."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config import load
from archlint.session import Request, check

FILES = {
    "package.xml": """<package format="3"><name>robot</name>
<exec_depend>rclpy</exec_depend><exec_depend>std_msgs</exec_depend><exec_depend>std_srvs</exec_depend>
<exec_depend>example_interfaces</exec_depend><exec_depend>dashboard</exec_depend>
<export><build_type>ament_python</build_type></export></package>
""",
    "setup.py": """from glob import glob
from setuptools import setup
setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*'))],
    entry_points={'console_scripts': ['talker = robot.talker:main', 'other = robot.other:main']},
)
""",
    "robot/other.py": """import rclpy
from rclpy.node import Node
from std_msgs.msg import Int8

class Other(Node):
    def __init__(self):
        super().__init__('other')
        self.create_publisher(Int8, 'alone', 10)

def main():
    rclpy.init()
    rclpy.spin(Other())
""",
    "launch/it.launch.xml": """<launch>
<node pkg="robot" exec="talker">
  <remap from="word" to="words"/>
  <remap from="said" to="spoken"/>
  <param name="rat" value="1.0"/>
</node>
<node pkg="robot" exec="other"><param from="$(find-pkg-share robot)/config/it.yaml"/></node>
<node pkg="robot" exec="talker" name="second"><param from="$(find-pkg-share robot)/config/it.yaml"/></node>
</launch>
""",
    "config/it.yaml": "far_away:\n  ros__parameters:\n    rate: 1.0\n",
}
TALKER = """import dashboard
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)
        self.period = self.get_parameter('period').value
        self.create_publisher(String, 'said', 10)
        self.create_subscription(String, 'heard', self.on_heard, 10)
        self.create_client(Trigger, 'ask')
        ActionClient(self, Fibonacci, 'count')
        {body}

    def on_heard(self, message):
        pass

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
OF_ABSENCE = ("LCH002", "PRM003", "PRM004", "PRM005", "PRM006", "TOP002", "TOP003", "SRV001", "ACT001", "GRF001")


def told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str, *codes: str) -> set[str]:
    monkeypatch.chdir(tmp_path)
    config = f"select = {list(codes)}\nclosed-world = true\n"
    for name, text in {**FILES, "archlint.toml": config, "robot/talker.py": TALKER.format(body=body)}.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return {one.code for one in check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings}


@pytest.mark.parametrize("body", ["pass", "self.nodes = [self]", "self.create_timer(1.0, lambda: self.on_heard(None))"])
def test_a_node_that_stays_in_sight(tmp_path, monkeypatch, body):
    assert told(tmp_path, monkeypatch, body, *OF_ABSENCE) == set(OF_ABSENCE)


@pytest.mark.parametrize(
    "body", ["dashboard.supervisor = self", "dashboard.nodes['talker'] = self", "dashboard.show(nodes=[self])"]
)
def test_a_node_that_escapes(tmp_path, monkeypatch, body):
    assert told(tmp_path, monkeypatch, body, *OF_ABSENCE) == set()
