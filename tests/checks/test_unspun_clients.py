"""EXE008: nodes that only send requests, and take the responses in done callbacks."""

from __future__ import annotations

import pytest

from checks.judging import Judge

TILL = """
import threading

import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class Kitchen(Node):
    def __init__(self):
        super().__init__('kitchen')
        self.client = self.create_client(Trigger, 'cook')

    def order(self):
        self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

    def on_answer(self, future):
        self.get_logger().info(future.result().message)


class Till(Node):
    def __init__(self):
        super().__init__('till')
        self.client = self.create_client(Trigger, 'pay')

    def order(self):
        future = self.client.call_async(Trigger.Request())
        {taken}

    def on_answer(self, future):
        self.get_logger().info(future.result().message)


class Counter:
    def __init__(self):
        self.kitchen = Kitchen()
        self.till = Till(){mark}

    def order(self):
        self.kitchen.order()
        self.till.order()


def main():
    rclpy.init()
    counter = Counter()
    counter.order()
    {spin}


if __name__ == '__main__':
    main()
"""
DONE = "future.add_done_callback(self.on_answer)"
ONE_OF_TWO = "rclpy.spin(counter.kitchen)"


def till(spin: str, taken: str = DONE, mark: str = "") -> str:
    return TILL.format(spin=spin, taken=taken, mark=mark)


@pytest.mark.parametrize(
    "spin",
    [
        ONE_OF_TWO,
        "threading.Thread(target=rclpy.spin, args=(counter.kitchen,)).start()",
        "executor = MultiThreadedExecutor()\n    executor.add_node(counter.kitchen)\n    executor.spin()",
    ],
)
def test_the_responses_of_one_of_two_nodes_never_come(judge: Judge, spin: str):
    [finding] = judge("EXE008", till(spin, mark="  # here"))
    assert finding.message == "nothing spins this node, so the done callback of its request never runs"
    assert [related.place.line for related in finding.related] == [28]


@pytest.mark.parametrize(
    ("spin", "taken"),
    [
        (ONE_OF_TWO, "self.future = future"),
        (ONE_OF_TWO, "rclpy.spin_until_future_complete(self, future, timeout_sec=1.0)\n        " + DONE),
        ("while rclpy.ok():\n        rclpy.spin_once(counter.kitchen)\n        rclpy.spin_once(counter.till)", DONE),
        (
            "executor = MultiThreadedExecutor()\n    executor.add_node(counter.kitchen)\n"
            "    executor.add_node(counter.till)\n    executor.spin()",
            DONE,
        ),
    ],
    ids=["nobody takes it", "it spins for the response", "both in turns", "both in an executor"],
)
def test_responses_that_nobody_takes_or_that_come(judge: Judge, spin: str, taken: str):
    judge("EXE008", till(spin, taken))
