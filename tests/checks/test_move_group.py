"""TMO001: waits for MoveIt's move_group, which has just answered under another of its names."""

from __future__ import annotations

import pytest

from checks.judging import Judge

ARM = """
import rclpy
from moveit_msgs.action import MoveGroup
from moveit_msgs.srv import GetStateValidity
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Empty


class Guard:
    def __init__(self, node):
        self.node = node
        self.client = node.create_client(GetStateValidity, '{service}')

    def check(self):
        if not self.client.wait_for_service(timeout_sec=0.5):
            return False, 'no move_group'
        return True, ''


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        self.guard = Guard(self)
        self.action = ActionClient(self, MoveGroup, '{action}')
        self.create_subscription(Empty, 'go', self.go, 10)

    def go(self, message):
        {lines}
        self.action.wait_for_server(){here}
        self.action.send_goal_async(MoveGroup.Goal())


rclpy.init()
rclpy.spin(Arm())
"""
CHECKED = ("ok, reason = self.guard.check()", "if not ok:", "    return")


def arm(*lines: str, here: bool, service: str = "/check_state_validity", action: str = "move_action") -> str:
    text = "\n        ".join(lines)
    return ARM.format(lines=text, here="  # here" if here else "", service=service, action=action)


@pytest.mark.parametrize(
    "lines",
    [
        CHECKED,
        ("if not self.guard.check()[0]:", "    return"),
        ("if not self.guard.client.wait_for_service(timeout_sec=1.0):", "    return"),
    ],
)
def test_a_service_of_the_same_node_was_there(judge: Judge, lines: tuple[str, ...]) -> None:
    """One node serves both: where it has answered, its action is there, too."""
    assert not judge("TMO001", arm(*lines, here=False))


def test_in_one_namespace(judge: Judge) -> None:
    names = {"service": "/left/check_state_validity", "action": "/left/move_action"}
    assert not judge("TMO001", arm(*CHECKED, here=False, **names))
    assert judge("TMO001", arm(*CHECKED, here=True, **{**names, "action": "/right/move_action"}))


@pytest.mark.parametrize("names", [{"service": "check_arm"}, {"action": "grip"}])
def test_another_node(judge: Judge, names: dict[str, str]) -> None:
    """Nothing says that one node has both names."""
    assert judge("TMO001", arm(*CHECKED, here=True, **names))


@pytest.mark.parametrize(
    "lines",
    [
        ("self.guard.check()",),
        ("ok, reason = self.guard.check()", "if ok:", "    return"),
        ("if self.guard.client.wait_for_service(timeout_sec=1.0):", "    return"),
        ("ok, reason = self.guard.check()", "if not ok:", "    print(reason)"),
    ],
)
def test_where_it_was_not_there(judge: Judge, lines: tuple[str, ...]) -> None:
    """The code comes to the wait all the same, or only then."""
    assert judge("TMO001", arm(*lines, here=True))
