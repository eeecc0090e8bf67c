"""LCH008: what stands among actions and is none, and a declaration where a condition wants a value."""

from __future__ import annotations

import pytest

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, OpaqueFunction, TimerAction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode
from elsewhere import unknown

def generate_launch_description():
    talk = DeclareLaunchArgument('talk', default_value='true')
    side = DeclareLaunchArgument('side', default_value='left')
    {before}
    description = LaunchDescription([talk, {action}])
    {behind}
    return description
"""


def _told(findings, action: str, before: str = "", behind: str = ""):
    text = LAUNCH.format(action=action, before=before or "pass", behind=behind or "pass")
    return findings("LCH008", **{"launch/it.launch.py": text})


COMPONENT = "ComposableNode(package='robot', plugin='robot::Talker')"


@pytest.mark.parametrize(
    ("action", "of"),
    [
        ("LaunchConfiguration('side')", "LaunchConfiguration"),
        ("TextSubstitution(text='a')", "TextSubstitution"),
        (COMPONENT, "ComposableNode"),
        (f"side, GroupAction([{COMPONENT}])", "ComposableNode"),
        ("side, TimerAction(period=1.0, actions=[LaunchConfiguration('side')])", "LaunchConfiguration"),
    ],
)
def test_what_is_no_action_among_actions(findings, action: str, of: str):
    told = [row for row in _told(findings, action) if "among" in row.message]
    assert [row.message for row in told] == [
        f"this {of} stands among actions, and is none: launch stops with an AttributeError"
    ]


def test_what_is_added_later(findings):
    [told] = _told(findings, "side", behind=f"description.add_action({COMPONENT})")
    assert "this ComposableNode stands among actions" in told.message
    assert (
        told.help == "put it into composable_node_descriptions= of a ComposableNodeContainer or of LoadComposableNodes"
    )


def test_a_variable_of_a_declaration_that_is_given_the_value(findings):
    rows = _told(findings, "side", before="side = LaunchConfiguration('side')")
    [told] = [row for row in rows if "among" in row.message]
    assert told.help == "put the DeclareLaunchArgument of 'side' into the list in place of it"


def test_the_value_of_an_argument_that_the_list_declares(findings):
    [told] = _told(findings, "side, LaunchConfiguration('side')")
    assert told.help == "take it out of the list: a substitution is for the arguments of actions"


@pytest.mark.parametrize("condition", ["IfCondition", "UnlessCondition"])
def test_a_condition_with_the_declaration_of_an_argument(findings, condition: str):
    [told] = _told(findings, f"side, Node(package='robot', executable='talker', condition={condition}(talk))")
    assert told.message == (
        f"this {condition} is given a DeclareLaunchArgument, which has no value: a TypeError stops launch"
    )
    assert told.help == f"write {condition}(LaunchConfiguration('talk')), of launch.substitutions"


@pytest.mark.parametrize(
    "action",
    [
        f"side, LoadComposableNodes(target_container='c', composable_node_descriptions=[{COMPONENT}])",
        "side, ComposableNodeContainer(package='rclcpp_components', executable='component_container', name='c', "
        f"namespace='', composable_node_descriptions=[{COMPONENT}])",
        "side, Node(package='robot', executable='talker', condition=IfCondition(LaunchConfiguration('talk')))",
        "side, Node(package='robot', executable='talker', condition=IfCondition([LaunchConfiguration('talk')]))",
        "side, Node(package='robot', executable='talker', condition=UnlessCondition('true'))",
        "side, Node(package='robot', executable='talker', arguments=[LaunchConfiguration('side')])",
        "side, unknown, unknown('side')",
        "side, OpaqueFunction(function=lambda context: [])",
    ],
)
def test_actions(findings, action: str):
    assert _told(findings, action) == []


def test_a_class_of_its_own_that_derives_from_an_action(findings):
    before = "\n    class Mine(GroupAction):\n        pass\n"
    assert _told(findings, "side, Mine([])", before=before) == []
