"""LCH008: actions without an argument that they need, and values of launch arguments that are no choice."""

from __future__ import annotations

import pytest

from archlint.finding import Severity

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription, LogInfo, SetEnvironmentVariable,
    SetLaunchConfiguration, TimerAction,
)
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import (
    ComposableNodeContainer, LifecycleNode, LoadComposableNodes, Node, PushRosNamespace, SetParameter, SetRemap,
)
from launch_ros.descriptions import ComposableNode
from elsewhere import unknown

common = {{'executable': 'talker', 'namespace': ''}}

def generate_launch_description():
    return LaunchDescription([
        {action},
    ])
"""
INCLUDED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('world', default_value='empty', choices=['empty', 'house']),
        Node(package='robot', executable='talker', arguments=[LaunchConfiguration('world')]),
    ])
"""


def _told(findings, action: str):
    return findings("LCH008", **{"launch/it.launch.py": LAUNCH.format(action=action)})


@pytest.mark.parametrize(
    ("action", "lacks"),
    [
        ("Node(package='robot', name='talker')", "this Node lacks executable="),
        ("LifecycleNode(package='robot', executable='talker', name='talker')", "this LifecycleNode lacks namespace="),
        ("LifecycleNode(package='robot', executable='talker')", "this LifecycleNode lacks name= and namespace="),
        ("TimerAction(period=5.0)", "this TimerAction lacks actions="),
        ("SetEnvironmentVariable('DISPLAY')", "this SetEnvironmentVariable lacks value="),
        ("SetParameter('use_sim_time')", "this SetParameter lacks value="),
        ("GroupAction([IncludeLaunchDescription()])", "this IncludeLaunchDescription lacks launch_description_source="),
        (
            "LoadComposableNodes(target_container='c', composable_node_descriptions=[ComposableNode(package='robot')])",
            "this ComposableNode lacks plugin=",
        ),
    ],
)
def test_an_action_without_what_it_needs(findings, action: str, lacks: str):
    (told,) = _told(findings, action)
    assert told.message == f"{lacks}, which it cannot do without: launch stops with a TypeError"
    assert told.help == f"add {lacks.partition('lacks ')[2]}"
    assert told.place.line == 17


@pytest.mark.parametrize(
    "action",
    [
        "Node(package='robot', executable='talker')",
        "Node(executable='/bin/date')",
        "LifecycleNode(package='robot', name='talker', **common)",
        "LifecycleNode(package='robot', executable='talker', name='talker', namespace='')",
        "TimerAction(period=5.0, actions=[LogInfo(msg='five seconds')])",
        "SetEnvironmentVariable('DISPLAY', ':0')",
        "SetEnvironmentVariable(*('DISPLAY', ':0'))",
        "ComposableNodeContainer(package='robot', executable='talker', name='c', namespace='')",
        "Node(package='robot', node_executable='talker')",
    ],
)
def test_an_action_with_what_it_needs(findings, action: str):
    """``node_executable`` is what LCH005 reports."""
    assert _told(findings, action) == []


def test_a_default_that_is_no_choice(findings):
    action = "DeclareLaunchArgument('mode', default_value='simulaton', choices=['simulation', 'robot'])"
    (told,) = _told(findings, action)
    assert told.message == (
        "'simulaton' is the default for 'mode', and none of its choices: launch stops with a RuntimeError"
    )
    assert told.help == "write 'simulation'"
    assert told.place.line == 17


@pytest.mark.parametrize(
    "action",
    [
        "DeclareLaunchArgument('mode', default_value='robot', choices=['simulation', 'robot'])",
        "DeclareLaunchArgument('mode', choices=['simulation', 'robot'])",
        "DeclareLaunchArgument('mode', default_value='x', choices=['a', *unknown()])",
        "DeclareLaunchArgument('mode', default_value=LaunchConfiguration('of_parent', default='b'), choices=['a'])",
    ],
)
def test_a_default_that_is_a_choice_or_may_be_one(findings, action: str):
    assert _told(findings, action) == []


@pytest.mark.parametrize(
    ("given", "said"), [("'big'", ["it.launch.py"]), ("'house'", []), ("LaunchConfiguration('size')", [])]
)
def test_what_an_include_passes(findings, given: str, said: list[str]):
    """What it hands on from an argument of its own depends on who sets that."""
    including = (
        "DeclareLaunchArgument('size', default_value='huge'),\n"
        "        IncludeLaunchDescription(\n"
        "            PythonLaunchDescriptionSource(get_package_share_directory('robot') + '/launch/world.launch.py'),\n"
        f"            launch_arguments={{'world': {given}}}.items(),\n"
        "        )"
    )
    imports = (
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch.launch_description_sources import PythonLaunchDescriptionSource\n"
    )
    files = {"launch/it.launch.py": imports + LAUNCH.format(action=including), "launch/world.launch.py": INCLUDED}
    told = findings("LCH008", **files)
    assert [finding.place.file.rpartition("/")[2] for finding in told] == said
    for finding in told:
        assert finding.message == (
            "'big' is what this include passes for 'world', and none of its choices: launch stops with a RuntimeError"
        )
        assert finding.related[0].message == "the choices of 'world'"


