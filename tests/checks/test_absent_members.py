"""API002: what objects of the workspace's own classes, and services and actions, do not have."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.action import CancelResponse
from rclpy.node import Node
from std_srvs.srv import Trigger


class Wheel:
    radius = 0.1

    def turn(self, speed):
        print(speed)


class Single:
    def __new__(cls):
        return print


class Motor(Node):
    def __init__(self):
        super().__init__('motor')
        self.wheel = Wheel()
        self.single = Single()
        self.either = Wheel()
        self.either = None
        self.timer = self.create_timer(1.0, self.drive)

    def drive(self):
        front = Wheel()
        {line}


def main():
    rclpy.init()
    rclpy.spin(Motor())


main()
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "self.wheel.trun(1.0)",
            "class Wheel has no 'trun': this line fails with an AttributeError; did you mean 'turn'?",
            "write turn",
        ),
        (
            "front.brake()",
            "class Wheel has no 'brake': this line fails with an AttributeError",
            "define brake() in class Wheel, or call what it has: turn()",
        ),
        (
            "Trigger.request()",
            "std_srvs/srv/Trigger has no 'request': this line fails with an AttributeError; did you mean 'Request'?",
            "write Request",
        ),
        (
            "print(Trigger.response.success)",
            "std_srvs/srv/Trigger has no 'response': this line fails with an AttributeError",
            "write the variable that holds the message: Trigger is its class",
        ),
        (
            "response = Trigger.Response(); print(Trigger.response.success)",
            "std_srvs/srv/Trigger has no 'response': this line fails with an AttributeError",
            "write response: Trigger is the class, and response what is sent",
        ),
        (
            "self.timer.destroy_timer()",
            "Timer has no destroy_timer()",
            "it is a method of the node: write self.destroy_timer(…)",
        ),
        (
            "front = Motor(); front.brake()",
            "Node has no brake()",
            "define brake() in the class of the node, or remove the call",
        ),
    ],
)
def test_what_is_not_there(judge: Judge, line: str, message: str, help: str) -> None:
    (finding,) = judge("API002", NODE.format(line=f"{line}  # here"))
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "line",
    [
        "self.wheel.turn(self.wheel.radius)",
        "self.single.anything()",
        "self.either.brake()",
        "print(CancelResponse.ACCEPT, Trigger.Request(), Trigger.Response)",
        "try:\n            front.brake()\n        except AttributeError:\n            pass",
        "setattr(front, 'brake', print); front.brake()",
    ],
)
def test_what_is_there_or_may_be(judge: Judge, line: str) -> None:
    judge("API002", NODE.format(line=line))


def test_what_the_class_itself_lacks_and_others_ask_its_objects_for(judge: Judge) -> None:
    lacks = NODE.replace("        print(speed)\n", "        self.lubricate()  # here\n").format(
        line="self.wheel.lubricate()"
    )
    [finding] = judge("API002", lacks)
    assert finding.message == "nothing assigns 'lubricate' of class Wheel: this line fails with an AttributeError"
    assert [related.place.line for related in finding.related] == [30]


def test_an_object_is_asked_for_something_else_than_what_the_class_lacks(judge: Judge) -> None:
    lacks = NODE.replace("        print(speed)\n", "        self.lubricate()  # here\n").format(
        line="self.wheel.clean()  # here"
    )
    first, second = judge("API002", lacks)
    assert first.related == second.related == ()
