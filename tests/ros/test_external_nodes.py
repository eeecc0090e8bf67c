"""The table of well-known nodes: whole, and right where it was compared with the sources."""

from __future__ import annotations

import pytest

from archlint.ros import external_nodes
from archlint.ros.distros import DISTROS
from archlint.ros.external_nodes import ExternalNode

KIND_OF_TYPE = {
    "publisher": "msg",
    "subscriber": "msg",
    "service": "srv",
    "client": "srv",
    "action_server": "action",
    "action_client": "action",
}


def every() -> list[ExternalNode]:
    return list({id(node): node for nodes in external_nodes.well_known().values() for node in nodes}.values())


def test_each_row_makes_sense():
    for node in every():
        assert node.source.startswith("https://github.com/"), node
        assert set(node.versions) <= set(DISTROS), node
        for end in node.ends:
            assert set(end.distros) <= set(node.versions), (node.package, end)
            assert end.type is None or end.type.split("/")[1] == KIND_OF_TYPE[end.kind], (node.package, end)


def test_what_parameters_or_plug_ins_decide_is_open():
    """What these have, their source alone does not say."""
    for program in [
        ("rviz2", "rviz2"),
        ("ros_gz_bridge", "parameter_bridge"),
        ("controller_manager", "ros2_control_node"),
        ("nav2_controller", "controller_server"),
        ("robot_localization", "ekf_node"),
        ("twist_mux", "twist_mux"),
        ("topic_tools", "relay"),
        ("joint_state_publisher", "joint_state_publisher"),
        ("image_proc", "rectify_node"),
        ("usb_cam", "usb_cam_node_exe"),
        ("foxglove_bridge", "foxglove_bridge"),
        ("rosbridge_server", "rosbridge_websocket.py"),
    ]:
        nodes = external_nodes.well_known().get(program, ())
        assert not nodes or any(node.open for node in nodes), program


@pytest.mark.parametrize(
    "program",
    [
        ("spacenav", "spacenav_node"),  # a macro puts the names of six parameters together
        ("twist_mux", "joystick_relay.py"),  # the defaults of some parameters are the values of others
    ],
)
def test_what_does_not_say_all_that_its_source_does_is_open(program):
    [node] = external_nodes.well_known()[program]
    assert node.open


def test_rviz_calls_its_node_otherwise_than_its_program():
    """``VisualizerApp::init`` in ``visualizer_app.cpp``; another node receives the transforms (``tf_wrapper.cpp``)."""
    [node] = external_nodes.well_known()["rviz2", "rviz2"]
    assert node.name == "rviz"
    assert not [end for end in node.ends if end.kind == "subscriber"]


def test_robot_state_publisher_as_its_source_has_it():
    """``RobotStatePublisher`` in ``robot_state_publisher.cpp``, version 3.3.4."""
    [node] = external_nodes.well_known()["robot_state_publisher", "robot_state_publisher"]
    ends = {(end.kind, end.name, end.type) for end in node.ends if not end.distros or "jazzy" in end.distros}
    assert ends == {
        ("publisher", "/tf", "tf2_msgs/msg/TFMessage"),
        ("publisher", "/tf_static", "tf2_msgs/msg/TFMessage"),
        ("publisher", "robot_description", "std_msgs/msg/String"),
        ("subscriber", "joint_states", "sensor_msgs/msg/JointState"),
    }
    assert not node.open
