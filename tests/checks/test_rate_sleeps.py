"""EXE009: rates that sleep on the thread that would have to spin their node.

Tried with rclpy of jazzy: each of these loops stops, the ones below go on.
"""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
import threading
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.pub = self.create_publisher(String, 'out', 10)
        {more}
        self.rate = self.create_rate(10)

    def run(self):
        while {test}:
            self.pub.publish(String())
            {spin}
            self.rate.sleep(){here}


def main():
    rclpy.init()
    robot = Robot()
    {first}
    robot.run()
    {last}


main()
"""
LISTENS = "self.create_subscription(String, 'in', print, 10)"


def program(
    spin: str = "pass",
    more: str = "pass",
    first: str = "pass",
    last: str = "pass",
    here: str = "",
    test: str = "rclpy.ok()",
) -> str:
    return PROGRAM.format(spin=spin, more=more, first=first, last=last, here=here, test=test)


@pytest.mark.parametrize("last", ["pass", "rclpy.spin(robot)"])
def test_a_node_that_nobody_spins_meanwhile(judge: Judge, last: str):
    (finding,) = judge("EXE009", program(last=last, here="  # here"))
    assert finding.message == (
        "Rate.sleep() blocks for ever: nothing spins the node while this thread sleeps, so its timer never wakes it"
    )


@pytest.mark.parametrize(
    ("spin", "more"),
    [
        ("rclpy.spin_once(self)", LISTENS),
        ("rclpy.spin_once(self, timeout_sec=0.05)", LISTENS),
        ("rclpy.spin_once(self, timeout_sec=0)", "pass"),
        ("rclpy.spin_once(self, timeout_sec=0.05)", "pass"),
    ],
)
def test_a_spin_that_may_miss_the_timer(judge: Judge, spin: str, more: str):
    (finding,) = judge("EXE009", program(spin, more, here="  # here"))
    assert finding.message.startswith("Rate.sleep() soon blocks for ever: the timer that wakes it runs in spin_once()")
    assert [row.message for row in finding.related] == ["the node is spun here, in the same thread"]


@pytest.mark.parametrize(
    ("spin", "first"),
    [
        ("rclpy.spin_once(self)", "pass"),  # comes back when the timer is due, as nothing else is
        ("rclpy.spin_once(self, timeout_sec=1.0)", "pass"),
        ("pass", "threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()"),
        ("pass", "threading.Thread(target=somewhere.run, args=(robot,)).start()"),
    ],
)
def test_a_rate_that_is_woken_or_may_be(judge: Judge, spin: str, first: str):
    judge("EXE009", program(spin, first=first))


@pytest.mark.parametrize(
    ("test", "entered"),
    [
        ("rclpy.ok() and self.pub", True),
        ("not self.pub or not rclpy.ok()", True),
        ("not rclpy.ok()", False),
        ("not self.context.ok() and self.pub", False),
        ("False", False),
    ],
)
def test_a_loop_that_is_not_entered_while_ros_is_up(judge: Judge, test: str, entered: bool):
    judge("EXE009", program(test=test, here="  # here" if entered else ""))


def test_a_node_that_hangs_there_is_not_told_twice(judge: Judge):
    judge("EXE008", program(more=LISTENS))


LISTENER = "TransformListener(self.buffer, self, spin_thread={thread})"


@pytest.mark.parametrize(("thread", "here"), [("True", ""), ("self.threaded", ""), ("False", "  # here")])
@pytest.mark.parametrize("last", ["pass", "rclpy.spin(robot)"])
def test_a_listener_that_spins_the_node_in_its_thread(judge: Judge, thread: str, here: str, last: str):
    source = program(more=LISTENER.format(thread=thread), here=here, last=last)
    judge("EXE009", "from tf2_ros import TransformListener\n" + source)


def test_a_listener_of_a_helper_that_spins_the_node(judge: Judge):
    helper = """
from tf2_ros import Buffer, TransformListener


class Frames:
    def __init__(self, node):
        self.listener = TransformListener(Buffer(), node, spin_thread=True)
"""
    judge("EXE009", helper + program(more="self.frames = Frames(self)"))
    judge("EXE008", helper + program(more="self.frames = Frames(self)" + "; " + LISTENS))


def test_of_two_sleeps_the_first_never_ends(judge: Judge):
    judge("EXE009", program(here="  # here\n            self.rate.sleep()"))
    judge("EXE009", program(spin="if self.count:\n                self.rate.sleep()  # here", here="  # here"))


KEYS = """
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Keys(Node):
    def __init__(self):
        super().__init__('keys')
        self.fast = False
        self.create_subscription(String, 'ack', self.on_text, 10)

    def on_text(self, message):
        self.get_logger().info(message.data)

    def run(self):
        while rclpy.ok():
            if self.fast:
                {first}
            elif sys.stdin.read(1) == 'f':
                {then}


def main():
    rclpy.init()
    node = Keys(){here}
    node.run()


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("first", "then", "here"),
    [
        ("rclpy.spin_once(self)", "self.fast = True", ""),
        ("pass", "self.fast = True", "  # here"),
        ("rclpy.spin_once(self)", "pass", "  # here"),
    ],
)
def test_a_spin_that_a_later_round_comes_to(judge: Judge, first: str, then: str, here: str):
    judge("EXE008", KEYS.format(first=first, then=then, here=here))