XML = """\
<launch>
  <arg name="mode" default="{default}">
    <choice value="simulation"/>
    <choice value="robot"/>
  </arg>
  <node pkg="robot" exec="talker" args="$(var mode)"/>
</launch>
"""


def test_in_xml(findings):
    assert findings("LCH008", **{"launch/it.launch.xml": XML.format(default="robot")}) == []
    (told,) = findings("LCH008", **{"launch/it.launch.xml": XML.format(default="robt")})
    assert told.message.startswith("'robt' is the default for 'mode', and none of its choices")
    assert told.help == "write 'robot'"


@pytest.mark.parametrize(
    ("action", "shown"),
    [
        ("GroupAction([PushRosNamespace('left')])", "PushRosNamespace"),
        ("GroupAction([SetEnvironmentVariable('A', '1')])", "SetEnvironmentVariable"),
        ("GroupAction([SetRemap('a', 'b'), SetParameter('c', 1)])", "SetRemap, SetParameter"),
        ("GroupAction(scoped=True, actions=[SetLaunchConfiguration('a', 'b')])", "SetLaunchConfiguration"),
    ],
)
def test_a_group_of_settings_for_nobody(findings, action: str, shown: str):
    (told,) = _told(findings, action)
    assert told.message == f"nothing is in this group that {shown} could be for: what it sets ends with the group"
    assert told.severity is Severity.WARNING


@pytest.mark.parametrize(
    "action",
    [
        "GroupAction([PushRosNamespace('left'), Node(package='robot', executable='talker')])",
        "GroupAction([PushRosNamespace('left'), unknown()])",
        "GroupAction([SetEnvironmentVariable('A', '1')], scoped=False)",
        "SetRemap('a', 'b'), GroupAction([SetRemap('c', 'd')])",
        "GroupAction([])",
        "GroupAction([LogInfo(msg='hello')])",
    ],
)
def test_a_group_that_sets_something_for_somebody(findings, action: str):
    assert _told(findings, action) == []


def test_a_group_of_settings_in_xml(findings):
    (told,) = findings(
        "LCH008",
        **{
            "launch/it.launch.xml": """\
<launch>
  <group>
    <let name="mode" value="fast"/>
  </group>
  <node pkg="robot" exec="talker"/>
</launch>
"""
        },
    )
    assert (told.place.line, told.message[:40]) == (2, "nothing is in this group that SetLaunchC")
    assert (told.help or "").endswith('or write scoped="false"')


@pytest.mark.parametrize(
    ("element", "lacks"),
    [
        ('<node pkg="robot"/>', "this <node> lacks 'exec'"),
        ("<include/>", "this <include> lacks 'file'"),
        ('<let name="speed"/>', "this <let> lacks 'value'"),
        ("<push_ros_namespace/>", "this <push_ros_namespace> lacks 'namespace'"),
        ('<node pkg="robot" exec="talker"><remap from="chatter"/></node>', "this <remap> lacks 'to'"),
        ('<group><node pkg="robot" exec="talker"/><set_remap/></group>', "this <set_remap> lacks 'from' and 'to'"),
        (
            '<include file="$(find-pkg-share robot)/launch/b.launch.xml"><arg name="speed"/></include>',
            "this <arg> lacks 'value'",
        ),
    ],
)
def test_an_element_without_an_attribute_that_it_needs(findings, element: str, lacks: str):
    files = {"launch/b.launch.xml": '<launch><node pkg="robot" exec="talker"/></launch>'}
    (told,) = findings("LCH008", element, **files)
    assert told.message == f"{lacks}, without which launch rejects this file"


@pytest.mark.parametrize(
    "element",
    [
        '<arg name="speed" default="1"/><node pkg="robot" exec="talker" args="$(var speed)"/>',
        '<let name="speed" value=""/>',
        '<node pkg="robot" exec="talker"><remap from="a" to="b"/><env name="A" value="1"/></node>',
        '<node pkg="robot" type="talker"/>',  # LCH005 says what it is called
        '<group><push_ros_namespace namespace="left"/><node pkg="robot" exec="talker"/></group>',
        '<timer period="1.0"><node pkg="robot" exec="talker"/></timer>',
    ],
)
def test_an_element_with_all_that_it_needs(findings, element: str):
    assert findings("LCH008", element) == []


@pytest.mark.parametrize(
    ("push", "lacks"),
    [("left", ["namespace"]), ("{namespace: left}", []), ("{namespace: $(env SIDE)}", []), ("{}", ["namespace"])],
)
def test_an_element_of_yaml_that_is_given_a_text(findings, push: str, lacks: list[str]):
    text = (
        "launch:\n- group:\n"
        f"  - push_ros_namespace: {push}\n"
        "  - node:\n      pkg: robot\n      exec: talker\n      remap:\n      - {from: chatter, to: talk}\n"
    )
    told = findings("LCH008", **{"launch/it.launch.xml": "<launch/>", "launch/a.launch.yaml": text})
    assert [row.message.split("'")[1] for row in told] == lacks
