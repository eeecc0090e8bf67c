"""API001: lines that throw away what their call makes."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import os
from pathlib import Path

import numpy as np
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Election(Node):
    def __init__(self):
        super().__init__('election')
        self.poses = np.zeros((0, 3))
        self.robots = []
        self.sub = self.create_subscription(String, 'robot', self.elect, 10)

    def elect(self, msg):
        {lines}


def main():
    rclpy.init()
    rclpy.spin(Election())


main()
"""


def _node(lines: str) -> str:
    return NODE.format(lines=lines.replace("; ", "\n        "))


@pytest.mark.parametrize(
    ("lines", "message", "cure"),
    [
        (
            "sorted(self.robots, key=len)  # here",
            "sorted() leaves self.robots as it is and returns a new list: this line throws that away",
            "write self.robots = sorted(…)",
        ),
        (
            "np.append(self.poses, [[0.0, 0.0, 0.0]], axis=0)  # here",
            "np.append() leaves self.poses as it is and returns a new array: this line throws that away",
            "write self.poses = np.append(…)",
        ),
        (
            "name = msg.data; name.replace('/', '_')  # here; print(name)",
            "name.replace() leaves name as it is and returns another text: this line throws that away",
            "write name = name.replace(…)",
        ),
    ],
)
def test_a_result_that_is_thrown_away(judge: Judge, lines: str, message: str, cure: str):
    (finding,) = judge("API001", _node(lines))
    assert (finding.message, finding.help) == (message, cure)
    assert finding.severity is Severity.WARNING


@pytest.mark.parametrize(
    "lines",
    [
        "self.robots = sorted(self.robots)",
        "self.robots.sort()",
        "return sorted(self.robots)",
        "sorted(self.announce(robot) for robot in self.robots)",
        "try:;     sorted(self.robots); except TypeError:;     return",
        "sorted = self.get_logger().info; sorted(msg.data)",
        "np.concatenate([self.poses, self.poses], out=self.poses)",
        "np = []; np.append(msg.data, 1)",
        "np.random.shuffle(self.poses)",
        "os.replace('old', 'new')",
        "Path(msg.data).replace('new')",
        "self.table.replace('a', 'b', inplace=True)",
    ],
)
def test_a_result_that_is_used_and_calls_that_change_something(judge: Judge, lines: str):
    judge("API001", _node(lines))
