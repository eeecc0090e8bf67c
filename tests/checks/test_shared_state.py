"""EXE013: attributes that callbacks on several threads change without a lock."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

NODE = """
import threading

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.count = 0
        self.last = None
        self.seen = []
        self.lock = threading.Lock()
        left, right = {groups}
        self.create_subscription(String, 'left', self.on_left, 10, callback_group=left)
        self.create_subscription(String, 'right', self.on_right, 10, callback_group=right)

    def on_left(self, msg):
{left}

    def on_right(self, msg):
{right}

    def add(self):
{add}


def main():
    rclpy.init()
    executor = {executor}
    executor.add_node(Counter())
    executor.spin()


if __name__ == '__main__':
    main()
"""
TWO = "MutuallyExclusiveCallbackGroup(), MutuallyExclusiveCallbackGroup()"


def node(left: str, right: str, groups: str = TWO, executor: str = "MultiThreadedExecutor()", add: str = "pass") -> str:
    bodies = {"left": left, "right": right, "add": add}
    return NODE.format(
        groups=groups, executor=executor, **{name: indent(body, " " * 8) for name, body in bodies.items()}
    )


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("self.count += 1  # here", "self.count = 0"),
        ("self.count = self.count + 1  # here", "self.count += 1"),
        ("if msg.data:\n    self.count += 1  # here", "self.count -= 1"),
        ("with self.lock:\n    self.last = msg\nself.count += 1  # here", "self.count = 0"),
    ],
)
def test_two_groups_change_one_attribute(judge: Judge, left: str, right: str):
    judge("EXE013", node(left, right))


def test_both_ends_are_named(judge: Judge):
    (finding,) = judge("EXE013", node("self.count += 1  # here", "self.count = 0"))
    assert finding.message == (
        "the callback of a subscription, Counter.on_left, reads self.count and changes it, and Counter.on_right may "
        "change it in between on another thread: one of the two changes is lost"
    )
    assert [row.message for row in finding.related] == [
        "Counter.on_left is a callback",
        "Counter.on_right changes it here",
    ]


def test_a_method_that_a_callback_calls_is_part_of_it(judge: Judge):
    judge("EXE013", node("self.add()", "self.count = 0", add="self.count += 1  # here"))


def test_a_reentrant_group_lets_a_callback_run_beside_itself(judge: Judge):
    judge("EXE013", node("self.count += 1  # here", "pass", groups="[ReentrantCallbackGroup()] * 2"))


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("self.last = msg", "self.last = None"),  # one step each
        ("self.seen.append(msg)", "self.seen.append(msg)"),
        ("with self.lock:\n    self.count += 1", "with self.lock:\n    self.count = 0"),
        ("self.count += 1", "self.get_logger().info(str(self.count))"),  # one writes, one reads
        ("self.count += 1", "pass"),
    ],
)
def test_changes_that_lose_nothing(judge: Judge, left: str, right: str):
    judge("EXE013", node(left, right))


def test_one_group_or_one_thread_keeps_the_changes_apart(judge: Judge):
    changes = ("self.count += 1", "self.count = 0")
    judge("EXE013", node(*changes, groups="[MutuallyExclusiveCallbackGroup()] * 2"))
    judge("EXE013", node(*changes, executor="SingleThreadedExecutor()"))
    judge("EXE013", node(*changes, groups="None, None"))
