"""API001: operators between times, durations and numbers that rclpy refuses."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import time

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import Image


class Robot(Node):
    def __init__(self, given):
        super().__init__('robot')
        self.start = self.get_clock().now()
        self.last = None
        self.began = time.time()
        self.either = Duration(seconds=1)
        self.either = given
        self.limit = Duration(seconds=2)

    def on_image(self, msg):
        now = self.get_clock().now()
        self.last = now
        waited = now - self.start
        other = waited
        other = 1.0
        {line}
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "return waited > 1.0",
            "'>' fails with a TypeError: an rclpy Duration on its left, a number on its right",
            "write Duration(seconds=…) instead of the number",
        ),
        (
            "return self.get_clock().now() - self.start > self.began",
            "'>' fails with a TypeError: an rclpy Duration on its left, a number on its right",
            "write Duration(seconds=…) instead of the number",
        ),
        (
            "return now + 0.5",
            "'+' fails with a TypeError: an rclpy Time on its left, a number on its right",
            "write Duration(seconds=…) instead of the number",
        ),
        (
            "return waited / 1e9",
            "'/' fails with a TypeError: an rclpy Duration on its left, a number on its right",
            "use its .nanoseconds, which is a number",
        ),
        (
            "return now - msg.header.stamp",
            "'-' fails with a TypeError: an rclpy Time on its left, a stamp message on its right",
            "make a Time of the stamp first: Time.from_msg(…)",
        ),
        (
            "return now - self.began",
            "'-' fails with a TypeError: an rclpy Time on its left, a number on its right",
            "write Duration(seconds=…) instead of the number",
        ),
        (
            "return now > self.limit",
            "'>' fails with a TypeError: an rclpy Time on its left, an rclpy Duration on its right",
            "compare a Time with a Time, and a Duration with a Duration",
        ),
        (
            "return self.last - 1",
            "'-' fails with a TypeError: an rclpy Time on its left, a number on its right",
            "write Duration(seconds=…) instead of the number",
        ),
    ],
)
def test_an_operator_that_rclpy_refuses(judge: Judge, line: str, message: str, help: str):
    (finding,) = judge("API001", NODE.format(line=f"{line}  # here"))
    assert (finding.message, finding.help) == (message, help)


def test_a_stamp_beside_a_time_of_another_clock_than_it_would_get(judge: Judge):
    (finding,) = judge("API001", NODE.format(line="made = Time()\n        return msg.header.stamp - made  # here"))
    assert finding.help == (
        "make a Time of the stamp first, with the clock of the other: Time.from_msg(…, clock_type=….clock_type)"
    )


@pytest.mark.parametrize(
    "line",
    [
        "return waited > Duration(seconds=1.0)",
        "return waited > self.limit",
        "return now + Duration(seconds=0.5)",
        "return waited.nanoseconds / 1e9 > 1.0",
        "return (now - self.start).nanoseconds * 1e-9 > 1.0",
        "return now - Time.from_msg(msg.header.stamp)",
        "return now > self.start",
        "return time.time() - self.began > 1.0",
        "return self.either > 1.0",  # it may be a number
        "return other > 1.0",  # as this one is
        "return waited == 1.0",
        "return waited * 2",  # from lyrical on
        "return msg.header.stamp.sec - 5",
        "return msg.header.stamp == self.last",
        "try:\n            return waited > 1.0\n        except TypeError:\n            return False",
    ],
)
def test_an_operator_that_works(judge: Judge, line: str):
    judge("API001", NODE.format(line=line))


def test_what_another_object_holds_is_not_known(judge: Judge):
    """A message of this file has a stamp, and so has a state that another file makes, where it is a number."""
    lines = (
        "msg.stamp = now.to_msg()",
        "state = given.latest_state()",
        "if state.stamp <= 0.0 or time.time() - state.stamp > 1.0:",
        "    return None",
        "self.stamp = now.to_msg()",
        "return self.stamp > 0.0  # here",
    )
    judge("API001", NODE.format(line="\n        ".join(lines)))


def test_operators_of_a_file_that_fail_alike_are_one_finding(judge: Judge):
    (finding,) = judge("API001", NODE.format(line="return waited > 1.0 or waited > 2.0  # here"))
    assert finding.message.endswith("; another operator in this file does the same")


def test_each_variable_is_worked_out_once(judge: Judge):
    """Each doubles the one before: what is worked out anew for each use would take hours."""
    sums = "\n        ".join(f"sum{n + 1} = sum{n} + sum{n}" for n in range(60))
    line = f"sum0 = 1.0\n        {sums}\n        return self.get_clock().now() - sum60  # here"
    judge("API001", NODE.format(line=line))


def test_an_action_server_wants_a_function(judge: Judge):
    source = """
        from example_interfaces.action import Fibonacci
        from rclpy.action import ActionServer
        from rclpy.node import Node


        class Counter(Node):
            def __init__(self):
                super().__init__('counter')
                self.without = ActionServer(self, Fibonacci, 'one', None)  # here
                self.with_one = ActionServer(self, Fibonacci, 'two', self.count, goal_callback=None)

            def count(self, goal):
                return Fibonacci.Result()
    """
    judge("API001", source)
