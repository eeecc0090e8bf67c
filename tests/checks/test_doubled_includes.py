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
