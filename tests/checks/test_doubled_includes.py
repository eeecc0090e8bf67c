"""NME004: launch files that are included again, one by one or with a whole stack."""

from __future__ import annotations

import pytest

from robot_package import node

HELPER = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration

def _include(name, **more):
    path = os.path.join(get_package_share_directory('robot'), 'launch', name)
    return IncludeLaunchDescription(AnyLaunchDescriptionSource(path), **more)

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('stack', default_value='true'),
        {}
    ])
"""
DRIVERS = {
    "launch/left.launch.xml": f"<launch>{node(name='left')}</launch>",
    "launch/right.launch.xml": f"<launch>{node(name='right')}</launch>",
}
LEFT, RIGHT, STACK = ("_include('left.launch.xml')", "_include('right.launch.xml')", "_include('stack.launch.py')")
PERHAPS = "_include('stack.launch.py', condition=IfCondition(LaunchConfiguration('stack')))"


def helped(*lines: str) -> str:
    """A launch file whose includes, one a line from line 16 on, a helper makes."""
    return HELPER.replace("{}", "\n        ".join(f"{line}," for line in lines))


@pytest.fixture
def found(findings):
    """What is found in a launch file beside one that starts both drivers: message, line, and the related lines."""

    def run(*lines: str):
        files = {"launch/all.launch.py": helped(*lines), "launch/stack.launch.py": helped(LEFT, RIGHT)}
        told = findings("NME004", **DRIVERS, **files)
        assert {one.place.file for one in told} <= {"launch/all.launch.py"}
        return [(one.message, one.place.line, [each.place.line for each in one.related]) for one in told]

    return run


STACK_AGAIN = (
    "what stack.launch.py includes is included beside it, too (left.launch.xml, right.launch.xml), which starts "
    "2 nodes twice, such as '/left'"
)


@pytest.mark.parametrize(
    ("lines", "place", "beside"),
    [
        ((LEFT, RIGHT, STACK), 18, [16, 17]),
        ((LEFT, RIGHT, PERHAPS), 18, [16, 17]),
        ((STACK, LEFT, RIGHT), 16, [17, 18]),
    ],
)
def test_a_stack_that_comes_again_is_told_once_where_it_is_included(found, lines, place, beside):
    assert found(*lines) == [(STACK_AGAIN, place, beside)]


def test_the_include_of_a_helper_is_where_the_helper_is_called(found):
    again = "this system includes left.launch.xml twice, which starts '/left' twice"
    assert found(LEFT, RIGHT, LEFT) == [(again, 18, [16, 1])]
    assert found(LEFT, RIGHT) == []


def test_a_whole_stack_that_is_included_twice_is_that_include(found):
    again = "this system includes stack.launch.py twice, which starts 2 nodes twice, such as '/left'"
    assert [(message, line) for message, line, _ in found(STACK, STACK)] == [(again, 17)]


def test_a_stack_that_leaves_out_what_is_included_beside_it(found):
    off = "_include('stack.launch.py', condition=IfCondition('false'))"
    assert found(LEFT, RIGHT, off) == []


def _robot(*nodes: str) -> dict[str, str]:
    """A launch file that starts nodes for one robot, and two that include it for two robots each."""
    ways = [
        f'<include file="$(find-pkg-share robot)/launch/robot.launch.xml"><arg name="robot" value="{name}"/></include>'
        for name in ("a", "b")
    ]
    both = f"<launch>\n{ways[0]}\n{ways[1]}\n</launch>"
    lines = "\n".join(('<arg name="robot"/>', *nodes))
    return {
        "launch/robot.launch.xml": f"<launch>\n{lines}\n</launch>",
        "launch/hall.launch.xml": both,
        "launch/yard.launch.xml": both.replace("</launch>", node(name="camera") + "\n</launch>"),
    }


ITS_OWN = node(name="driver", namespace="$(var robot)")


def test_a_node_that_does_not_get_the_namespace_of_each_include_is_told_once_where_it_is(findings):
    (found,) = findings("NME004", **_robot(ITS_OWN, node(name="marker")))
    assert (found.place.file, found.place.line) == ("launch/robot.launch.xml", 4)
    assert found.message == (
        "robot.launch.xml is included twice, each time with another namespace for its nodes, but '/marker' gets none: "
        "it is started twice under one name"
    )
    assert found.help == "give it namespace=, too, or start it once, outside of robot.launch.xml"
    assert [(row.place.line, row.message) for row in found.related] == [
        (3, "this one gets the namespace"),
        (2, "it is first included here"),
        (3, "it is included again here"),
    ]
    (taken,) = findings("NME004", **_robot(ITS_OWN, node(name="driver")))  # the namespace has one of that name
    assert taken.help == "start it once, outside of robot.launch.xml"
    (several,) = findings("NME004", **_robot(node(name="map"), ITS_OWN, node(name="marker")))
    assert "2 get none, such as '/map': they are started twice" in several.message
    assert (several.place.line, several.related[0].place.line) == (3, 5)


def test_a_file_that_is_included_twice_and_gives_no_node_a_namespace_is_told_at_each_include(findings):
    told = findings("NME004", **_robot(node(name="marker")))
    assert {row.place.file for row in told} <= {"launch/hall.launch.xml", "launch/yard.launch.xml"}
    assert {row.help for row in told} == {"include it once, or in a different namespace each time"}
    assert findings("NME004", **_robot(ITS_OWN)) == []
