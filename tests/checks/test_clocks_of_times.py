"""API001: times of two clocks between which rclpy has no operators."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import Header


class Watch(Node):
    def __init__(self):
        super().__init__('watch')
        self.began = Time()
        self.last = Time()
        self.started = self.get_clock().now()
        self.of_ros = Time(clock_type=ClockType.ROS_TIME)
        self.running = False
        self.timer = self.create_timer(1.0, self.tick)
        self.create_subscription(Header, 'header', self.on_header, 10)

    def on_header(self, header):
        sent = Time.from_msg(header.stamp)
        {on_header}

    def tick(self):
        now = self.get_clock().now()
        {tick}


def main():
    rclpy.init()
    rclpy.spin(Watch())


main()
"""


@pytest.mark.parametrize(
    ("expression", "sides"),
    [
        ("now - Time()", ("ROS_TIME", "SYSTEM_TIME")),
        ("now - self.began", ("ROS_TIME", "SYSTEM_TIME")),
        ("now - Clock().now()", ("ROS_TIME", "SYSTEM_TIME")),
        ("Time(seconds=3) > now", ("SYSTEM_TIME", "ROS_TIME")),
        ("self.started < self.began", ("ROS_TIME", "SYSTEM_TIME")),
        ("Clock(clock_type=ClockType.STEADY_TIME).now() - now", ("STEADY_TIME", "ROS_TIME")),
    ],
)
def test_times_of_two_clocks(judge: Judge, expression: str, sides: tuple[str, str]) -> None:
    (finding,) = judge("API001", NODE.format(on_header="pass", tick=f"print({expression})  # here"))
    left, right = sides
    operator = next(part for part in expression.split() if part in "-<>")
    told = f"'{operator}' fails with a TypeError: a Time of {left} on its left, one of {right} on its right"
    assert finding.message == told


def test_the_time_of_a_stamp(judge: Judge) -> None:
    judge("API001", NODE.format(on_header="print(sent - self.began)  # here", tick="pass"))


def test_a_time_that_is_replaced_further_down(judge: Judge) -> None:
    """The first time that the timer runs, it is the one of the constructor."""
    lines = "passed = now - self.last  # here\n        self.last = now\n        print(passed)"
    judge("API001", NODE.format(on_header="pass", tick=lines))


@pytest.mark.parametrize(
    "lines",
    [
        "print(now - self.of_ros, now - self.started)",
        "print(now - Time(seconds=1, clock_type=ClockType.ROS_TIME))",
        "print(Time(seconds=3) - Time(), Clock().now() - self.began)",
        "print(now == self.began)",
        "if self.running:\n            print(now - self.last)\n        self.last, self.running = now, True",
        "if self.running:\n            print(now - self.last)\n        self.last = now",
        "if not self.running:\n            self.last = now\n            return\n        print(now - self.last)\n"
        "        self.last = now",
        "self.last = now\n        print(now - self.last)",
        "try:\n            print(now - Time())\n        except TypeError:\n            pass",
    ],
)
def test_times_of_one_clock_or_of_one_that_is_not_certain(judge: Judge, lines: str) -> None:
    judge("API001", NODE.format(on_header="print(sent - self.started)", tick=lines))


def test_a_time_that_another_callback_replaces(judge: Judge) -> None:
    judge("API001", NODE.format(on_header="self.last = sent", tick="print(now - self.last)\n        self.last = now"))
