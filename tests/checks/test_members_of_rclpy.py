"""What rclpy's and tf2's own objects do not have, and what of them is no method."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.action import ActionClient
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import HistoryPolicy, QoSReliabilityPolicy, ReliabilityPolicy
from example_interfaces.action import Fibonacci
from geometry_msgs.msg import TransformStamped
from std_msgs.msg import String
from tf2_ros import Buffer, TransformBroadcaster, TransformListener


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.log = self.get_logger()
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.broadcaster = TransformBroadcaster(self)
        self.fibonacci = ActionClient(self, Fibonacci, 'fibonacci')
        self.create_timer(1.0, self.tick)

    def tick(self):
        {line}

    def heard(self, message):
        pass

    def accepted(self, future):
        handle = future.result()
        {of_handle}


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


def node(line: str, of_handle: str = "pass") -> str:
    return NODE.replace("{line}", line).replace("{of_handle}", of_handle)


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        ("self.get_logger().warm('low')", "a logger has no 'warm'", "write warning"),
        ("self.log.Info('low')", "a logger has no 'Info'", "write info"),
        ("self.get_logger().critical('low')", "a logger has no 'critical'", "write fatal"),
        (
            "self.get_logger().warn_throttle(5.0, 'low')",
            "a logger has no 'warn_throttle'",
            "write warning(…, throttle_duration_sec=…)",
        ),
        ("self.log.info_once('low')", "a logger has no 'info_once'", "write info(…, once=True)"),
        (
            "print(QoSReliabilityPolicy.KEEP_LAST)",
            "ReliabilityPolicy has no 'KEEP_LAST'",
            "write HistoryPolicy.KEEP_LAST",
        ),
        ("print(ReliabilityPolicy.BESTEFFORT)", "ReliabilityPolicy has no 'BESTEFFORT'", "write BEST_EFFORT"),
        ("print(rclpy.qos.HistoryPolicy.KEEPLAST)", "HistoryPolicy has no 'KEEPLAST'", "write KEEP_LAST"),
        ("print(Parameter.Type.FLOAT)", "Parameter.Type has no 'FLOAT'", "write DOUBLE"),
        (
            "self.subscriptions(String, 'chatter', self.heard, 10)",
            "'subscriptions' of a Node is a value, no method",
            "write create_subscription(…), or subscriptions without parentheses",
        ),
        (
            "print(self.buffer.lookupTransform('map', 'base', 0))",
            "Buffer has no lookupTransform()",
            "use lookup_transform()",
        ),
    ],
)
def test_what_is_not_there(judge: Judge, line: str, message: str, help: str):
    [finding] = judge("API002", node(f"{line}  # here"))
    assert finding.message.startswith(message)
    assert finding.help == help


@pytest.mark.parametrize(
    "line",
    [
        "self.get_logger().warning('low')",
        "self.log.get_child('arm').info('low')",
        "print(self.log.name)",
        "print(QoSReliabilityPolicy.BEST_EFFORT.name, HistoryPolicy.KEEP_LAST.value)",
        "print(ReliabilityPolicy.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)",  # of Foxy
        "print(Parameter.Type.DOUBLE, Parameter.Type.from_parameter_value(1.0))",
        "print(list(self.subscriptions))",
        "print(self.buffer.all_frames_as_yaml())",
        "self.buffer.clear()",
        "print(); import clearml; clearml.Task.init().get_logger().report_text('low')",
        "handler = self.get_logger().warm if hasattr(self.log, 'warm') else print",
    ],
)
def test_what_is_there(judge: Judge, line: str):
    assert not judge("API002", node(line))


def test_a_goal_handle_whose_value_is_called(judge: Judge):
    send = "self.fibonacci.send_goal_async(Fibonacci.Goal()).add_done_callback(self.accepted)"
    [finding] = judge("API002", node(send, "print(handle.accepted())  # here"))
    assert finding.message.startswith("'accepted' of a ClientGoalHandle is a value, no method")
    assert not judge("API002", node(send, "print(handle.accepted)"))


@pytest.mark.parametrize("given", ["ReentrantCallbackGroup", "10", "self.heard"])
def test_what_is_no_callback_group(judge: Judge, given: str):
    [finding] = judge("API001", node(f"self.create_timer(1.0, self.tick, callback_group={given})  # here"))
    assert "'callback_group' takes a callback group, not" in finding.message


@pytest.mark.parametrize("given", ["ReentrantCallbackGroup()", "MutuallyExclusiveCallbackGroup()", "None"])
def test_a_callback_group(judge: Judge, given: str):
    assert not judge("API001", node(f"self.create_timer(1.0, self.tick, callback_group={given})"))


@pytest.mark.parametrize(
    ("call", "fits"),
    [
        ("self.broadcaster.sendTransform((0, 0, 0), (0, 0, 0, 1), self.get_clock().now(), 'base', 'map')", False),
        ("self.broadcaster.sendTransform(TransformStamped())", True),
        ("self.buffer.lookup_transform('map', 'base')", False),
        ("self.buffer.lookup_transform('map', 'base', rclpy.time.Time())", True),
    ],
)
def test_what_tf2_is_called_with(judge: Judge, call: str, fits: bool):
    findings = judge("API001", node(call if fits else f"{call}  # here"))
    assert [finding.code for finding in findings] == ["API001"] * (not fits)


SPUN = """
import rclpy
from rclpy.node import Node


class Base(Node):
    def __init__(self):
        super().__init__('robot')


class Robot({base}):
    def __init__(self):
        {constructor}


def main():
    rclpy.init()
    rclpy.spin(Robot()){here}
"""


@pytest.mark.parametrize("base", ["Node", "Base"])
def test_a_node_that_is_spun_and_never_initialised(judge: Judge, base: str):
    source = SPUN.format(base=base, constructor="self.count = 0", here="  # here")
    [finding] = judge("API003", source)
    assert finding.message == "spin() fails: Robot has not called super().__init__() yet"


@pytest.mark.parametrize("constructor", ["super().__init__()", "Base.__init__(self)", "super(Robot, self).__init__()"])
def test_a_node_that_is_initialised(judge: Judge, constructor: str):
    assert not judge("API003", SPUN.format(base="Base", constructor=constructor, here=""))


@pytest.mark.parametrize(
    ("made", "told"),
    [("robot = Robot()", True), ("robot = None; robot = Robot()", True), ("robot = find_robot()", False)],
)
def test_a_file_that_also_asks_an_object_of_its_class_for_the_logger(judge: Judge, made: str, told: bool):
    """What is no node may have other loggers, and then all of the file may be about those."""
    line = "self.get_logger().warn_once('low')" + ("  # here" if told else "")
    source = node(line).replace("rclpy.spin(Robot())", f"{made}; robot.get_logger().info('up'); rclpy.spin(robot)")
    judge("API002", source)
