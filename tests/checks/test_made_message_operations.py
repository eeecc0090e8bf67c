"""MSG003: messages that the code has made itself and takes for numbers or lists."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import math

import rclpy
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point, PoseStamped
from rclpy.node import Node


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.start = Point()
        self.goal = None
        self.either = Point()
        self.timer = self.create_timer(1.0, self.tick)

    def aim(self):
        self.goal = Point(x=1.0)
        self.either = [0.0, 0.0]

    def tick(self):
        here, stamp = Point(), Time()
        there = Point()
        {line}


def main():
    rclpy.init()
    rclpy.spin(Planner())


main()
"""


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("x, y, z = there", "unpacking it into several variables raises TypeError"),
        ("print(there[0])", "taking an item of it raises TypeError"),
        ("print(self.goal[0])", "taking an item of it raises TypeError"),
        ("print(self.goal - self.start)", "'-' with another message raises TypeError"),
        ("print(there + 1.0)", "raises TypeError"),
        ("print([each for each in there])", "a loop over it raises TypeError"),
        ("print(math.sqrt(self.start))", "math.sqrt() of it raises TypeError"),
        ("print(there > 1.0)", "'>' with"),
    ],
)
def test_a_message_that_is_taken_for_something_else(judge: Judge, line: str, says: str) -> None:
    (finding,) = judge("MSG003", NODE.format(line=f"{line}  # here"))
    assert "is a message of type geometry_msgs/msg/Point, and " in finding.message
    assert says in finding.message
    assert finding.help == "use one of its fields"


@pytest.mark.parametrize(
    "line",
    [
        "x, y = there.x, there.y",
        "print(self.goal.x - self.start.x, self.goal == self.start)",
        "print(self.either[0])",
        "there = [1.0, 2.0]\n        print(there[0])",
        "there = there.x\n        print(there + 1.0)",
        "print(isinstance(there, list) and there[0])",
        "print(stamp - stamp)",
        "try:\n            print(there[0])\n        except TypeError:\n            pass",
    ],
)
def test_a_message_of_which_the_code_uses_fields_or_that_may_be_something_else(judge: Judge, line: str) -> None:
    """Stamps are API001's."""
    judge("MSG003", NODE.format(line=line))
