"""Bridges to a simulator that read what they bridge in a file of the workspace."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.systems.nodes import Node
from robot_package import write_files, write_robot

FILE = """
- ros_topic_name: scan
  gz_topic_name: /world/scan
  ros_type_name: sensor_msgs/msg/LaserScan
  gz_type_name: gz.msgs.LaserScan
  direction: GZ_TO_ROS
- topic_name: /cmd_vel
  ros_type_name: geometry_msgs/msg/Twist
  gz_type_name: gz.msgs.Twist
  direction: ROS_TO_GZ
"""
PATH = "$(find-pkg-share robot)/config/bridge.yaml"
ENDS = [
    ("subscriber", "/cmd_vel", "geometry_msgs/msg/Twist"),
    ("publisher", "/sim/scan", "sensor_msgs/msg/LaserScan"),
]


@pytest.fixture
def started(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The one node of a launch file with these lines."""
    monkeypatch.chdir(tmp_path)

    def start(lines: str, file: str = FILE) -> Node:
        write_robot(tmp_path, lines)
        install = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})"
        write_files(tmp_path, {"config/bridge.yaml": file, "CMakeLists.txt": f"project(robot)\n{install}\n"})
        request = Request((".",), Settings(), cached=False, jobs=1, launch="launch/it.launch.xml")
        [node] = graph(request).nodes
        return node

    return start


def ends(node: Node) -> list[tuple[str, str | None, str | None]]:
    return [(end.kind, end.name, end.type) for end in node.endpoints]


@pytest.mark.parametrize(
    ("program", "inner"),
    [
        ("exec='parameter_bridge'", f"<param name='config_file' value='{PATH}'/>"),
        ("exec='bridge_node'", f"<param name='config_file' value='{PATH}'/><param name='use_sim_time' value='true'/>"),
        (f"exec='parameter_bridge' args='--ros-args -p config_file:={PATH}'", ""),
        (f"exec='parameter_bridge' ros_args='-p config_file:={PATH}'", ""),
    ],
    ids=["parameter", "node", "arguments", "ros arguments"],
)
def test_the_file_says_what_a_bridge_has(started, program: str, inner: str):
    node = started(f"<node pkg='ros_gz_bridge' {program} name='bridge' namespace='sim'>{inner}</node>")
    assert ends(node) == ENDS
    assert not node.is_stranger


def test_arguments_and_a_file_say_more_than_one_of_them(started):
    node = started(
        "<node pkg='ros_gz_bridge' exec='parameter_bridge' args='/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'>"
        f"<param name='config_file' value='{PATH}'/></node>"
    )
    assert [name for _, name, _ in ends(node)] == ["/clock", "/cmd_vel", "/scan"]
    assert not node.is_stranger


@pytest.mark.parametrize(
    "parameters",
    [
        "<param name='config_file' value='/opt/bridge.yaml'/>",
        f"<param name='config_file' value='{PATH}'/><param from='/opt/more.yaml'/>",
        f"<param name='config_file' value='{PATH}'/><param name='bridge_names' value='[&quot;a&quot;]'/>",
    ],
    ids=["a file of the machine", "parameters of the machine", "bridges that are parameters"],
)
def test_a_bridge_may_have_more_than_is_known(started, parameters: str):
    assert started(f"<node pkg='ros_gz_bridge' exec='parameter_bridge'>{parameters}</node>").is_stranger


def test_a_file_with_a_service_is_not_known_whole(started):
    node = started(
        f"<node pkg='ros_gz_bridge' exec='bridge_node'><param name='config_file' value='{PATH}'/></node>",
        FILE + "- service_name: /world/control\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld\n",
    )
    assert node.is_stranger


def test_another_node_reads_a_file_of_its_own(started):
    node = started(f"<node pkg='sim_tools' exec='relay'><param name='config_file' value='{PATH}'/></node>")
    assert (node.external, ends(node)) == (True, [])
