"""LCH002: remappings of a launch file that do nothing."""

from __future__ import annotations

import pytest

from robot_package import SETUP, TALKER, node


@pytest.mark.parametrize(
    "remap",
    [
        '<remap from="chatter" to="x"/>',
        '<remap from="~/get_parameters" to="x"/>',
        '<remap from="/tf" to="tf"/>',
        '<remap from="/rosout" to="x"/>',
        '<remap from="/imu" to="/imu"/>',  # a note of what the node uses
        '<remap from="params_file" to="src/a-b/c.yaml"/>',  # rcl ends the process: NME002
    ],
)
def test_live_remappings(findings, remap):
    assert findings("LCH002", node(remap)) == []


def test_remappings_of_a_group_are_for_whoever_has_the_name(findings):
    assert findings("LCH002", '<set_remap from="odom" to="/odom"/>' + node()) == []


def test_a_remapping_that_works_where_the_file_is_included_in_a_namespace(findings):
    remap = '<remap from="/left/chatter" to="/x"/>'
    part = f"<launch>{node(remap)}</launch>"
    include = '<include file="$(find-pkg-share robot)/launch/part.launch.xml"/>'

    pushed = f'<group><push_ros_namespace namespace="left"/>{include}</group>'
    assert findings("LCH002", pushed, **{"launch/part.launch.xml": part}) == []
    assert findings("LCH002", include, **{"launch/part.launch.xml": part}) != []


def test_a_remapping_is_judged_under_the_nodes_namespace(findings):
    (found,) = findings("LCH002", node('<remap from="/chatter" to="x"/>', namespace="left"))
    assert "/left/talker has no name '/chatter'" in found.message
    assert "/left/chatter" in found.help


def test_a_node_that_hands_itself_out_may_have_more_names(findings):
    text = TALKER.replace("        self.create_publisher", "        Helper(self)\n        self.create_publisher")
    text = "from library import Helper\n" + text
    assert findings("LCH002", node('<remap from="odom" to="x"/>'), **{"robot/talker.py": text}) == []


def test_a_container_does_not_pass_its_remappings_on(findings):
    container = (
        '<node pkg="rclcpp_components" exec="component_container" name="box"><remap from="/chatter" to="x"/></node>'
    )
    (found,) = findings("LCH002", container + node())
    assert found.help == "write it on the ComposableNode: a container does not pass its remappings on"
    assert findings("LCH002", container + node('<remap from="/chatter" to="x"/>')) == []


@pytest.mark.parametrize(("package", "told"), [("$(var package)", 0), ("robot", 1)])
def test_a_program_that_arguments_choose(findings, package: str, told: int):
    arguments = '<arg name="client" default="talker"/>'
    arguments += '<arg name="package" default="robot"/>' if package.startswith("$") else ""
    client = node('<remap from="fix" to="/fix"/>', pkg=package, exec="$(var client)")
    assert len(findings("LCH002", arguments + client)) == told


def test_dead_remappings_of_one_node_are_one_finding(findings):
    remaps = '<remap from="odom" to="a"/>\n<remap from="chatter" to="b"/>\n<remap from="scan" to="c"/>'
    copy = {"launch/more.launch.xml": f"<launch>{node(remaps)}</launch>"}
    (found,) = findings("LCH002", node(remaps), **copy)
    assert found.message == ("/talker has none of these 2 names, so these remappings have no effect: /odom, /scan")
    assert [(row.place.file, row.place.line) for row in found.related] == [
        ("launch/it.launch.xml", 3),
        ("launch/more.launch.xml", 1),
        ("launch/more.launch.xml", 3),
    ]
    misspelt = remaps.replace("odom", "chater")
    assert len(findings("LCH002", node(misspelt), **{"launch/more.launch.xml": "<launch/>"})) == 2


def test_copies_of_a_remapping_of_a_well_known_node_are_one_finding(findings):
    publisher = (
        '<node pkg="robot_state_publisher" exec="robot_state_publisher" name="{}">'
        '<remap from="/cmd_vel" to="x"/></node>'
    )
    copy = {"launch/more.launch.xml": f"<launch>{publisher.format('state')}</launch>"}
    (found,) = findings("LCH002", publisher.format("state"), **copy)
    assert found.message == "/state has no name '/cmd_vel', so this remapping has no effect"
    assert [(row.place.file, row.message) for row in found.related] == [
        ("launch/more.launch.xml", "it is remapped here, too")
    ]
    assert len(findings("LCH002", publisher.format("state") + publisher.format("other"))) == 2


def test_what_a_well_known_node_has_is_no_advice_for_the_name_of_another(findings):
    """The remapping is that of a plugin of the simulation, which stands in the robot's description."""
    publisher = '<node pkg="robot_state_publisher" exec="robot_state_publisher"><remap from="{}" to="x"/></node>'
    (found,) = findings("LCH002", publisher.format("/imu_plugin/out"))
    assert found.help == (
        "remove it, or move it to the node that has the name; this one has /joint_states, /robot_description, /tf, "
        "/tf_static"
    )
    (near,) = findings("LCH002", publisher.format("joint_state"))
    assert near.help.startswith("use a full name of the node: ")


