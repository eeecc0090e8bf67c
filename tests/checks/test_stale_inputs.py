"""TOP007: timers that go on commanding from a stored message, however old it is."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

NODE = """
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.distance = None
        self.publisher = self.create_publisher({type}, 'out', 10)
        self.create_subscription(LaserScan, '{topic}', self.on_scan, 10)
        self.create_timer(0.1, self.drive)

    def on_scan(self, msg):
{on_scan}

    def drive(self):
        command = {type}()
{drive}


def main():
    rclpy.init()
    rclpy.spin(Follower())


if __name__ == '__main__':
    main()
"""
STORE = "self.distance = min(msg.ranges)"
DRIVE = "if self.distance is None:\n    return\ncommand.linear.x = self.distance\nself.publisher.publish(command)"


def node(on_scan: str = STORE, drive: str = DRIVE, type: str = "Twist", topic: str = "scan") -> str:
    return NODE.format(type=type, topic=topic, on_scan=indent(on_scan, " " * 8), drive=indent(drive, " " * 8))


def test_a_command_from_the_last_message(judge: Judge):
    (finding,) = judge("TOP007", node(drive=f"{DRIVE}  # here"))
    assert finding.message == (
        "the timer callback, Follower.drive, publishes to 'out' what follows from self.distance, whose age nothing "
        "checks: if 'scan' stops, the last command goes on for ever"
    )


def test_a_command_is_told_once(judge: Judge):
    judge("TOP007", node(drive=f"{DRIVE}  # here\nself.publisher.publish(command)"))


@pytest.mark.parametrize(
    ("on_scan", "drive"),
    [
        (f"{STORE}\nself.last_time = time.monotonic()", DRIVE),
        (STORE, f"self.check_timeout()\n{DRIVE}"),
        (STORE, f"{DRIVE}\nself.distance = None"),  # the next time there is none
        ("pass", DRIVE),
        (STORE, "command.linear.x = 0.1\nself.publisher.publish(command)"),
    ],
)
def test_an_input_whose_age_counts(judge: Judge, on_scan: str, drive: str):
    judge("TOP007", node(on_scan, drive))


def test_what_commands_nothing_may_be_old(judge: Judge):
    judge("TOP007", node(drive="command.data = str(self.distance)\nself.publisher.publish(command)", type="String"))


@pytest.mark.parametrize("topic", ["goal", "planner/target_scan", "enabled"])
def test_what_counts_until_the_next_message(judge: Judge, topic: str):
    judge("TOP007", node(topic=topic))
