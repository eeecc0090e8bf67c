"""MSG003: messages inside messages, given to functions of the workspace that take numbers apart."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from geometry_msgs.msg import PoseStamped
from rclpy.node import Node


def to_euler(q):
    x, y, z, w = q
    return x + y, z + w


def first(values):
    return values[0]


def total(values):
    return sum(abs(value) for value in values)


def length(point):
    if isinstance(point, list):
        return point[0]
    return point.x


def either(point):
    if hasattr(point, 'x'):
        return point.x
    return point[0]


def known(point):
    point = [point.x, point.y]
    return point[0]


def tried(point):
    try:
        return point[0]
    except TypeError:
        return point.x


class Chaser(Node):
    def __init__(self):
        super().__init__('chaser')
        self.sub = self.create_subscription(PoseStamped, 'goal', self.chase, 10)

    def chase(self, msg):
        {lines}

    def second(self, values):
        return values[1]


def main():
    rclpy.init()
    rclpy.spin(Chaser())


main()
"""


def _node(lines: str) -> str:
    return NODE.replace("{lines}", lines.replace("; ", "\n        "))


@pytest.mark.parametrize(
    ("lines", "name", "line"),
    [
        ("print(to_euler(msg.pose.orientation))  # here", "to_euler", 7),
        ("print(to_euler(q=msg.pose.orientation))  # here", "to_euler", 7),
        ("print(first(msg.pose.position))  # here", "first", 12),
        ("print(total(msg.pose.position))  # here", "total", 16),
        ("print(self.second(msg.pose.position))  # here", "second", 52),
    ],
)
def test_a_message_that_a_function_takes_apart(judge: Judge, lines: str, name: str, line: int):
    (finding,) = judge("MSG003", _node(lines))
    assert finding.message.endswith(f", which {name}() takes apart: that raises TypeError")
    assert [row.place.line for row in finding.related] == [line]


def test_what_it_says(judge: Judge):
    (finding,) = judge("MSG003", _node("print(to_euler(msg.pose.orientation))  # here"))
    assert finding.message == (
        "'orientation' of geometry_msgs/msg/Pose is a geometry_msgs/msg/Quaternion, which to_euler() takes apart: "
        "that raises TypeError"
    )
    assert finding.help == "give to_euler() a list of the fields of the message, or let it use them by their names"
    assert [row.message for row in finding.related] == ["to_euler() takes 'q' apart here"]


@pytest.mark.parametrize(
    "lines",
    [
        "q = msg.pose.orientation; print(to_euler([q.x, q.y, q.z, q.w]))",
        "print(first(msg.header.frame_id))",
        "print(length(msg.pose.position))",
        "print(either(msg.pose.position))",
        "print(known(msg.pose.position))",
        "print(tried(msg.pose.position))",
        "try:;     print(first(msg.pose.position)); except TypeError:;     return",
    ],
)
def test_a_function_that_does_not_or_asks_first(judge: Judge, lines: str):
    judge("MSG003", _node(lines))
