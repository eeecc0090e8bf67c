"""What is asked for narrows what is shown, and never what is known."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String


class {name}(Node):
    def __init__(self):
        super().__init__('{node}')
        {create}

    def on_message(self, message):
        pass


def main():
    rclpy.init()
    rclpy.spin({name}())
"""
SETUP = """\
from setuptools import setup
setup(name='{0}', packages=['{0}'], entry_points={{'console_scripts': ['{0} = {0}.node:main']}})
"""
PACKAGE = """\
<package format="3"><name>{0}</name><version>0.0.0</version><description>a</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><depend>rclpy</depend><depend>std_msgs</depend>
<export><build_type>ament_python</build_type></export></package>
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='talker', executable='talker'),
        Node(package='listener', executable='listener'),
        Node(package='second', executable='second'),
    ])
"""
TALK = "self.create_publisher({0}, 'chatter', 10)"
LISTEN = "self.create_subscription(String, 'chatter', self.on_message, 10)"


def package(name: str, create: str) -> None:
    folder = Path("src", name)
    (folder / name).mkdir(parents=True)
    (folder / name / "__init__.py").touch()
    (folder / name / "node.py").write_text(NODE.format(name=name.title(), node=name, create=create))
    (folder / "setup.py").write_text(SETUP.format(name))
    (folder / "package.xml").write_text(PACKAGE.format(name))


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two packages that publish one topic and one that listens, started together by a launch file."""
    monkeypatch.chdir(tmp_path)
    package("talker", TALK.format("String"))
    package("second", TALK.format("String"))
    package("listener", LISTEN)
    launch = Path("src/bringup/launch")
    launch.mkdir(parents=True)
    (launch / "all.launch.py").write_text(LAUNCH)
    (launch.parent / "package.xml").write_text(PACKAGE.format("bringup"))


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    main([*arguments, "--no-cache"])
    return capsys.readouterr().out


def test_the_graph_of_a_package_names_the_partner_in_the_next_one(capsys: pytest.CaptureFixture[str]) -> None:
    drawn = printed(capsys, "graph", "src/talker")
    assert "subscribed by  /listener" in drawn
    assert "no node here" not in drawn
    assert "Listener" not in drawn, "its own entry was not asked for"


def test_in_json_only_the_nodes_that_were_asked_for_have_an_entry(capsys: pytest.CaptureFixture[str]) -> None:
    document = json.loads(printed(capsys, "graph", "src/talker", "--format", "json"))
    assert [node["name"] for node in document["nodes"]] == ["/talker"]
    assert document["topics"][0]["subscribers"] == ["/listener"]


def test_a_drawing_shows_neighbours_apart(capsys: pytest.CaptureFixture[str]) -> None:
    drawn = printed(capsys, "graph", "src/talker", "--format", "dot")
    assert ">1 node, 2 neighbours, 1 topic" in drawn
    assert "nobody at the other end" not in drawn


def test_a_neighbour_is_drawn_with_what_it_shares_only(capsys: pytest.CaptureFixture[str]) -> None:
    more = Path("src/listener/listener/node.py")
    more.write_text(more.read_text().replace(LISTEN, f"{LISTEN}\n        self.create_publisher(String, 'own', 10)"))
    assert "/own" not in printed(capsys, "graph", "src/talker", "--format", "dot")


def test_a_single_file_is_judged_by_what_launch_files_start(capsys: pytest.CaptureFixture[str]) -> None:
    found = printed(capsys, "check", "src/talker/talker/node.py", "--select", "OWN001")
    assert "OWN001" in found
    assert "no launch file here starts both" not in found


def test_both_ends_of_a_mistake_are_told_wherever_one_asks(capsys: pytest.CaptureFixture[str]) -> None:
    node = Path("src/second/second/node.py")
    node.write_text(node.read_text().replace(TALK.format("String"), TALK.format("Int32")))
    for asked in ("src/second", "src/listener"):
        assert "TOP001" in printed(capsys, "check", asked, "--select", "TOP001"), asked


def test_findings_of_other_packages_are_not_told(capsys: pytest.CaptureFixture[str]) -> None:
    node = Path("src/second/second/node.py")
    node.write_text(node.read_text().replace("'chatter'", "'/robot/absolute'"))
    Path("archlint.toml").write_text("[rules.NME001]\neverywhere = true\n")
    assert "NME001" in printed(capsys, "check", "src/second", "--select", "NME001")
    assert printed(capsys, "check", "src/talker", "--select", "NME001") == ""
