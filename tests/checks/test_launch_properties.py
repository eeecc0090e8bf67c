"""API002: properties of launch's actions that a launch file assigns."""

from __future__ import annotations

import pytest

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import GroupAction, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch_ros.actions import Node
from robot.actions import Talker

def start(given=None):
    {}
    return action

def generate_launch_description():
    return LaunchDescription([start()])
"""
NODE = "action = Node(package='robot', executable='talker')"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        pytest.param([NODE, "action.condition = IfCondition('true')"], True, id="a node"),
        pytest.param([NODE, "if given:", "    action.condition = given"], True, id="in a branch"),
        pytest.param(["action = GroupAction([])", "action.condition = given"], True, id="a group"),
        pytest.param(["action = Talker()", "action.condition = given"], False, id="a class of somebody else"),
        pytest.param(["action = given", "action.condition = IfCondition('true')"], False, id="nobody knows"),
        pytest.param([NODE, "given.condition = IfCondition('true')"], False, id="a parameter"),
        pytest.param([NODE, "action = Talker(action)", "action.condition = given"], False, id="it is wrapped"),
        pytest.param([NODE, "for action in given:", "    action.condition = 1"], False, id="another of that name"),
        pytest.param([NODE, "action, other = given", "action.condition = 1"], False, id="unpacked"),
        pytest.param([NODE, "action.conditions = given"], False, id="an attribute of their own"),
        pytest.param(
            [NODE, "try:", "    action.condition = given", "except AttributeError:", "    pass"], False, id="tried"
        ),
    ],
)
def test_the_condition_of_an_action_is_given_to_its_constructor(findings, lines: list[str], told: bool):
    text = LAUNCH.replace("{}", "\n    ".join(lines))
    found = findings("API002", **{"launch/it.launch.py": text, "robot/actions.py": "class Talker:\n    pass\n"})
    assert [one.message.partition(" that ")[0] for one in found] == (
        [f"'condition' is a property of {'GroupAction' if 'Group' in lines[0] else 'Node'}"] if told else []
    )
    assert [text.splitlines()[one.place.line - 1].strip().startswith("action.condition =") for one in found] == (
        [True] if told else []
    )
