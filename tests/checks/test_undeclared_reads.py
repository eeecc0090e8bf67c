"""PRM003: names of parameters as ROS 1 writes them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


class Odometry(Node):
    def __init__(self):
        super().__init__('odometry')
        self.declare_parameter('scale', 1.0)
        self.declare_parameter('turn', 1.0)
        self.declare_parameter('~own', 1.0)
{lines}


def main():
    rclpy.init()
    rclpy.spin(Odometry())
"""


def _node(*lines: str) -> str:
    return NODE.format(lines="\n".join(f"        {line}" for line in lines))


def test_a_tilde_before_the_name_of_a_declared_parameter(judge: Judge):
    lines = ("print(self.get_parameter('~scale').value)  # here", "print(self.get_parameter('~turn').value)")
    (finding,) = judge("PRM003", _node(*lines))
    assert finding.message == (
        "parameter '~scale' is read, but Odometry never declares it; did you mean 'scale'?; another name has a ~, too"
    )
    assert finding.help == "take the ~ out: write 'scale'"
    assert [related.place.line for related in finding.related] == [12]


@pytest.mark.parametrize("name", ["~other", "~/other"])
def test_a_tilde_before_a_name_that_nothing_declares(judge: Judge, name: str):
    (finding,) = judge("PRM003", _node(f"print(self.get_parameter('{name}').value)  # here"))
    assert finding.help == f"declare it first: self.declare_parameter('{name}', …)"


def test_a_tilde_that_is_declared(judge: Judge):
    judge("PRM003", _node("print(self.get_parameter('~own').value)"))
