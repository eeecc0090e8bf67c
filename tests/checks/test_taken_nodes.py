"""EXE008: nodes that a short spin takes from the executor which is to run them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
import threading

import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.client = self.create_client(Trigger, 'ask')
        self.timer = self.create_timer(0.1, self.tick)

    def tick(self):
        self.get_logger().info('tick')

    def ask(self):
        future = self.client.call_async(Trigger.Request())
        {ask}
        return future


def main():
    rclpy.init()
    node = Asker()
    executor = MultiThreadedExecutor()
    {lines}


if __name__ == '__main__':
    main()
"""
SPIN = "rclpy.spin_until_future_complete"
UNTIL = f"{SPIN}(self, future, timeout_sec=1.0)"
IN_THREAD = ("executor.add_node(node)", "thread = threading.Thread(target=executor.spin)", "thread.start()")


def program(*lines: str, ask: str = "pass") -> str:
    return PROGRAM.format(ask=ask, lines="\n    ".join(lines))


@pytest.mark.parametrize(
    ("lines", "ask", "name"),
    [
        ((*IN_THREAD, "node.ask()", "thread.join()"), UNTIL + "  # here", SPIN),
        ((*IN_THREAD, "rclpy.spin_once(node, timeout_sec=1.0)  # here", "thread.join()"), "pass", "rclpy.spin_once"),
        (
            ("executor.add_node(node)", "node.ask()", "executor.spin()"),
            UNTIL + "  # here",
            "spin_until_future_complete",
        ),
        (
            ("executor.add_node(node)", "rclpy.spin_once(node, timeout_sec=1.0)  # here", "executor.spin()"),
            "pass",
            "rclpy.spin_once",
        ),
    ],
)
def test_a_spin_that_takes_the_node_from_its_executor(judge: Judge, lines: tuple[str, ...], ask: str, name: str):
    """Under rclpy of jazzy no timer of the node runs after each of these."""
    (finding,) = judge("EXE008", program(*lines, ask=ask))
    told = (
        f"{name.removeprefix('rclpy.')}() takes the node from its executor, so the callback of its timer no longer runs"
    )
    assert finding.message == told
    assert finding.related[-1].message == "this executor has the node until then"


@pytest.mark.parametrize(
    ("lines", "ask"),
    [
        (("node.ask()", "executor.add_node(node)", "executor.spin()"), UNTIL),
        (("executor.add_node(node)", "node.ask()", "executor.add_node(node)", "executor.spin()"), UNTIL),
        (("executor.add_node(node)", "node.ask()", "rclpy.spin(node)"), UNTIL),
        (
            (*IN_THREAD, "rclpy.spin_until_future_complete(node, node.ask(), executor, 1.0)", "thread.join()"),
            "pass",
        ),
        ((*IN_THREAD, "executor.spin_until_future_complete(node.ask(), 1.0)", "thread.join()"), "pass"),
        (("executor.add_node(node)", "executor.spin()", "rclpy.spin_once(node)"), "pass"),
        ((*IN_THREAD, "while rclpy.ok():", "    rclpy.spin_once(node)"), "pass"),
        (("executor.add_node(node)", "if input():", "    node.ask()", "else:", "    executor.spin()"), UNTIL),
    ],
)
def test_a_node_that_something_spins_afterwards(judge: Judge, lines: tuple[str, ...], ask: str):
    judge("EXE008", program(*lines, ask=ask))


def test_a_spin_without_a_timeout_that_must_not_spin_at_all(judge: Judge):
    """TMO003 would ask for a timeout, which mends nothing."""
    without = UNTIL.replace(", timeout_sec=1.0", "")
    judge("TMO003", program(*IN_THREAD, "node.ask()", "thread.join()", ask=without))
