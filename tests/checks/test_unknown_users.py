"""What is used by an unknown node: no rule takes it for a node, and none says that what it has is missing."""

from __future__ import annotations

import pytest

TALKER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.out = self.create_publisher(String, "chatter", 10){mark}

if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(Talker())
"""
PLUGIN = """
from std_msgs.msg import String

class Plugin:
    def start(self, context):
        self.node = context.node
        self.node.{create}
"""
LISTENER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.create_subscription(String, "{name}", print, 10)

if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(Listener())
"""


def plugin(create: str) -> str:
    return PLUGIN.format(create=create)


CLOSED = "closed-world = true"


@pytest.mark.parametrize("code", ["TOP002", "GRF001"])
def test_a_helper_may_be_the_other_end(judge, code):
    judge(code, TALKER.format(mark=""), plugin("create_timer(1.0, self.tick)"), config=CLOSED)


def test_without_it_nobody_listens(judge):
    judge("TOP002", TALKER.format(mark="  # here"), config=CLOSED)


def test_a_helper_is_no_second_owner(judge):
    judge("OWN001", TALKER.format(mark=""), plugin('create_publisher(String, "chatter", 10)'), config=CLOSED)


def test_a_bad_name_is_told_all_the_same(judge):
    judge("NME002", plugin('create_publisher(String, "1st", 10)  # here'))


def test_a_bad_word_is_told_all_the_same(judge):
    judge("NME003", plugin('create_publisher(String, "CamelCase", 10)  # here'))


REQUIRED = """
[[contracts]]
name = "the listener gets the chatter"
kind = "require"
topic = "/chatter"
subscriber = "/listener"
"""


def test_a_helper_may_be_what_a_contract_asks_for(judge):
    sources = TALKER.format(mark=""), LISTENER.format(name="other")
    judge("ARC003", *sources, plugin('create_subscription(String, "chatter", print, 10)'), config=REQUIRED)


def test_a_helper_of_another_topic_is_not(judge):
    sources = TALKER.format(mark=""), LISTENER.format(name="other")
    with pytest.raises(AssertionError):  # the finding stands at the contract
        judge("ARC003", *sources, plugin('create_subscription(String, "rest", print, 10)'), config=REQUIRED)
