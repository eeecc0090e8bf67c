"""LCH005: keywords and attributes that an action of launch does not have."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import node


def test_an_argument_of_an_action_that_it_does_not_have_stops_the_whole_file(findings):
    (xml,) = findings("LCH005", node(nodename="y"))
    assert xml.help == "launch rejects this file before anything is started"
    code = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
    code += "def generate_launch_description():\n    return LaunchDescription([Node(package='robot', node_name='x')])\n"
    (python,) = findings("LCH005", **{"launch/b.launch.py": code})
    assert python.help == "this call raises TypeError before anything is started"


def test_what_the_actions_of_one_file_do_not_have_is_one_finding(findings):
    inner = f"{node(nodename='y', respawned='true')}\n{node(nodename='z')}\n{node(name='fine')}"
    code = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n"
    code += "def generate_launch_description():\n    return LaunchDescription([\n"
    code += "        Node(package='robot', node_name='x', name='a'),\n        Node(package='robot', params=[])])\n"
    python, xml = findings("LCH005", inner, **{"launch/b.launch.py": code})
    assert (xml.place.line, "<node> has no attribute 'nodename'" in xml.message) == (1, True)
    assert [one.place.line for one in xml.related] == [1, 2]
    assert xml.related[0].message == "<node> has no attribute 'respawned'; did you mean 'respawn'?"
    assert (python.place.line, [one.place.line for one in python.related]) == (6, [7])


@pytest.mark.parametrize(
    ("inner", "told"),
    [
        ("<node name='Monitor' path='a/Monitor'/><node name='Plan' path='a/Plan'/>", 0),  # of another tool
        ("<component name='Plan' path='a/Plan'/>", 0),
        ("<node name='a' path='b'/><node pkg='robot' exec='talker'/>", 1),
        ("<node package='robot' executable='talker'/>", 1),
        ("<node name='a' path='$(find-pkg-share robot)/a'/>", 1),
        ("<node name='a' path='b'/><arg name='c'/>", 1),
        ("<node name='a' path='b'><param name='c' value='1'/></node>", 1),
    ],
)
def test_a_launch_file_of_another_tool_is_none_of_ros(findings, inner: str, told: int):
    assert len(findings("LCH005", inner)) == told


def test_a_comment_allows_one_of_them(findings):
    inner = f"{node(nodename='y')} <!-- archlint: ignore[LCH005] -->\n{node(other='z')}"
    (found,) = findings("LCH005", inner)
    assert (found.place.line, found.related) == (2, ())


@pytest.mark.parametrize(("package", "told"), [("launch_ros.actions", 1), ("nav2_common.launch", 0)])
def test_a_node_of_nav2_common_took_other_arguments(findings, package, told):
    text = f"""\
from launch import LaunchDescription
from {package} import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='talker', use_remappings=True)])
"""
    assert len(findings("LCH005", **{"launch/old.launch.py": text})) == told


@pytest.mark.parametrize(("condition", "told"), [("True", 1), ("os.getenv('ROS_DISTRO') == 'dashing'", 0)])
def test_keywords_of_an_older_ros(findings, condition, told):
    text = f"""\
import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    if {condition}:
        return LaunchDescription([Node(package='robot', node_executable='talker')])
    return LaunchDescription([Node(package='robot', executable='talker')])
"""
    assert len(findings("LCH005", **{"launch/old.launch.py": text})) == told


def test_files_for_an_older_release_are_one_finding(findings):
    files = {
        f"launch/{name}.launch.py": f"""\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', node_executable='talker', node_name='{name}')])
"""
        for name in ("arm", "base", "camera")
    }
    (found,) = findings("LCH005", **files)
    assert found.place.file.endswith("launch/arm.launch.py")
    assert found.message == (
        "Node has no argument 'node_executable' since Galactic; it is called 'executable'; "
        "2 more launch files use names of an older launch_ros"
    )
    assert {one.place.file.rpartition("/")[2] for one in found.related} == {
        "arm.launch.py",
        "base.launch.py",
        "camera.launch.py",
    }


@pytest.mark.parametrize(
    ("readme", "told"),
    [
        ("Built and tested with ROS 2 Eloquent.", 0),
        ("For ROS 2 Foxy; the branch for Humble is elsewhere.", 1),
        ("Needs Galactic.", 1),
        ("A robot.", 1),
    ],
)
def test_a_workspace_whose_readme_asks_for_an_old_release(findings, readme: str, told: int):
    text = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', node_executable='talker')])
"""
    assert len(findings("LCH005", **{"launch/arm.launch.py": text, "README.md": readme})) == told
    assert len(findings("LCH005", **{"launch/arm.launch.py": text.replace("node_", "ex"), "README.md": readme})) == 1


@pytest.mark.parametrize(
    ("name", "keyword", "severity"),
    [
        ("dashing_start", "node_executable", Severity.INFO),
        ("elequent_start", "node_executable", Severity.INFO),
        ("box_start", "node_executable", Severity.WARNING),
        ("start", "node_executable", Severity.WARNING),
        ("dashing_start", "executible", Severity.WARNING),
        ("flashing_start", "node_executable", Severity.WARNING),
    ],
)
def test_a_file_for_an_old_release(findings, name: str, keyword: str, severity: Severity):
    text = f"""\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', {keyword}='talker')])
"""
    assert [one.severity for one in findings("LCH005", **{f"launch/{name}.launch.py": text})] == [severity]


