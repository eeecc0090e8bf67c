"""What is told of a program whose file has the name of a test."""

from __future__ import annotations

import pytest

from robot_package import SETUP, TALKER

BROKEN = TALKER.replace("'chatter', 10)", "'chatter', 10)\n        self.create_subscription(String, 'said', 10)")


@pytest.mark.parametrize(
    ("entry", "found"), [("talker = robot.test_talker:main", 1), ("talker = robot.talker:main", 0)]
)
def test_a_call_that_rclpy_refuses_in_a_program(findings, entry, found):
    setup = SETUP.replace("talker = robot.talker:main", entry)
    assert len(findings("API001", **{"setup.py": setup, "robot/test_talker.py": BROKEN})) == found
