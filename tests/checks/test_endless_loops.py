"""EXE009: loops of callbacks that wait for what they keep from happening."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import time

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.data = None
        self.create_subscription(String, 'data', self.on_data, 10{group})
        self.create_timer(1.0, self.tick)

    def on_data(self, message):
        self.data = message

    def tick(self):
        {body}

    def helper(self):
        {helper}


def main():
    rclpy.init()
    {spin}


if __name__ == '__main__':
    main()
"""
ONE_THREAD = "rclpy.spin(Robot())"
THREADS = "executor = MultiThreadedExecutor()\n    executor.add_node(Robot())\n    executor.spin()"


def robot(*lines: str, helper: str = "pass", spin: str = ONE_THREAD, group: str = "") -> str:
    return NODE.format(body="\n        ".join(lines), helper=helper, spin=spin, group=group)


@pytest.mark.parametrize(
    "source",
    [
        robot("while self.data is None:  # here", "    time.sleep(0.1)"),
        robot("while not self.data:  # here", "    pass"),
        robot("while rclpy.ok() and self.data is None:  # here", "    self.get_logger().info('waiting')"),
        robot("while self.data is None:  # here", "    time.sleep(0.1)", spin=THREADS),
    ],
    ids=["sleeps", "busy", "while ROS runs", "several threads, one group"],
)
def test_a_loop_that_keeps_out_what_would_end_it(judge: Judge, source: str):
    [finding] = judge("EXE009", source)
    assert "only Robot.on_data changes self.data, and it cannot run meanwhile" in finding.message


@pytest.mark.parametrize(
    "source",
    [
        robot("while self.data is None:", "    rclpy.spin_once(self)"),
        robot("while self.data is None:", "    self.helper()", helper="self.data = 1"),
        robot("while self.data is None:", "    time.sleep(0.1)", helper="self.data = 1"),
        robot("while self.data is None:", "    if time.time() > 5:", "        break"),
        robot("tries = 0", "while self.data is None and tries < 9:", "    tries += 1"),
        robot("while self.data is None:", "    self.data = String()"),
        robot("while rclpy.ok():", "    time.sleep(0.1)"),
        robot(
            "while self.data is None:",
            "    time.sleep(0.1)",
            spin=THREADS,
            group=", callback_group=ReentrantCallbackGroup()",
        ),
        robot("if self.data is None:", "    return"),
    ],
    ids=[
        "it spins",
        "it calls what changes it",
        "a method that nobody is seen to call changes it",
        "it breaks off",
        "it counts",
        "it changes it",
        "it waits for nothing",
        "another group",
        "no loop",
    ],
)
def test_a_loop_that_may_end(judge: Judge, source: str):
    judge("EXE009", source)


def test_only_the_stronger_is_said_of_a_line(judge: Judge):
    judge("EXE003", robot("while self.data is None:", "    time.sleep(0.1)"))
