"""What catkin_pkg refuses in a package.xml; each of these was held against catkin_pkg 1.1.1."""

from __future__ import annotations

import pytest

from archlint.workspace.refused_manifests import refusals

GOOD = """<?xml version="1.0"?>
<package format="3">
  <name>robot</name>
  <version>0.1.0</version>
  <description>An example</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>MIT</license>
  <depend>rclpy</depend>
</package>
"""
AMENT = "<build_type>ament_cmake</build_type>"
CATKIN = '<build_type condition="$ROS_VERSION == 1">catkin</build_type>'
TWO_TYPES = ("there are 2 <build_type>s", "keep one of them")


def changed(old: str, new: str) -> str:
    assert old in GOOD
    return GOOD.replace(old, new)


@pytest.mark.parametrize(
    ("text", "line", "what", "help"),
    [
        (
            changed("ada@example.org", "ada@laptop"),
            6,
            "'ada@laptop' is no email address",
            "write one like name@example.com",
        ),
        (changed(' email="ada@example.org"', ""), 6, "the maintainer has no email", 'add email="…"'),
        (
            changed("<maintainer", '<author email="ada">Ada</author><maintainer'),
            6,
            "'ada' is no email address",
            "write one like name@example.com",
        ),
        (changed("0.1.0", "0.1"), 4, "'0.1' is no version of three numbers", "write one like 0.1.0"),
        (changed("  <version>0.1.0</version>\n", ""), 1, "there is no <version>", "add a <version>"),
        (changed("An example", " "), 5, "<description> is empty", "write something into it"),
        (
            changed("<license>MIT</license>", "<license/>"),
            7,
            "<license> is empty",
            "write the name of the license into it",
        ),
        (
            changed("</depend>", "</depend>\n  <exec_depend>rclpy</exec_depend>"),
            9,
            "'rclpy' has a <depend> and a <exec_depend>",
            "keep one: <depend> covers both",
        ),
        (changed("rclpy", "robot"), 8, "'robot' depends on itself", "remove the line"),
        (
            changed("<depend>rclpy</depend>", "<run_depend>rclpy</run_depend>"),
            8,
            "there is no <run_depend> in format 3",
            "write <exec_depend>",
        ),
        (changed(' format="3"', ""), 8, "there is no <depend> in format 1", 'write <package format="3">'),
        (
            changed("</package>", "<build_type>ament_cmake</build_type></package>"),
            9,
            "there is no <build_type> in format 3",
            "move it into <export>",
        ),
        (
            changed('format="3"', 'format="2"').replace("<depend>", '<depend condition="$ROS_VERSION == 2">'),
            8,
            "<depend> has no attribute 'condition' in format 2",
            'write <package format="3">',
        ),
        (
            changed("rclpy</depend>", "rclpy<b/></depend>"),
            8,
            "<b> cannot stand inside <depend>",
            "write it beside the other one",
        ),
        (
            changed("</depend>", "</depend>\n  <depend>rclpy</depend>"),
            9,
            "'rclpy' has two <depend>s",
            "remove one of them",
        ),
        (changed("</name>", "</name>\n  <name>robot2</name>"), 4, "there are 2 <name>s", "keep one of them"),
        (
            changed("</package>", "<export/>\n<export/></package>"),
            10,
            "there are 2 <export>s",
            "put all into one of them",
        ),
        (changed('format="3"', 'format="4"'), 2, "there is no format '4'", 'write <package format="3">'),
        (changed('format="3"', 'format="3" version="1"'), 2, "<package> has no attribute 'version'", "remove it"),
        (
            changed("<depend>", '<depend condition="$ROS_VERSION = 2">'),
            8,
            "'$ROS_VERSION = 2' is no condition",
            "write one like $ROS_VERSION == 2",
        ),
        (
            changed("</package>", f"<export>{AMENT}\n{CATKIN.replace('==', 'is')}</export></package>"),
            10,
            "'$ROS_VERSION is 1' is no condition",
            "write one like $ROS_VERSION == 2",
        ),
        (changed("</package>", f"<export>{AMENT}\n{AMENT}</export></package>"), 10, *TWO_TYPES),
        (
            changed("</depend>", "</depend>\n<member_of_group>arms</member_of_group><group_depend>arms</group_depend>"),
            9,
            "'arms' is a group of the package, which depends on that",
            "remove the line",
        ),
    ],
)
def test_what_is_refused(text, line, what, help):
    (refusal,) = refusals(text)
    assert (refusal.line, refusal.what, refusal.help) == (line, what, help)


@pytest.mark.parametrize(
    "text",
    [
        GOOD,
        changed("<maintainer", "<author>Ada</author><maintainer"),
        changed("An example", "<b>An</b> example"),
        changed("MIT</license>", 'MIT</license><license file="LICENSE">BSD</license>'),
        changed("</depend>", "</depend><test_depend>rclpy</test_depend>"),
        changed("</depend>", '</depend><exec_depend version_gte="1.0">rclpy</exec_depend>'),
        changed("</package>", "<export><build_type>ament_cmake</build_type></export></package>"),
        changed("</package>", f"<export>{CATKIN}{AMENT}</export></package>"),
        changed("<depend>", "<depend condition=\"$ROS_VERSION == 2 and ($ROS_DISTRO != 'foxy')\">"),
        changed("</depend>", "</depend> and <depend version_gte='1.0.0'>rclpy</depend>"),
        changed("<depend>rclpy</depend>", "<exec_depend>rclpy</exec_depend><exec_depend>rclpy</exec_depend>"),
        changed('format="3"', 'format="3" xmlns="http://example.org" xmlns:xsi="http://example.org"'),
        "<package><name>robot</name><license/></package>",
        "<package><name>robot",
        '<!DOCTYPE package [<!ENTITY a "b">]>' + GOOD.partition("\n")[2],
    ],
)
def test_what_is_not(text):
    assert refusals(text) == []
