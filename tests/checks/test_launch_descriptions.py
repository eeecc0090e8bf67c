"""LCH008: what a launch file returns, and what it gives launch that is no list.

What launch says of each was tried with launch of Jazzy.
"""

from __future__ import annotations

import pytest

from archlint.finding import Severity

FILE = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node

def generate_launch_description():
    talker = Node(package='robot', executable='talker', {given})
    {rest}
"""


def _file(rest: str = "return LaunchDescription([talker])", given: str = "") -> dict[str, str]:
    return {"launch/it.launch.py": FILE.format(rest=rest, given=given)}


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        ("LaunchDescription([talker])", "generate_launch_description() returns nothing"),
        ("return None if LaunchDescription([talker]) else None", None),
        ("return [talker]", "generate_launch_description() returns a list"),
        ("return LaunchDescription([talker]), 1", "generate_launch_description() returns a tuple"),
        ("return Node(package='robot', executable=talker)", "generate_launch_description() returns a single Node"),
        (
            "return LaunchDescription(Node(package='robot', executable=talker))",
            "LaunchDescription() is given a single Node, and launch wants a list",
        ),
        ("return LaunchDescription([[talker]])", "a list stands in the list of LaunchDescription()"),
        ("return LaunchDescription(['talker', talker])", "a string stands in the list of LaunchDescription()"),
        ("ld = LaunchDescription([talker])\n    return ld", None),
        ("return LaunchDescription([*[talker]])", None),
        ("return LaunchDescription((talker,))", None),
        ("return LaunchDescription([talker] + [LogInfo(msg='a')])", None),
        ("raise RuntimeError(talker)", None),
    ],
)
def test_what_a_launch_file_returns(findings, rest, message):
    told = findings("LCH008", **_file(rest))
    assert [one.severity for one in told] == [Severity.ERROR] * (message is not None)
    assert all(message in one.message for one in told)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("parameters={'rate': 1.0}", "parameters= of Node is given a dict, and launch wants a list"),
        ("parameters='config/p.yaml'", "parameters= of Node is given a string, and launch wants a list"),
        ("parameters=[{'rate', 1.0}]", "a set stands in parameters= of Node, where launch wants {'name': value}"),
        ("remappings={'a': 'b'}", "remappings= of Node is given a dict, and launch wants a list"),
        ("remappings=('a', 'b')", "a string stands in remappings= of Node, where launch wants ('from', 'to')"),
        ("remappings=[['a', 'b']]", "a list stands in remappings= of Node, where launch wants ('from', 'to')"),
        ("arguments='--fast'", "arguments= of Node is given a string, and launch wants a list"),
        ("parameters=[{'rate': 1.0}, 'config/p.yaml']", None),
        ("parameters=[]", None),
        ("remappings=[('a', 'b')]", None),
        ("remappings=(('a', 'b'),)", None),
        ("arguments=['--fast']", None),
        ("parameters=list(())", None),
    ],
)
def test_what_a_node_is_given(findings, given, message):
    told = findings("LCH008", **_file(given=given))
    assert len(told) == (message is not None)
    assert all(message in one.message for one in told)


def test_an_action_that_nothing_adds(findings):
    (told,) = findings("LCH008", **_file("return LaunchDescription([])"))
    assert told.message.startswith("nothing adds 'talker' to the launch description") and told.place.line == 6
    assert told.severity is Severity.INFO


@pytest.mark.parametrize(
    "rest",
    [
        "return LaunchDescription([\n        # talker,\n    ])",  # somebody has taken it out
        "ld = LaunchDescription()\n    ld.add_action(talker)\n    return ld",
        "return LaunchDescription(list(locals().values()))",
    ],
)
def test_an_action_that_may_be_added_or_is_put_aside(findings, rest):
    assert findings("LCH008", **_file(rest)) == []
