"""API001: what is logged that is no text, though no literal: times, messages, values of parameters."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('rate', 10)
        self.declare_parameter('names', ['a'])
        self.declare_parameter('frame', 'map')
        self.declare_parameter('open', None)
        self.rate = self.get_parameter('rate').value
        self.frame = self.get_parameter('frame').value
        self.open = self.get_parameter('open').value
        self.places = []
        self.started = self.get_clock().now()
        self.state = 'idle'
        self.timer = self.create_timer(1.0, self.tick)

    def name(self):
        return 'robot'

    def tick(self):
        now = self.get_clock().now()
        message = String(data='hello')
        limit = self.get_parameter('rate').get_parameter_value().integer_value
        {line}


def main():
    rclpy.init()
    rclpy.spin(Robot())


main()
"""


@pytest.mark.parametrize(
    ("logged", "what"),
    [
        ("now", "an rclpy Time"),
        ("self.started", "an rclpy Time"),
        ("now - self.started", "an rclpy Duration"),
        ("now.to_msg()", "a stamp message"),
        ("now.nanoseconds", "a number"),
        ("message", "a message"),
        ("String(data='x')", "a message"),
        ("self.get_parameter('frame')", "a Parameter"),
        ("self.get_parameter('rate').value", "a number"),
        ("self.get_parameter('names').value", "a list"),
        ("self.rate", "a number"),
        ("limit", "a number"),
        ("self.places", "a list"),
        ("len(self.places)", "a number"),
    ],
)
def test_what_is_logged_and_is_no_text(judge: Judge, logged: str, what: str) -> None:
    """Each of these raises a TypeError in rclpy of jazzy."""
    (finding,) = judge("API001", NODE.format(line=f"self.get_logger().info({logged})  # here"))
    assert finding.message == f"info() fails: 'message' takes a text, not {what}"
    assert finding.help.startswith("write info(str(")


@pytest.mark.parametrize(
    "line",
    [
        "self.get_logger().info(self.state)",
        "self.get_logger().info(self.frame)",
        "self.get_logger().info(self.open)",
        "self.get_logger().info(self.get_parameter('frame').value)",
        "self.get_logger().info(self.get_parameter('elsewhere').value)",
        "self.get_logger().info(message.data)",
        "self.get_logger().info(self.name())",
        "self.get_logger().debug(now)",
        "message = 'text'\n        self.get_logger().info(message)",
        "self.places = 'none'\n        self.get_logger().info(self.places)",
        "try:\n            self.get_logger().info(now)\n        except TypeError:\n            pass",
    ],
)
def test_what_is_logged_and_may_be_a_text(judge: Judge, line: str) -> None:
    judge("API001", NODE.format(line=line))


@pytest.mark.parametrize(
    "change",
    [
        ("('rate', 10)", "('rate', 10, ParameterDescriptor(dynamic_typing=True))"),
        ("'rate', 10)", "'rate', 10)\n        self.declare_parameter('rate', 'fast')"),
        ("('rate', 10)", "(some_name, 10)"),
        ("(Node)", "(SomeNode)"),
    ],
)
def test_a_parameter_whose_type_is_not_certain(judge: Judge, change: tuple[str, str]) -> None:
    judge("API001", NODE.format(line="self.get_logger().info(self.rate)").replace(*change))


@pytest.mark.parametrize("added", ["self.rate", "self.get_parameter('rate').value", "limit"])
def test_a_parameter_that_is_added_to_a_text(judge: Judge, added: str) -> None:
    (finding,) = judge("API001", NODE.format(line=f"print('rate: ' + {added})  # here"))
    assert "a number" in finding.message
    judge("API001", NODE.format(line="print('frame: ' + self.frame)"))
