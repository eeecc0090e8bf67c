"""EXE011: what is thrown away, or asked, before it can work."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import indent

import pytest

from archlint.finding import Finding
from checks.judging import Judge

NODE = """
import time

import message_filters
import rclpy
from message_filters import ApproximateTimeSynchronizer, TimeSynchronizer
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import Image
from somewhere import hand_over
from std_msgs.msg import String
from tf2_ros import Buffer, TransformListener


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_subscription(String, 'in', self.listen, 10)
        left = message_filters.Subscriber(self, Image, 'left')
        right = message_filters.Subscriber(self, Image, 'right')
{start}

    def listen(self, message):
{lines}

    def on_both(self, left, right):
        self.get_logger().info('both')


def main():
    rclpy.init()
    rclpy.spin(Robot())


if __name__ == '__main__':
    main()
"""
LOOKUP = "lookup_transform('map', 'base', Time())"
LISTEN = "buffer = Buffer()\nlistener = TransformListener(buffer, self)\n"


def node(lines: str = "pass", start: str = "pass") -> str:
    return NODE.format(lines=indent(lines, "        "), start=indent(start, "        "))


@pytest.mark.parametrize(
    "lines",
    [
        f"{LISTEN}buffer.{LOOKUP}  # here",
        f"buffer = Buffer()\nTransformListener(buffer, self)\nprint(buffer.{LOOKUP})  # here",
        f"{LISTEN}self.get_logger().info('wait')\nreturn buffer.{LOOKUP}  # here",
        f"{LISTEN}try:\n    buffer.{LOOKUP}  # here\nexcept Exception:\n    pass",
        f"{LISTEN}now = self.get_clock().now()\nif message.data:\n    buffer.{LOOKUP}  # here",
        f"self.mine = Buffer()\nself.other = TransformListener(self.mine, self)\nself.mine.{LOOKUP}  # here",
    ],
)
def test_a_buffer_that_is_new_each_time(judge: Judge, lines: str):
    [finding] = judge("EXE011", node(lines))
    assert "raises a LookupException: this buffer has just been created" in finding.message


def test_whether_a_new_buffer_can_transform(judge: Judge):
    [finding] = judge(
        "EXE011", node(f"{LISTEN}if not buffer.can_transform('map', 'base', Time()):  # here\n    return")
    )
    assert "can_transform() is False" in finding.message


def test_a_lookup_in_the_constructor(judge: Judge):
    [finding] = judge("EXE011", node(start=f"{LISTEN}buffer.{LOOKUP}  # here"))
    assert finding.help.startswith("look it up later")


@pytest.mark.parametrize(
    "lines",
    [
        f"self.buffer.{LOOKUP}",
        f"{LISTEN}time.sleep(1.0)\nbuffer.{LOOKUP}",
        f"{LISTEN}rclpy.spin_once(self)\nbuffer.{LOOKUP}",
        f"{LISTEN}hand_over(buffer)\nbuffer.{LOOKUP}",
        f"{LISTEN}buffer.set_transform(message, 'me')\nbuffer.{LOOKUP}",
        f"{LISTEN}while not buffer.can_transform('map', 'base', Time()):\n    rclpy.spin_once(self)\nbuffer.{LOOKUP}",
        f"{LISTEN}for _ in range(3):\n    time.sleep(1.0)\n    buffer.{LOOKUP}",
        f"{LISTEN}buffer = self.buffer\nbuffer.{LOOKUP}",
        f"buffer = self.buffer\nbuffer.{LOOKUP}",
        f"buffer = hand_over()\nbuffer.{LOOKUP}",
        f"{LISTEN}buffer.lookup_transform()",
        LISTEN,
        f"{LISTEN}buffer.lookup_transform('map', 'base', Time(), Duration(seconds=1.0))",
    ],
)
def test_a_buffer_that_may_have_got_something(judge: Judge, lines: str):
    assert not judge("EXE011", node(lines))


def test_the_lookup_says_it_for_its_listener(judge: Judge):
    assert not judge("EXE005", node(f"{LISTEN}buffer.{LOOKUP}"))


def test_a_listener_that_is_created_each_time(judge: Judge):
    judge("EXE005", node("buffer = Buffer()\nlistener = TransformListener(buffer, self)  # here"))


@pytest.mark.parametrize(
    "start",
    [
        "TimeSynchronizer([left, right], 10)  # here",
        "both = TimeSynchronizer([left, right], 10)  # here",
        "both = ApproximateTimeSynchronizer([left, right], 10, 0.1)  # here",
        "both = message_filters.TimeSynchronizer([left, right], 10)  # here",
    ],
)
def test_a_synchronizer_without_a_callback(judge: Judge, start: str):
    [finding] = judge("EXE011", node(start=start))
    assert "no callback is registered with it" in finding.message


@pytest.mark.parametrize(
    "start",
    [
        "TimeSynchronizer([left, right], 10).registerCallback(self.on_both)",
        "both = TimeSynchronizer([left, right], 10)\nboth.registerCallback(self.on_both)",
        "self.both = TimeSynchronizer([left, right], 10)\nself.both.registerCallback(self.on_both)",
        "both = TimeSynchronizer([left, right], 10)\nhand_over(both)",
        "both = self.both = TimeSynchronizer([left, right], 10)",
        "self.both = TimeSynchronizer([left, right], 10)\ngetattr(self, 'both').registerCallback(self.on_both)",
        "hand_over(TimeSynchronizer([left, right], 10))",
        "filters = [TimeSynchronizer([left, right], 10)]\nhand_over(filters)",
        "left.registerCallback(print)",
    ],
)
def test_a_synchronizer_that_somebody_may_use(judge: Judge, start: str):
    assert not judge("EXE011", node(start=start))


@pytest.mark.parametrize(
    ("other", "number"),
    [
        ("", 1),
        ("def register(robot, callback):\n    robot.both.registerCallback(callback)\n", 0),
        ("ATTRIBUTE = 'both'\n", 0),
    ],
)
def test_an_attribute_that_another_file_may_use(findings: Callable[..., list[Finding]], other: str, number: int):
    talker = node(start="self.both = TimeSynchronizer([left, right], 10)")
    assert len(findings("EXE011", **{"robot/talker.py": talker, "robot/other.py": other})) == number
