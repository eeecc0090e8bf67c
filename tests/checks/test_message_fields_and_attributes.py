"""API002: what code gives to messages is given to no object of the workspace's classes."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_srvs.srv import SetBool


class Motor:
    def __init__(self):
        self.limit = 1.0

    def torque(self, current):
        return self.effort * current{here}


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.motor = Motor()
        self.create_timer(1.0, self.tick)

    def tick(self):
        {line}
        print(self.motor.torque(1.0))


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    "line",
    [
        "joints = JointState(); joints.effort = [1.0]",
        "request = SetBool.Request(); request.effort = True",
        "joints = JointState(); joints.header.effort = 1",
    ],
)
def test_fields_of_messages_are_no_attributes_of_objects(judge: Judge, line: str):
    [finding] = judge("API002", NODE.replace("{line}", line).replace("{here}", "  # here"))
    assert finding.message.startswith("nothing assigns 'effort' of class Motor")


@pytest.mark.parametrize(
    "line",
    [
        "motor = self.motor; motor.effort = 1.0",
        "joints = JointState(); joints = self.motor; joints.effort = 1.0",  # something else, too
        "for motor in [self.motor]:\n            motor.effort = 1.0",
        "self.motor.effort = 1.0",
    ],
)
def test_what_may_be_the_object(judge: Judge, line: str):
    assert not judge("API002", NODE.replace("{line}", line).replace("{here}", ""))
