"""MSG001: messages without a header in a synchronizer that takes them by their time, and what is said besides."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from message_filters import ApproximateTimeSynchronizer, Subscriber, TimeSynchronizer
from nav_msgs.msg import Odometry
from rclpy.node import Node
from std_msgs.msg import Float64


class Fusion(Node):
    def __init__(self):
        super().__init__('fusion')
        self.publisher = self.create_publisher(Float64, 'speed', 10)
        odom = Subscriber(self, Odometry, 'odom')
        twist = Subscriber(self, {type}, 'twist')
        self.both = {made}
        {between}
        self.both.registerCallback(self.fuse){mark}
        {after}

    def fuse(self, odom, twist):
        speed = Float64()
        speed.data = 5{inside}
        self.publisher.publish(speed)


def main():
    rclpy.init()
    rclpy.spin(Fusion())


main()
"""
MADE = "ApproximateTimeSynchronizer([odom, twist], 10, 0.1{more})"


def node(
    *, made: str = MADE, more: str = "", type: str = "Twist", mark: str = "", after: str = "pass", inside: str = ""
) -> str:
    made = made.format(more=more)
    return NODE.format(type=type, made=made, between="pass", mark=mark, after=after, inside=inside)


@pytest.mark.parametrize("more", ["", ", allow_headerless=False"])
def test_a_message_without_a_header(judge: Judge, more: str) -> None:
    """The synchronizer logs a warning, and gives nothing to the callback."""
    [finding] = judge("MSG001", node(more=more, mark="  # here"))
    assert finding.message == (
        "geometry_msgs/msg/Twist has no field 'header': the synchronizer drops every such message, and never calls "
        "Fusion.fuse"
    )
    assert not judge("MSG003", node(more=more))


def test_a_callback_that_another_line_calls_as_well(judge: Judge) -> None:
    judge("MSG001", node(mark="  # here", after="self.create_timer(1.0, lambda: self.fuse(None, None))"))
    judge("MSG003", node(inside="  # here", after="self.create_timer(1.0, lambda: self.fuse(None, None))"))


@pytest.mark.parametrize(
    "rest",
    [
        {"more": ", allow_headerless=True"},
        {"more": ", True"},  # queue_offset from kilted on
        {"more": ", allow_headerless=self.declare_parameter('late', False).value"},
        {"type": "TwistStamped"},
        {"made": "TimeSynchronizer([odom, twist], 10)"},  # which reads a header that is not there
        {"after": "self.both.allow_headerless = True"},
    ],
)
def test_a_synchronizer_that_calls_its_callback(judge: Judge, rest: dict[str, str]) -> None:
    assert not judge("MSG001", node(**rest))
    judge("MSG003", node(**rest, inside="  # here"))
