"""SRV007: handlers that end with a loop which goes round for certain."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool

NAMES = ['left', 'right']


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        self.sides = {sides}
        self.create_service(SetBool, 'raise', self.handle)
        {change}

    def handle(self, request, response):{mark}
        {body}


def main():
    rclpy.init()
    rclpy.spin(Arm())


main()
"""
ROUND = "for side in {over}:\n            response.message = side\n            return response"


def node(body: str, *, sides: str = "['left', 'right']", change: str = "pass", mark: str = "") -> str:
    return NODE.format(body=body, sides=sides, change=change, mark=mark)


@pytest.mark.parametrize(
    "over", ["self.sides", "NAMES", "('left', 'right')", "sorted(self.sides)", "range(2)", "{'left': 1}.keys()"]
)
def test_a_loop_over_what_is_never_empty(judge: Judge, over: str) -> None:
    assert not judge("SRV007", node(ROUND.format(over=over)))


@pytest.mark.parametrize("over", ["range(0)", "range(request.count)", "[]", "[*self.sides]", "self.others"])
def test_a_loop_over_what_may_be_empty(judge: Judge, over: str) -> None:
    # The finding stands where the handler is defined.
    judge("SRV007", node(ROUND.format(over=over), mark="  # here"))


@pytest.mark.parametrize(
    ("sides", "change"),
    [
        ("[]", "pass"),
        ("['left']", "self.sides = []"),
        ("['left']", "self.sides.clear()"),
        ("['left']", "del self.sides[0]"),
        ("['left']", "self.sides[:] = NAMES"),
        ("['left']", "self.sides = self.load()"),
    ],
)
def test_a_list_that_code_may_empty(judge: Judge, sides: str, change: str) -> None:
    judge("SRV007", node(ROUND.format(over="self.sides"), sides=sides, change=change, mark="  # here"))


def test_a_round_that_may_not_return(judge: Judge) -> None:
    body = "for side in self.sides:\n            if request.data:\n                return response"
    judge("SRV007", node(body, mark="  # here"))
    body = "for side in self.sides:\n            if side:\n                continue\n            return response"
    judge("SRV007", node(body, mark="  # here"))


def test_an_elif_that_asks_the_opposite(judge: Judge) -> None:
    """It holds wherever the ``if`` does not, however many variables the handler asks for besides."""
    others = "".join(f"if self.{name}:\n            self.{name} = False\n        " for name in "abcdefg")
    others += "".join(f"if self.{name}:\n            self.{name} = True\n        " for name in "abcdefg")
    body = "if request.data:\n            return response\n        elif {}:\n            return response"
    assert not judge("SRV007", node(others + body.format("not request.data")))
    judge("SRV007", node(others + body.format("not request.other"), mark="  # here"))
