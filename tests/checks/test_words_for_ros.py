"""LCH001: words behind --ros-args at which a node ends."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding
from robot_package import node

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='robot', executable='talker', {}),
    ])
"""
Findings = Callable[..., list[Finding]]


def _told(findings: Findings, given: str) -> list[tuple[str, str]]:
    found = findings("LCH001", **{"launch/talk.launch.py": LAUNCH.format(given)})
    return [(row.message, row.help) for row in found]


@pytest.mark.parametrize(
    ("given", "word", "help"),
    [
        ("arguments=['--ros-args', 'rate:=1.0']", "rate:=1.0", "write '-p', 'rate:=1.0'"),
        ("arguments=['--ros-args', '--log-level debug']", "--log-level debug", "write '--log-level', 'debug'"),
        ("ros_arguments=['--log_level', 'debug']", "--log_level", "write '--log-level'"),
        ("arguments=['-v', '--ros-args', '-p', 'rate:=1.0', '--params', 'a.yaml']", "--params", "write '--param'"),
        ("arguments=['--ros-args', '--disable-stdout']", "--disable-stdout", ""),
    ],
)
def test_a_word_at_which_a_node_ends(findings: Findings, given: str, word: str, help: str):
    [(message, cure)] = _told(findings, given)
    assert message == f"'{word}' behind --ros-args is no argument of ROS: 'talker' ends with an UnknownROSArgsError"
    assert cure.startswith(help)


def test_several_words_in_one_text(findings: Findings):
    [(message, cure)] = _told(findings, "arguments=['--ros-args --log-level debug']")
    assert message == (
        "'--ros-args --log-level debug' is one word, and not the --ros-args that 'talker' is to be given: it has no "
        "effect"
    )
    assert cure == "write '--ros-args', '--log-level', 'debug'"


@pytest.mark.parametrize(
    "given",
    [
        "arguments=['--ros-args', '-p', 'rate:=1.0', '--log-level', 'debug', '--disable-rosout-logs']",
        "arguments=['--ros-args', '-r', '__ns:=/left', '--', 'rate:=1.0']",
        "arguments=['rate:=1.0', '--verbose', '--ros-args']",
        "arguments=['--ros-args', EnvironmentVariable('FLAG'), 'debug']",
        "arguments=['--ros-args', '-p', EnvironmentVariable('RATE')]",
        "arguments=['--ros-args', '--remap', 'a:=b', '-e', '/enclave', '--params-file', 'a.yaml']",
        "ros_arguments=['--ros-args', '--log-level', 'info', '--log-file-name', 'talk']",
        "arguments=EnvironmentVariable('WORDS')",
    ],
)
def test_words_that_ros_takes_or_may(findings: Findings, given: str):
    assert _told(findings, given) == []


def test_a_launch_file_in_xml_has_its_words_split(findings: Findings):
    assert findings("LCH001", node(args="--ros-args --log-level debug")) == []
    (told,) = findings("LCH001", node(args="--ros-args --log-level debug --verbose"))
    assert told.message.startswith("'--verbose' behind --ros-args")
