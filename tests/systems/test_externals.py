"""Nodes whose source is not here: what the launch file's remappings tell of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main

PACKAGE = """<package format="3"><name>view</name><version>0.1.0</version><description>d</description>
<maintainer email="view@example.com">View</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>
<exec_depend>sensor_msgs</exec_depend><exec_depend>launch</exec_depend><exec_depend>launch_ros</exec_depend>
<exec_depend>usb_cam</exec_depend><exec_depend>image_proc</exec_depend></package>"""
SETUP = """from setuptools import setup
setup(name='view', packages=['view'], entry_points={'console_scripts': ['viewer = view.viewer:main']})
"""
VIEWER = """import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image


class Viewer(Node):
    def __init__(self):
        super().__init__('viewer')
        self.create_subscription(Image, '/front/image', self.show, 10)

    def show(self, image):
        pass


def main():
    rclpy.init()
    rclpy.spin(Viewer())
"""
LAUNCH = """from launch import LaunchDescription
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='view', executable='viewer'),
        Node(package='usb_cam', executable='usb_cam_node', name='camera', namespace='front',
             remappings=[('image_raw', 'image'), ('camera_info', '~/info'), ('alone', '/alone'),
                         ('other', EnvironmentVariable('OTHER'))]),
        Node(package='image_proc', executable='rectify', name='rectify',
             remappings=[('camera_info', '/front/camera/info')]),
    ])
"""


@pytest.fixture
def show(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    files = {"package.xml": PACKAGE, "setup.py": SETUP, "view/viewer.py": VIEWER, "launch/view.launch.py": LAUNCH}
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, "utf-8")
    monkeypatch.chdir(tmp_path)

    def run(format_: str) -> str:
        assert main(["graph", "--no-cache", "--launch", "launch/view.launch.py", "--format", format_]) == 0
        return capsys.readouterr().out

    return run


def test_the_text_lists_what_is_remapped_and_for_whom(show):
    lines = [" ".join(line.split()) for line in show("text").splitlines()]

    assert "remaps image_raw to /front/image" in lines
    assert "remaps camera_info to /front/camera/info" in lines
    assert "remapped for /front/camera" in lines
    assert not any("other" in line for line in lines if line.startswith("remaps"))


def test_the_picture_ties_an_external_node_to_names_that_somebody_else_has(show):
    drawn = show("mermaid")

    shapes = [line.strip() for line in drawn.splitlines() if '["' in line]
    ids = {shape.split('"')[1].split("<br>")[0]: shape.split("([")[0].split("[")[0] for shape in shapes}
    lines = {tuple(line.split(" -.- ")) for line in map(str.strip, drawn.splitlines()) if " -.- " in line}
    camera, rectify = ids["/front/camera"], ids["/rectify"]
    assert lines == {
        (camera, ids["/front/image"]),
        (camera, ids["/front/camera/info"]),
        (rectify, ids["/front/camera/info"]),
    }
    assert "/alone" not in drawn


def test_a_subscriber_whose_partner_may_be_external_is_not_drawn_as_alone(show):
    drawn = show("dot")

    assert "nobody at the other end" not in drawn
    assert "dashed without an arrow: remapped; the source is not in this workspace" in drawn
    assert drawn.count('dir="none"') == 3