def test_a_parameter_is_no_name_to_remap(findings):
    (found,) = findings("LCH002", node('<remap from="use_sim_time" to="false"/>'))
    assert found.help == "'use_sim_time' is a parameter: set it with <param>"
    (found,) = findings("LCH002", node('<remap from="rate" to="fast"/>'))
    assert found.help == "'rate' is a parameter: set it with <param>"


def test_services_are_no_advice_for_a_topic(findings):
    services = "\n        ".join(f"self.create_service(Trigger, '{name}', print)" for name in ("pick", "place"))
    server = TALKER.replace("self.create_publisher(String, 'chatter', 10)", services)
    server = server.replace("std_msgs.msg import String", "std_srvs.srv import Trigger")
    (found,) = findings("LCH002", node('<remap from="~/image" to="camera/image"/>'), **{"robot/talker.py": server})
    assert found.help == "remove it; the node has no topics, only /pick, /place"
    (alike,) = findings("LCH002", node('<remap from="~/pick" to="fetch"/>'), **{"robot/talker.py": server})
    assert alike.help == "use a full name of the node: /pick, /place"


def test_the_only_name_of_a_node_is_no_advice_where_it_is_nothing_like_it(findings):
    (found,) = findings("LCH002", node('<remap from="odometry" to="odom"/>'))
    assert found.help == "remove it; the only name of the node is /chatter"
    (found,) = findings("LCH002", node('<remap from="chater" to="words"/>'))
    assert found.help == "use a full name of the node: /chatter, or correct that one"


@pytest.mark.parametrize("target", ["chatter", "/chatter"])
def test_a_remapping_to_a_name_that_the_node_has_anyway(findings, target: str):
    """Nothing is lost: the line says what holds without it."""
    assert findings("LCH002", node(f'<remap from="chater" to="{target}"/>')) == []
    assert len(findings("LCH002", node('<remap from="chater" to="words"/>'))) == 1


def test_a_node_is_renamed_by_name_alone(findings):
    (told,) = findings("LCH002", node('<remap from="/talker" to="speaker"/>'))
    assert told.help == "remove it, or rename the node with name=: a remapping is for topics, services and actions"


MODES = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('debug', False)
        self.declare_parameter('topic', 'words')
        self.create_publisher(String, self.get_parameter('topic').value, 1)
        self.create_publisher(String, 'chatter', 1)
        if self.get_parameter('debug').value:
            self.create_publisher(String, 'details', 1)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_a_name_that_the_node_has_with_another_value_of_a_parameter(findings):
    """Whoever sets ``debug`` needs the remapping; a name that is a parameter's value is another one by now."""
    remap = '<remap from="details" to="/robot/details"/><param name="debug" value="{}"/>'
    for value in ("false", "$(var debug)"):
        launch = '<arg name="debug" default="false"/>' + node(remap.format(value))
        assert findings("LCH002", launch, **{"robot/talker.py": MODES}) == []
    renamed = node('<remap from="words" to="/robot/words"/><param name="topic" value="texts"/>')
    (diagnostic,) = findings("LCH002", renamed, **{"robot/talker.py": MODES})
    assert "no name '/words'" in diagnostic.message


CHOSEN = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('program', default_value='talker', choices=['talker', 'speaker']),
        Node(
            package='robot',
            executable=LaunchConfiguration('program'),
            remappings=[('chatter', 'x'), ('~/volume', 'y'), ('odom', 'z')],
        ),
    ])
"""


def test_a_name_of_another_executable_that_the_same_action_may_start(findings):
    speaker = TALKER.replace("'talker'", "'speaker'").replace("'chatter'", "'~/volume'")
    setup = SETUP.replace(
        "'talker = robot.talker:main'", "'talker = robot.talker:main', 'speaker = robot.speaker:main'"
    )
    files = {"robot/speaker.py": speaker, "setup.py": setup, "launch/a.launch.py": CHOSEN}
    (diagnostic,) = findings("LCH002", **files)
    assert "no name '/odom'" in diagnostic.message
    fixed = CHOSEN.replace(", choices=['talker', 'speaker']", "")
    (diagnostic,) = findings("LCH002", **{**files, "launch/a.launch.py": fixed})
    assert "none of these 2 names" in diagnostic.message


def test_what_every_node_has_is_in_no_namespace(findings):
    remap, simulated = '<remap from="clock" to="/world/clock"/>', '<param name="use_sim_time" value="true"/>'
    (told,) = findings("LCH002", node(simulated + remap, namespace="left"))
    assert told.message == "/left/talker has no name '/left/clock', so this remapping has no effect"
    assert told.help == "write '/clock', which every node has by this name in any namespace, or remove it"


def test_a_clock_that_the_node_does_not_hear(findings):
    remap, computed = '<remap from="clock" to="/world/clock"/>', '<param name="use_sim_time" value="false"/>'
    assert not findings("LCH002", node(remap, namespace="left"))
    assert not findings("LCH002", node(computed + remap, namespace="left"))
    assert findings("LCH002", node('<remap from="clocks" to="/world/clock"/>', namespace="left"))