@pytest.mark.parametrize(
    ("old", "told"),
    [
        ("start_dashing.launch.py", 0),
        ("dashing_start.launch.py", 0),
        ("dashing_walk.launch.py", 1),
        ("run_dashing.launch.py", 0),
        ("walk_dashing.launch.py", 1),
        ("arm.launch.py", 1),
    ],
)
def test_a_file_for_an_old_release_beside_the_one_for_later_releases(findings, old: str, told: int):
    text = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', KEYWORD='talker')])
"""
    newer = {f"launch/{name}.launch.py": text.replace("KEYWORD", "executable") for name in ("start", "run_galactic")}
    assert len(findings("LCH005", **newer, **{f"launch/{old}": text.replace("KEYWORD", "node_executable")})) == told


def test_an_include_takes_arguments_and_nothing_else(findings):
    inner = "<arg name='a' value='1'/><param name='b' value='2'/>"
    (told,) = findings("LCH005", f"<include file='$(find-pkg-share robot)/launch/other.launch.xml'>{inner}</include>")
    assert told.message == "<include> has no element 'param'"
    assert told.help == "launch rejects this file before anything is started"


@pytest.mark.parametrize(
    ("inner", "said"),
    [
        ("<rosparam command='load' file='$(arg f)'/>", "<node> has no element 'rosparam'; write '<param from=\"…\"/>'"),
        ("<parm name='rate' value='$(arg f)'/>", "<node> has no element 'parm'; did you mean 'param'?"),
    ],
)
def test_an_element_that_a_node_does_not_have(findings, inner: str, said: str):
    launch = f"<arg name='f' default='a.yaml'/><node pkg='robot' exec='talker'>{inner}</node>" + node(name="b")
    (told,) = findings("LCH005", launch)
    assert told.message == said and told.help == "launch rejects this file before anything is started"
    assert findings("LCH007", launch) == []  # launch refuses the element before it parses its texts


def test_elements_that_a_node_has(findings):
    inner = "<param name='rate' value='2.0'/><remap from='a' to='b'/><env name='A' value='1'/>"
    assert findings("LCH005", f"<node pkg='robot' exec='talker'>{inner}</node>") == []
    assert len(findings("LCH007", "<node pkg='robot' exec='talker'><param name='rate' value='$(arg f)'/></node>")) == 1


@pytest.mark.parametrize(
    ("given", "help"),
    [
        ("parameters=[{'a': 1}], ros_parameters={'b': 2}", ": put its values into parameters=, which is given, too"),
        ("name='talker', node_name='talker'", ": remove it: name=, which is given, too"),
        ("ros_parameters={'b': 2}", ""),
    ],
)
def test_what_is_given_under_the_right_name_too(findings, given: str, help: str):
    text = f"""
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='robot', executable='talker', {given})])
"""
    (told,) = findings("LCH005", **{"launch/more.launch.py": text})
    assert told.help == f"this call raises TypeError before anything is started{help}"


PIECES = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, SetEnvironmentVariable, TimerAction
from launch.conditions import IfCondition
from launch.substitutions import Command, EnvironmentVariable, LaunchConfiguration, TextSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

def generate_launch_description():
    piece = {}
    return LaunchDescription([Node(package='robot', executable='talker')])
"""


@pytest.mark.parametrize(
    ("piece", "told"),
    [
        (
            "LaunchConfiguration('a', default_value='b')",
            "LaunchConfiguration has no argument 'default_value'; it is called 'default'",
        ),
        (
            "DeclareLaunchArgument('a', default='b')",
            "DeclareLaunchArgument has no argument 'default'; it is called 'default_value'",
        ),
        (
            "EnvironmentVariable('A', default='b')",
            "EnvironmentVariable has no argument 'default'; it is called 'default_value'",
        ),
        (
            "ParameterValue(Command(['xacro ', 'a']), value_typ=str)",
            "ParameterValue has no argument 'value_typ'; did you mean 'value_type'?",
        ),
        ("TimerAction(period=1.0, action=[])", "TimerAction has no argument 'action'; did you mean 'actions'?"),
    ],
)
def test_a_piece_of_a_launch_file_that_its_class_refuses(findings, piece: str, told: str):
    (found,) = findings("LCH005", **{"launch/b.launch.py": PIECES.format(piece)})
    assert found.message == told
    assert (found.place.line, found.help) == (9, "this call raises TypeError before anything is started")


@pytest.mark.parametrize(
    "piece",
    [
        "LaunchConfiguration('a', default='b')",
        "LaunchConfiguration(variable_name='a')",
        "DeclareLaunchArgument('a', default_value='b', choices=['b'], description='c', condition=IfCondition('true'))",
        "EnvironmentVariable('A', default_value='b')",
        "TextSubstitution(text='a')",
        "SetEnvironmentVariable(name='A', value='b', condition=IfCondition('true'))",
        "GroupAction(actions=[], scoped=True, forwarding=False, launch_configurations={})",
        "TimerAction(period=1.0, actions=[], cancel_on_shutdown=True)",
        "LaunchConfiguration('a', **{'default': 'b'})",
    ],
)
def test_a_piece_of_a_launch_file_that_its_class_takes(findings, piece: str):
    assert findings("LCH005", **{"launch/b.launch.py": PIECES.format(piece)}) == []
