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


# --------------------------------------------------------------------------------------- one that another one replaces

REPLACED = """
import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.ends = []
{lines}

    def use(self):
        self.end.publish(String())


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""
PUBLISHER = "self.end = self.create_publisher(String, '{}', 10)"


def replaced(judge: Judge, *lines: str) -> list[Finding]:
    return judge("EXE011", REPLACED.replace("{lines}", indent("\n".join(lines), " " * 8)))


def test_a_publisher_that_another_one_replaces(judge: Judge):
    first, second = PUBLISHER.format("state"), PUBLISHER.format("mode")
    (finding,) = replaced(judge, f"{first}  # here", "self.count = 0", second)
    assert finding.message == (
        "nothing can use this publisher of 'state': self.end gets another one before anything has used it"
    )
    assert [row.place.line for row in finding.related] == [15]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("end = self.create_client(Trigger, 'a')", "end = self.create_client(Trigger, 'b')\nprint(end)"),
        ("self.end = ActionClient(self, Fibonacci, 'a')", "self.end = ActionClient(self, Fibonacci, 'b')"),
    ],
)
def test_a_client_that_another_one_replaces(judge: Judge, first: str, second: str):
    replaced(judge, f"{first}  # here", second)


@pytest.mark.parametrize(
    "between",
    [
        "self.ends.append(self.end)",
        "self.end.publish(String())",
        "self.use()",
        "state = self.end",
        "if self.ends:\n    self.use()",
    ],
)
def test_a_publisher_that_is_used_in_between(judge: Judge, between: str):
    replaced(judge, PUBLISHER.format("state"), between, PUBLISHER.format("mode"))


@pytest.mark.parametrize(
    "lines",
    [
        (PUBLISHER.format("state"), PUBLISHER.format("state")),
        ("self.end = self.create_publisher(String, name(), 10)", PUBLISHER.format("mode")),
        ("if rclpy.ok():", "    " + PUBLISHER.format("state"), "else:", "    " + PUBLISHER.format("mode")),
        (PUBLISHER.format("state"), "if rclpy.ok():", "    " + PUBLISHER.format("mode")),
        (PUBLISHER.format("state"), "self.end = self.create_client(Trigger, 'b')"),
        ("self.other = self.create_publisher(String, 'a', 10)", "self.other = self.create_publisher(String, 'b', 10)"),
        (
            "self.sub = self.create_subscription(String, 'a', print, 10)",
            "self.sub = self.create_subscription(String, 'b', print, 10)",
        ),
        ("self.timer = self.create_timer(1.0, self.use)", "self.timer = self.create_timer(2.0, self.use)"),
    ],
)
def test_ends_that_work_or_may_be_meant(judge: Judge, lines: tuple[str, ...]):
    replaced(judge, *lines)
