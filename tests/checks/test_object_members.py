"""API002: what times, durations, parameters and the handles of goals do not have; API001: numbers in place of times."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.declare_parameter('speed', 1.0)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.server = ActionServer(self, Fibonacci, 'count', self.count)
        self.limit = Duration(seconds=2)

    def count(self, goal_handle):
        now = self.get_clock().now()
        {line}
        goal_handle.succeed()
        return Fibonacci.Result()


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        ("print(now.nanosec)", "Time has no 'nanosec': this line fails", "write to_msg().nanosec"),
        ("print(now.to_sec())", "Time has no 'to_sec'", "write nanoseconds / 1e9"),
        ("print(self.limit.seconds)", "Duration has no 'seconds'", "write nanoseconds / 1e9; the whole"),
        ("print(Time.now())", "Time has no 'now'", "write get_clock().now() of a node"),
        ("print(now.nanoseconds())", "'nanoseconds' of a Time is a value, no method", "without parentheses"),
        ("print(self.get_parameter('speed').value())", "'value' of a Parameter is a value", "without parentheses"),
        ("print(self.get_parameter('speed').get_value())", "Parameter has no 'get_value'", "write value"),
        (
            "print(self.get_parameter('speed').get_parameter_value().float_value)",
            "ParameterValue has no 'float_value'",
            "write double_value",
        ),
        ("print(goal_handle.order)", "ServerGoalHandle has no 'order'", "write request.order if it is a field"),
        ("goal_handle.set_succeeded()", "ServerGoalHandle has no 'set_succeeded'", "write succeed"),
    ],
)
def test_a_member_that_an_object_of_rclpy_does_not_have(judge: Judge, line: str, message: str, help: str):
    (told,) = judge("API002", NODE.replace("{line}", f"{line}  # here"))
    assert message in told.message
    assert help in told.help


def test_a_variable_right_behind_what_it_is_assigned(judge: Judge):
    """Though it becomes a number afterwards."""
    lines = (
        "passed = self.get_clock().now() - now",
        "passed, _ = passed.seconds_nanoseconds  # here",
        "print(passed.real)",
    )
    (told,) = judge("API002", NODE.replace("{line}", "\n        ".join(lines)))
    assert told.message.startswith("Duration has no 'seconds_nanoseconds'")


@pytest.mark.parametrize(
    "lines",
    [
        ("passed = self.get_clock().now() - now", "passed = passed.nanoseconds / 1e9", "print(passed.real)"),
        ("passed = self.get_clock().now() - now", "passed = 1.5", "print(passed.real)"),
        ("passed = self.get_clock().now() - now", "print([passed.real for passed in (1, 2)])", "passed = 2"),
        ("passed = self.get_clock().now() - now", "if self.limit:", "    passed = 1.5", "print(passed.real)"),
    ],
)
def test_a_variable_that_is_something_else_by_then(judge: Judge, lines: tuple[str, ...]):
    judge("API002", NODE.replace("{line}", "\n        ".join(lines)))


@pytest.mark.parametrize(
    "line",
    [
        "print(now.nanoseconds, now.to_msg().sec, now.seconds_nanoseconds(), now.clock_type)",
        "print(Time.from_msg(now.to_msg()), self.limit.nanoseconds, Time().nanoseconds)",
        "print(self.get_parameter('speed').value, self.get_parameter('speed').get_parameter_value().double_value)",
        "print(goal_handle.request.order, goal_handle.goal_id, goal_handle.is_cancel_requested)",
        "goal_handle.started = now; print(goal_handle.started)",
        "now = print; print(now.nanosec)",
        "goal_handle = print; print(goal_handle.order)",
    ],
)
def test_members_that_are_there_or_may_be(judge: Judge, line: str):
    judge("API002", NODE.replace("{line}", line))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("self.get_clock().sleep_for(0.5)", "sleep_for() fails: 'rel_time' takes a Duration of rclpy, not a number"),
        ("self.buffer.lookup_transform('a', 'b', Time(), timeout=1.0)", "'timeout' takes a Duration of rclpy"),
        ("self.buffer.can_transform('a', 'b', Time(), 1.0)", "can_transform() fails: 'timeout' takes a Duration"),
        ("self.buffer.lookup_transform('a', 'b', 0)", "'time' takes a Time of rclpy, not a number"),
    ],
)
def test_a_number_in_place_of_a_time(judge: Judge, line: str, message: str):
    (told,) = judge("API001", NODE.replace("{line}", f"{line}  # here"))
    assert message in told.message


@pytest.mark.parametrize(
    "line",
    [
        "self.get_clock().sleep_for(self.limit)",
        "self.buffer.lookup_transform('a', 'b', now, timeout=self.limit)",
        "self.buffer.lookup_transform('a', 'b', Time(), timeout=Duration(seconds=1.0))",
        "self.buffer.lookup_transform('a', 'b', *[Time(), self.limit])",
        "self.tree.lookup_transform(1.0, 2.0)",
    ],
)
def test_times_where_times_are_wanted(judge: Judge, line: str):
    judge("API001", NODE.replace("{line}", line))


# ------------------------------------------------------------------------------------------------ PRM011


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("print(1.0 / self.declare_parameter('rate', 2.0))", "'/' fails with a TypeError: this is a Parameter"),
        ("print(1.0 / self.get_parameter('speed'))", "'/' fails with a TypeError: this is a Parameter"),
        ("print(self.get_parameter('speed') > 0.5)", "'>' fails with a TypeError: this is a Parameter"),
        ("print(self.get_parameter('speed') == 1.0)", "this is always false: '==' compares a Parameter"),
        ("print(float(self.get_parameter('speed')))", "float() fails with a TypeError: this is a Parameter"),
        ("print([step for step in self.get_parameter('speed')])", "a loop fails with a TypeError: this is a Parameter"),
        ("print([*zip([1], self.get_parameter('speed'))])", "zip() fails with a TypeError: this is a Parameter"),
        ("print(1 if self.get_parameter('speed') else 2)", "this is always true: it asks a Parameter"),
        ("print(not self.get_parameter('speed'))", "this is always true: it asks a Parameter"),
    ],
)
def test_a_parameter_in_place_of_its_value(judge: Judge, line: str, message: str):
    (told,) = judge("PRM011", NODE.replace("{line}", f"{line}  # here"))
    assert message in told.message


def test_a_parameter_that_is_kept(judge: Judge):
    kept = "self.speed = self.get_parameter('speed')\n        if self.speed:  # here\n            pass"
    judge("PRM011", NODE.replace("{line}", kept))


@pytest.mark.parametrize(
    "line",
    [
        "print(1.0 / self.declare_parameter('rate', 2.0).value)",
        "print(1.0 / self.get_parameter('speed').value)",
        "print([*zip([1], self.get_parameter('speed').value)])",
        "print('%s' % self.get_parameter('speed'), f\"{self.get_parameter('speed')}\", self.get_parameter('speed'))",
        "print(self.get_parameter('speed') is None, self.get_parameter('speed') == self.get_parameter('speed'))",
        "self.speed = self.get_parameter('speed'); self.speed = 1.0; print(self.speed > 0.5)",
        "self.late = None; self.late = self.get_parameter('speed'); print(1 if self.late else 2)",
        "print(self.settings.get_parameter('speed') > 0.5)",
    ],
)
def test_what_may_be_done_with_a_parameter(judge: Judge, line: str):
    judge("PRM011", NODE.replace("{line}", line))


def test_a_get_parameter_of_the_team_s_own_may_return_anything(judge: Judge):
    base = (
        "from rclpy.node import Node\n\n\nclass Base(Node):\n    def get_parameter(self, name):\n        return 1.0\n"
    )
    judge("PRM011", NODE.replace("{line}", "print(self.get_parameter('speed') > 0.5)"), base)


@pytest.mark.parametrize("base", ["Framework", "Node, Framework"])
def test_a_class_of_somebody_else_may_have_another_get_parameter(judge: Judge, base: str):
    source = NODE.replace("{line}", "print(self.get_parameter('speed') > 0.5)")
    judge("PRM011", "from framework import Framework\n" + source.replace("Robot(Node)", f"Robot({base})"))
