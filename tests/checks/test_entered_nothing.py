"""API001: a ``with`` whose variable is None, since ``__enter__()`` returns nothing."""

from __future__ import annotations

import pytest

from checks.judging import Judge

GNSS = """
import rclpy
from rclpy.node import Node


class Gnss(Node):
    def __init__(self):
        super().__init__('gnss')
        self.port = None

    def __enter__(self):
        self.port = open('/dev/ttyUSB2')
        {end}

    def __exit__(self, *error):
        self.port.close()


def main():
    rclpy.init()
    {head}
        {use}
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""
WITH = "with Gnss() as node:"
NOTHING = "self.get_logger().info('open')"


@pytest.mark.parametrize("use", ["rclpy.spin(node)", "node.get_logger().info('up')", "rclpy.spin_once(node)"])
@pytest.mark.parametrize("end", [NOTHING, "return", "return None"])
def test_a_node_that_is_none(judge: Judge, use: str, end: str):
    code = GNSS.format(end=end, head=f"{WITH}  # here", use=use)
    [found] = judge("API001", code)
    assert found.message == (
        "__enter__() of Gnss returns None: node is None here, and using it fails with an AttributeError"
    )
    assert found.help == "let __enter__() end with `return self`"
    assert [code.splitlines()[each.place.line].strip() for each in found.related] == [use, "def __enter__(self):"]


@pytest.mark.parametrize(
    ("end", "head", "use"),
    [
        pytest.param("return self", WITH, "rclpy.spin(node)", id="it returns itself"),
        pytest.param("return self.port", WITH, "print(node.name)", id="it returns something else"),
        pytest.param(NOTHING, "with Gnss():", "pass", id="no variable"),
        pytest.param(NOTHING, WITH, "print(node)", id="a use that does not fail"),
        pytest.param(NOTHING, WITH, "node = Gnss(); rclpy.spin(node)", id="another value"),
        pytest.param(NOTHING, WITH, "if node is not None: rclpy.spin(node)", id="it asks for it"),
        pytest.param(NOTHING, "with open('log') as node:", "print(node.name)", id="no object of the workspace"),
        pytest.param("raise NotImplementedError", WITH, "rclpy.spin(node)", id="it never returns"),
    ],
)
def test_a_variable_that_is_something_or_may_be_none(judge: Judge, end: str, head: str, use: str):
    judge("API001", GNSS.format(end=end, head=head, use=use))
