"""API002: methods that an attribute of the same name hides."""

from __future__ import annotations

import pytest

from checks.judging import Judge

MAPPER = """
import math

import rclpy
from nav_msgs.msg import Odometry
from rclpy.node import Node


class Mapper(Node):
    def __init__(self):
        super().__init__('mapper')
        {first}
        self.create_subscription(Odometry, 'odom', self.on_odom, 10)

    def heading(self):
        return 0.5

    def on_odom(self, msg):
        {second}
        {call}


def main():
    rclpy.init()
    rclpy.spin(Mapper())


if __name__ == '__main__':
    main()
"""
NONE = "self.heading = None"
AIMS = "self.heading = math.atan2(msg.pose.pose.position.y, msg.pose.pose.position.x)"
TURNS = "print(self.heading() + math.pi)"


@pytest.mark.parametrize(
    ("first", "second", "call"),
    [
        pytest.param(NONE, AIMS, TURNS, id="a number later"),
        pytest.param("self.heading = 0.0", "pass", TURNS, id="a number from the beginning"),
        pytest.param("self.name, self.heading = 'mapper', []", "pass", "self.heading()", id="one of two"),
    ],
)
def test_a_method_that_the_constructor_hides(judge: Judge, first: str, second: str, call: str):
    code = MAPPER.format(first=f"{first}  # here", second=second, call=call)
    [found] = judge("API002", code)
    assert found.message == "from here on self.heading is no method of Mapper: calling it fails with a TypeError"
    assert found.help == "give the attribute another name than heading"
    [called] = found.related
    assert (called.message, called.place.line) == (
        "heading() is called here",
        code.splitlines().index(f"        {call}"),
    )


@pytest.mark.parametrize(
    ("first", "second", "call"),
    [
        pytest.param("self.last_heading = None", AIMS.replace("heading", "last_heading"), TURNS, id="another name"),
        pytest.param(NONE, AIMS, "print(self.heading)", id="nothing calls it"),
        pytest.param(NONE, "self.heading = self.get_clock", TURNS, id="it may get a function"),
        pytest.param(NONE, "self.heading = lambda: 1.0", TURNS, id="it gets one"),
        pytest.param("self.reading = self.heading()\n        self.heading = 0.0", "pass", "pass", id="called before"),
        pytest.param("if rclpy.ok(): self.heading = None", "pass", TURNS, id="it may not be assigned"),
        pytest.param(NONE, "pass", "if self.heading is not None: self.heading()", id="a condition asks for it"),
        pytest.param(NONE, "pass", "if callable(self.heading): self.heading()", id="a condition asks whether it can"),
    ],
)
def test_what_is_or_may_be_a_method(judge: Judge, first: str, second: str, call: str):
    judge("API002", MAPPER.format(first=first, second=second, call=call))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        pytest.param("    def heading(", "    @property\n    def heading(", id="a property"),
        pytest.param(
            "rclpy.spin(Mapper())", "mapper = Mapper(); mapper.heading = print; rclpy.spin(mapper)", id="given"
        ),
        pytest.param(
            "    def heading(", "    def __setattr__(self, name, value): pass\n\n    def heading(", id="watched"
        ),
        pytest.param("self.on_odom, 10", "print, 10", id="nothing calls the method that calls it"),
        pytest.param(
            f"        {TURNS}", f"        try: {TURNS}\n        except TypeError: pass", id="it is expected to fail"
        ),
    ],
)
def test_a_class_in_which_nothing_fails_for_sure(judge: Judge, old: str, new: str):
    code = MAPPER.format(first=NONE, second="pass", call=TURNS)
    assert old in code
    judge("API002", code.replace(old, new))
