"""EXE003: sleeps that no callback, or one on its way from one state to the next, is long in."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64


class Arm(Node):
    def __init__(self):
        super().__init__('arm')
        self.state, self.homed = 'start', False
        self.publisher = self.create_publisher(Float64, 'angle', 10)
        self.create_subscription(Float64, 'target', self.aim, 10)
        self.thread = threading.Thread(target=self.load)
        self.thread.start()
        self.create_timer(0.1, self.move)
        {last}

    def load(self):
        pass

    def aim(self, target):
        self.publisher.publish(target)

    def move(self):
        {lines}

    def run(self):
        while {test}:
            {step}


def main():
    rclpy.init()
    rclpy.spin(Arm())


main()
"""


def node(*lines: str, last: str = "pass", test: str = "True", step: str = "time.sleep(0.1)") -> str:
    return NODE.format(lines="\n        ".join(lines), last=last, test=test, step=step)


@pytest.mark.parametrize("sleep", ["time.sleep(1.5)", "time.sleep(1.0)\n            time.sleep(1.0)"])
@pytest.mark.parametrize(
    "lines",
    [
        ("if self.state == 'start':", "    {sleep}", "    self.state = 'ready'"),
        ("if not self.homed:", "    self.homed = True", "    {sleep}", "    self.publisher.publish(Float64())"),
        ("if self.homed:", "    return", "self.homed = True", "{sleep}"),
    ],
)
def test_a_short_stay_in_a_state_that_is_left(judge: Judge, lines: tuple[str, ...], sleep: str) -> None:
    """It comes once."""
    sleep = sleep if lines[-1] != "{sleep}" else sleep.replace("            ", "        ")
    assert not judge("EXE003", node(*(line.replace("{sleep}", sleep) for line in lines)))


@pytest.mark.parametrize(
    "lines",
    [
        ("if self.state == 'start':", "    time.sleep(3.0)  # here", "    self.state = 'ready'"),
        ("if self.state == 'start':", "    time.sleep(1.5)  # here", "    self.publisher.publish(Float64())"),
        ("if not self.homed:", "    self.homed = True", "time.sleep(1.5)  # here"),
    ],
)
def test_a_long_stay_or_one_that_comes_again(judge: Judge, lines: tuple[str, ...]) -> None:
    assert judge("EXE003", node(*lines))


def test_a_loop_behind_a_join(judge: Judge) -> None:
    """The thread has ended once join() returns: the loop never goes round."""
    loop = ("while self.thread.is_alive():", "    time.sleep(0.5)")
    assert not judge("EXE003", node("self.thread.join()", *loop))
    for before in ("self.thread.join(0.1)", "self.other.join()"):
        assert judge("EXE003", node(before, loop[0], f"{loop[1]}  # here"))


def test_a_constructor_that_never_returns(judge: Judge) -> None:
    """Nothing ever spins the node, so that none of its callbacks runs."""
    slow = ("time.sleep(5.0)",)
    assert not judge("EXE003", node(*slow, last="self.run()"))
    slow = ("time.sleep(5.0)  # here",)
    assert judge("EXE003", node(*slow))
    assert judge("EXE003", node(*slow, last="self.run()", test="self.homed"))
    assert judge("EXE003", node(*slow, last="self.run()", step="rclpy.spin_once(self, timeout_sec=0.1)"))
