"""LCH003: declarations of launch arguments that come after what reads them."""

from __future__ import annotations

IMPORTS = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushRosNamespace

def generate_launch_description():
"""

ADDED = (
    IMPORTS
    + """\
    side = DeclareLaunchArgument('side', default_value='left')
    speed = DeclareLaunchArgument('speed', default_value='fast')
    talker = Node(
        package='robot',
        executable='talker',
        name=LaunchConfiguration('speed'),
        namespace=LaunchConfiguration('side'),
    )
    it = LaunchDescription()
    it.add_action(talker)
    it.add_action(side)
    it.add_action(speed)
    return it
"""
)


def test_what_is_added_too_late_is_one_finding(findings):
    """One change of the order mends both."""
    (told,) = findings("LCH003", **{"launch/a.launch.py": ADDED})
    assert told.place.line == 17
    assert told.message == "the launch arguments 'side', 'speed' are read before they are declared"
    assert told.help == "put 'side' before 'talker' in the LaunchDescription: actions run in that order"
    in_order = ADDED.replace("    it.add_action(talker)\n", "").replace(
        "    return", "    it.add_action(talker)\n    return"
    )
    assert findings("LCH003", **{"launch/a.launch.py": in_order}) == []


KEPT = (
    IMPORTS
    + """\
    side = LaunchConfiguration('side')
    return LaunchDescription([
        PushRosNamespace(side),
        DeclareLaunchArgument('side', default_value={default}),
        Node(package='robot', executable='talker'),
    ])
"""
)


def test_a_variable_that_an_action_further_down_is_given(findings):
    """Nothing is wrong with the variable: the action that gets it comes too early."""
    (told,) = findings("LCH003", **{"launch/a.launch.py": KEPT.format(default="'left'")})
    assert told.place.line == 10
    assert [(row.place.line, row.message) for row in told.related] == [
        (7, "'side' is read here"),
        (9, "for this action"),
    ]


def test_a_default_that_reads_itself_is_told_before_the_order(findings):
    """In the right order the launch would fail as well."""
    (told,) = findings("LCH003", **{"launch/a.launch.py": KEPT.format(default="side")})
    assert (told.place.line, told.message) == (
        10,
        "the default of the launch argument 'side' is 'side' itself: without a value the launch fails",
    )
