"""EXE003: sleeps that are over before anything else of the node is due."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import time

import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Empty


class Gripper(Node):
    def __init__(self):
        super().__init__('gripper')
        self.publisher = self.create_publisher(Empty, 'closed', 10)
        self.create_subscription(Empty, 'close', self.close, 10)
        self.create_subscription(Empty, 'stop', self.stop, 10)
        {timer}

    def stop(self, message):
        self.publisher.publish(message)

    def tick(self):
        self.publisher.publish(Empty())

    def close(self, message):
        {lines}

    def grip(self):
        time.sleep(0.3){here}


rclpy.init()
rclpy.spin(Gripper())
"""
STOPPER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


class Stopper(Node):
    def __init__(self):
        super().__init__('stopper')
        self.publisher = self.create_publisher(Empty, 'stop', 10)
        self.create_timer({period}, self.tick)

    def tick(self):
        self.publisher.publish(Empty())


rclpy.init()
rclpy.spin(Stopper())
"""


def node(*lines: str, timer: str = "pass", here: str = "") -> str:
    return NODE.format(lines="\n        ".join(lines), timer=timer, here=here)


HALF = ("time.sleep(0.5)", "self.publisher.publish(message)")


@pytest.mark.parametrize(
    "lines",
    [
        HALF,
        ("time.sleep(0.2)", "time.sleep(0.3)", "self.publisher.publish(message)"),
        ("for _ in range(5):", "    time.sleep(0.1)", "    self.publisher.publish(message)"),
        ("if message:", "    time.sleep(0.4)", "else:", "    time.sleep(0.5)", "self.publisher.publish(message)"),
        ("self.grip()", "self.publisher.publish(message)"),
    ],
)
def test_half_a_second_in_all(judge: Judge, lines: tuple[str, ...]) -> None:
    """Whatever comes meanwhile waits in its queue."""
    assert not judge("EXE003", node(*lines))
    assert not judge("EXE003", node(*lines, timer="self.create_timer(0.5, self.tick)"))


@pytest.mark.parametrize(
    "lines",
    [
        ("time.sleep(0.6)  # here", "self.publisher.publish(message)"),
        ("time.sleep(0.4)  # here", "self.publisher.publish(message)", "time.sleep(0.4)"),
        ("for _ in range(6):", "    time.sleep(0.1)  # here", "    self.publisher.publish(message)"),
        ("while self.grips:", "    time.sleep(0.1)  # here", "    self.publisher.publish(message)"),
    ],
)
def test_more_than_half_a_second_in_all(judge: Judge, lines: tuple[str, ...]) -> None:
    assert judge("EXE003", node(*lines))


def test_a_helper_that_is_called_twice(judge: Judge) -> None:
    """Each call counts."""
    assert judge("EXE003", node("self.grip()", "self.publisher.publish(message)", "self.grip()", here="  # here"))


def test_a_timer_that_comes_more_often(judge: Judge) -> None:
    """It is late each time."""
    lines = ("time.sleep(0.5)  # here", *HALF[1:])
    assert judge("EXE003", node(*lines, timer="self.create_timer(0.1, self.tick)"))


def test_messages_that_come_more_often(judge: Judge) -> None:
    """Their publisher is in the workspace, and so is its timer."""
    assert not judge("EXE003", node(*HALF), STOPPER.format(period=1.0))
    lines = ("time.sleep(0.5)  # here", *HALF[1:])
    assert judge("EXE003", node(*lines), STOPPER.format(period=0.1))


def test_a_group_of_its_own_node(judge: Judge) -> None:
    """With several threads, the default group of another node does not wait, however long the callback sleeps."""
    apart = """
class Stop(Node):
    def __init__(self):
        super().__init__('stop')
        self.create_subscription(Empty, 'stop', self.stop, 10)

    def stop(self, message):
        self.get_logger().info(str(message))


rclpy.init()
executor = MultiThreadedExecutor()
executor.add_node(Gripper())
executor.add_node(Stop())
executor.spin()
"""
    text = node("for line in self.lines:", "    time.sleep(0.1)", "    self.publisher.publish(message)")
    text = text[: text.index("rclpy.init()")]
    stop = "        self.create_subscription(Empty, 'stop', self.stop, 10)\n"
    assert not judge("EXE003", text.replace(stop, "") + apart, *OTHERS)
    assert judge("EXE003", text.replace("sleep(0.1)", "sleep(0.1)  # here") + apart, *OTHERS)


OTHERS = [
    """
import rclpy
from rclpy.node import Node


class Other{0}(Node):
    def __init__(self):
        super().__init__('other{0}')


rclpy.init()
rclpy.spin(Other{0}())
""".replace("{0}", letter)
    for letter in "ABCDEF"
]
KEEPS = """
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        self.publisher = self.create_publisher(Empty, 'moved', 10)
        self.create_subscription(Empty, 'move', self.move, 10)
        self.create_subscription(Empty, 'state', self.keep, 10)

    def keep(self, message):
        self.state = message

    def move(self, message):
        {lines}


rclpy.init()
rclpy.spin(Arm())
"""


def test_a_sleep_that_nothing_follows(judge: Judge) -> None:
    """It keeps one motion apart from the next: a timer would have nothing to go on with."""
    publish, sleep = "self.publisher.publish(message)", "time.sleep(5.0)"
    assert not judge("EXE003", KEEPS.format(lines=f"{publish}\n        {sleep}"), *OTHERS)
    assert judge("EXE003", KEEPS.format(lines=f"{sleep}  # here\n        {publish}"), *OTHERS)
    looped = f"for step in self.steps:\n            {publish}\n            {sleep}  # here"
    assert judge("EXE003", KEEPS.format(lines=looped), *OTHERS)


GOAL = """
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.node import Node
from std_msgs.msg import Empty


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.server = ActionServer(self, Fibonacci, 'count', self.count)
        self.publisher = self.create_publisher(Empty, 'stopped', 10)
        self.create_subscription(Empty, 'stop', self.stop, 10)

    def stop(self, message):
        self.publisher.publish(message)

    def count(self, goal_handle):
        time.sleep({line}
        goal_handle.succeed()
        return Fibonacci.Result()


rclpy.init()
rclpy.spin(Counter())
"""


def test_a_goal_of_less_than_a_second(judge: Judge) -> None:
    """More threads are not worth it: with them, a stop would come in the midst of the goal."""
    assert not judge("EXE003", GOAL.format(line="0.9)"))
    assert judge("EXE003", GOAL.format(line="1.0)  # here"))
