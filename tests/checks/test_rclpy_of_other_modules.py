"""EXE008: rclpy by the name that another module has for it, as it imports it."""

from __future__ import annotations

import pytest

from checks.judging import Judge

LAMP = """
{line}
from rclpy.node import Node
from std_msgs.msg import Bool


class Lamp(Node):
    def __init__(self):
        super().__init__('lamp')
        self.create_subscription(Bool, 'dark', print, 10)


if __name__ == '__main__':
    rclpy.init()
    lamp = Lamp(){mark}
    {last}
    rclpy.shutdown()
"""
SPIN = "rclpy.spin(lamp)"


@pytest.mark.parametrize(
    ("line", "last", "mark"),
    [
        ("import rclpy", SPIN, ""),
        ("from rclpy.logging import rclpy", SPIN, ""),  # which has 'import rclpy.impl'
        ("from cameras.drivers import rclpy", SPIN, ""),
        ("import rclpy.logging", "rclpy.logging.rclpy.spin(lamp)", ""),
        ("from rclpy.logging import rclpy", "print(lamp)", "  # here"),
        ("from cameras.drivers import rclpy", "print(lamp)", "  # here"),
    ],
)
def test_a_node_is_spun_by_rclpy_of_another_module(judge: Judge, line: str, last: str, mark: str):
    judge("EXE008", LAMP.format(line=line, last=last, mark=mark))
