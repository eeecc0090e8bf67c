"""TOP006: messages that are published before anybody can receive them."""

from __future__ import annotations

from textwrap import indent

import pytest

from checks.judging import Judge

SCRIPT = """
import time

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from somewhere import hand_over
from std_msgs.msg import Bool, String

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def main():
    rclpy.init()
    node = rclpy.create_node('script')
{lines}
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""
NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Bool, String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.publisher = self.create_publisher(String, 'state', 10)
{start}
        self.create_subscription(Bool, 'stop', self.on_stop, 10)

    def on_stop(self, message):
{lines}


def main():
    rclpy.init()
    rclpy.spin(Robot())


if __name__ == '__main__':
    main()
"""
CREATE = "publisher = node.create_publisher(String, 'state', 10)\n"


def script(lines: str) -> str:
    return SCRIPT.format(lines=indent(lines, "    "))


def node(start: str, lines: str = "pass") -> str:
    return NODE.format(start=indent(start, "        "), lines=indent(lines, "        "))


@pytest.mark.parametrize(
    "lines",
    [
        f"{CREATE}publisher.publish(String(data='up'))  # here",
        f"{CREATE}message = String()\nmessage.data = 'up'\nprint('now')\npublisher.publish(message)  # here",
        f"{CREATE}publisher.publish(String(data='up'))  # here\ntime.sleep(1.0)",
        f"{CREATE}publisher.publish(String(data='up'))  # here\nrclpy.spin_once(node)",
    ],
)
def test_the_only_message_of_a_program(judge: Judge, lines: str):
    [finding] = judge("TOP006", script(lines))
    assert "the only message on 'state'" in finding.message


def test_a_second_publisher_of_one_topic(judge: Judge):
    """The first one has long been there."""
    first = "first = node.create_publisher(String, 'state', 10)\nrclpy.spin_once(node)\nfirst.publish(String())\n"
    (told,) = judge("TOP006", script(f"{first}{CREATE}publisher.publish(String(data='up'))  # here"))
    assert told.message.startswith("this is the only message of this publisher of 'state'")
    assert told.help == "publish it with the publisher of that topic which the node has already"


def test_the_only_message_of_a_node(judge: Judge):
    [finding] = judge("TOP006", node("self.publisher.publish(String(data='up'))  # here"))
    assert finding.help == "publish it in a timer, once get_subscription_count() is above 0"


@pytest.mark.parametrize(
    "lines",
    [
        f"{CREATE}time.sleep(1.0)\npublisher.publish(String(data='up'))",
        f"{CREATE}while publisher.get_subscription_count() == 0:\n    pass\npublisher.publish(String(data='up'))",
        f"{CREATE}rclpy.spin_once(node)\npublisher.publish(String(data='up'))",
        f"{CREATE}hand_over(publisher)\npublisher.publish(String(data='up'))",
        f"{CREATE}publisher.publish(String(data='up'))\nhand_over(publisher)",
        f"{CREATE}other = hand_over()\npublisher.publish(String(data=other))",
        f"{CREATE}publisher.publish(String(data='up'))\ntime.sleep(1.0)\npublisher.publish(String(data='up'))",
        f"{CREATE}for _ in range(3):\n    publisher.publish(String(data='up'))\n    time.sleep(1.0)",
        "publisher = node.create_publisher(String, 'state', LATCHED)\npublisher.publish(String(data='up'))",
        "publisher = node.create_publisher(String, 'state', hand_over())\npublisher.publish(String(data='up'))",
        CREATE,
    ],
)
def test_a_message_that_may_be_received(judge: Judge, lines: str):
    assert not judge("TOP006", script(lines))


@pytest.mark.parametrize(
    ("start", "lines"),
    [
        ("self.publisher.publish(String(data='up'))", "self.publisher.publish(String(data='down'))"),
        ("self.publisher.publish(String(data='up'))", "publisher = self.publisher\npublisher.publish(String())"),
        ("self.create_timer(1.0, lambda: self.publisher.publish(String(data='up')))", "pass"),
        ("pass", "self.publisher.publish(String(data='down'))"),
        ("pass", "publisher = self.create_publisher(String, 'x', 10)\npublisher.publish(String())"),
    ],
)
def test_a_node_that_publishes_later(judge: Judge, start: str, lines: str):
    assert not judge("TOP006", node(start, lines))
