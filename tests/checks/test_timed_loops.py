"""EXE012: loops of callbacks that go round until a known time has passed."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

NODE = """
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.duration import Duration
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool, String

TURN = 1.5


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(String, 'command', self.on_command, 10)
        {other}
        self.limit = 2.0
        self.busy = False

    def on_command(self, command):
{body}

    def drive(self, seconds):
{drive}

    def on_stop(self, stop):
        self.busy = False


def main():
    rclpy.init()
    node = Driver()
    {spin}


if __name__ == '__main__':
    main()
"""
STOP = "self.create_subscription(Bool, 'stop', self.on_stop, 10)"
START = "start = time.time(); "


def _judge(
    judge: Judge, body: str, drive: str = "pass", other: str = STOP, spin: str = "rclpy.spin(node)"
) -> list[str]:
    lines = [indent(part.replace("; ", "\n"), " " * 8) for part in (body, drive)]
    findings = judge("EXE012", NODE.format(body=lines[0], drive=lines[1], other=other, spin=spin))
    return [finding.message for finding in findings]


@pytest.mark.parametrize(
    ("body", "seconds"),
    [
        (START + "while time.time() - start < 3:  # here; \n    self.pub.publish(Twist())", 3),
        (START + "while (time.time() - start) <= TURN:  # here; \n    self.pub.publish(Twist())", 1.5),
        (START + "while rclpy.ok() and time.time() - start < self.limit:  # here; \n    pass", 2),
        ("end = time.monotonic() + 2; while time.monotonic() < end:  # here; \n    pass", 2),
        ("end = time.monotonic() + 2; while end > time.monotonic():  # here; \n    pass", 2),
        (
            "t = self.get_clock().now(); "
            "while self.get_clock().now() - t < Duration(seconds=4):  # here; \n    self.pub.publish(Twist())",
            4,
        ),
        (
            "t = self.get_clock().now(); while (self.get_clock().now() - t).nanoseconds / 1e9 < 3:  # here; \n    pass",
            3,
        ),
        ("t = self.get_clock().now(); while (self.get_clock().now() - t).nanoseconds < 3e9:  # here; \n    pass", 3),
        (
            "t = self.get_clock().now().nanoseconds; "
            "while self.get_clock().now().nanoseconds - t < 3 * 1e9:  # here; \n    pass",
            3,
        ),
    ],
)
def test_a_loop_for_a_time(judge: Judge, body: str, seconds: float):
    (message,) = _judge(judge, body.replace("; \n", "\n"))
    assert message == (
        f"the callback of a subscription, Driver.on_command, loops until {seconds:g} s have passed: everything else on "
        "its thread has to wait"
    )


def test_a_loop_in_a_method_that_gets_the_time(judge: Judge):
    drive = "start = time.time(); while time.time() - start < seconds:  # here; \n    pass".replace("; \n", "\n")
    (message,) = _judge(judge, "if command.data == 'go':\n    self.drive(2.5)", drive)
    assert "loops in drive() until 2.5 s have passed" in message


@pytest.mark.parametrize(
    "body",
    [
        START + "while time.time() - start < 0.3:\n    pass",
        START + "while time.time() - start < 3:\n    time.sleep(0.1)",
        START + "while time.time() - start < 3:\n    if not self.busy:\n        break",
        START + "while time.time() - start < 3 and self.busy:\n    pass",
        START + "while time.time() - start < float(command.data):\n    pass",
        "if time.time() - self.limit < 3:\n    pass",
        "while time.time() - self.limit < 3:\n    pass",
        "self.drive(float(command.data))",
        "self.drive(0.1)",
    ],
)
def test_loops_that_are_short_or_of_no_known_time(judge: Judge, body: str):
    assert _judge(judge, body, "start = time.time(); while time.time() - start < seconds:\n    pass") == []


def test_a_callback_beside_which_nothing_waits(judge: Judge):
    """It has nothing else to do, or other threads do it."""
    body = START + "while time.time() - start < 3:\n    pass"
    assert _judge(judge, body, other="pass") == []
    groups = (
        "from rclpy.callback_groups import ReentrantCallbackGroup\n        "
        "self.create_subscription(Bool, 'stop', self.on_stop, 10, callback_group=ReentrantCallbackGroup())"
    )
    spin = "rclpy.spin(node, executor=MultiThreadedExecutor())"
    assert _judge(judge, body, other=groups, spin=spin) == []


def test_a_program_that_has_not_begun_to_spin(judge: Judge):
    body = START + "while time.time() - start < 3:\n    pass"
    assert _judge(judge, "pass", body, spin="node.drive(3.0)\n    rclpy.spin(node)") == []
