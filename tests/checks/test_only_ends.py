"""TOP004: a publisher and a subscription that are the only ones of a type which the workspace defines."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import MANIFEST, write_files

CMAKE = "project(arm_msgs)\nrosidl_generate_interfaces(${PROJECT_NAME} msg/Grip.msg)\n"
SETUP = """from setuptools import setup
setup(name='arm', packages=['arm'], entry_points={'console_scripts': ['hand = arm.hand:main', 'eye = arm.eye:main']})
"""
NODE = """import rclpy
from arm_msgs.msg import Grip
from rclpy.node import Node


class {name}(Node):
    def __init__(self):
        super().__init__('{name}')
        {line}

    def take(self, message=None):
        print(message)


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
HAND = "self.create_subscription(Grip, '{}', self.take, 10)"
EYE = "self.create_publisher(Grip, '{}', 10).publish(Grip())"


def told(folder: Path, monkeypatch: pytest.MonkeyPatch, read: str, sent: str, **files: str) -> list[str]:
    rows = {
        "arm_msgs/package.xml": MANIFEST.format(name="arm_msgs", type="ament_cmake", more=""),
        "arm_msgs/CMakeLists.txt": CMAKE,
        "arm_msgs/msg/Grip.msg": "float64 force\n",
        "arm/package.xml": MANIFEST.format(name="arm", type="ament_python", more="<depend>arm_msgs</depend>"),
        "arm/setup.py": SETUP,
        "arm/arm/__init__.py": "",
        "arm/arm/hand.py": NODE.format(name="hand", line=HAND.format(read)),
        "arm/arm/eye.py": NODE.format(name="eye", line=EYE.format(sent)),
        "archlint.toml": 'select = ["TOP004"]\n',
    }
    monkeypatch.chdir(write_files(folder, rows | files))
    findings = check(Request((".",), load(folder), cached=False, jobs=1)).findings
    return [f"{finding.place.file}:{finding.place.line}" for finding in findings]


def test_two_names_for_one_topic(tmp_path, monkeypatch):
    assert told(tmp_path, monkeypatch, "grasp", "wanted_force") == ["arm/arm/hand.py:9"]


def test_one_name(tmp_path, monkeypatch):
    assert told(tmp_path, monkeypatch, "grasp", "grasp") == []


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("arm/arm/third.py", NODE.format(name="third", line=EYE.format("rest"))),  # another one publishes the type
        ("arm/arm/tool.py", "from arm_msgs.msg import Grip\n\nWANTED = Grip\n"),  # what uses it is not known
        ("firmware/hand.ino", "#include <arm_msgs/msg/grip.h>\nGrip grip;\n"),
        ("README.md", "Try `ros2 topic pub /grasp arm_msgs/msg/Grip`.\n"),
        ("arm/launch/it.launch.xml", '<launch><node pkg="x" exec="y"><remap from="a" to="grasp"/></node></launch>'),
    ],
)
def test_another_end_that_there_may_be(tmp_path, monkeypatch, file, text):
    assert told(tmp_path, monkeypatch, "grasp", "wanted_force", **{file: text}) == []


REMAPPED = """<launch>
<node pkg="arm" exec="eye"><remap from="left_grasp" to="{to}"/></node>
</launch>
"""


@pytest.mark.parametrize(
    ("to", "lines"),
    [
        ("/left/grasp", []),  # whoever starts the launch file has the names meet
        ("/right/grasp", ["arm/arm/hand.py:9"]),
    ],
)
def test_a_launch_file_that_remaps_one_name_onto_the_other(tmp_path, monkeypatch, to: str, lines: list[str]):
    launch = {"arm/launch/it.launch.xml": REMAPPED.format(to=to)}
    assert told(tmp_path, monkeypatch, "/left/grasp", "left_grasp", **launch) == lines
