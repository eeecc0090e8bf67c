"""SRV003: a handler that spins again and again until a response is there, each time for a moment."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class Gate(Node):
    def __init__(self):
        super().__init__('gate')
        self.client = self.create_client(Trigger, 'open')
        self.create_service(Trigger, 'let_in', self.let_in)

    def let_in(self, request, response):
        future = self.client.call_async(Trigger.Request())
        while not future.done():  # here
            rclpy.spin_once({arguments})
        return response


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Gate())
    executor.spin()


main()
"""


@pytest.mark.parametrize(
    ("arguments", "outcome"),
    [
        ("self, timeout_sec=0.1", "this never ends"),
        ("self", "this deadlocks"),
        ("self, timeout_sec=None", "this deadlocks"),
    ],
)
def test_spins_with_a_timeout_go_round_for_ever(judge: Judge, arguments: str, outcome: str) -> None:
    """The response is not taken as long as the handler holds its group, but nothing stands still."""
    [finding] = judge("SRV003", NODE.format(arguments=arguments))
    assert finding.message.endswith(outcome)
