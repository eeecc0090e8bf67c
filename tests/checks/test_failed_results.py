"""API001: results that are None where an except of the function has caught something."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
from queue import Empty, Queue

import rclpy
import tf2_ros
from geometry_msgs.msg import PoseStamped
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, LookupException, TransformException, TransformListener


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.queue = Queue()
        self.goals = {'kitchen': (1.0, 2.0)}
        self.pub = self.create_publisher(PoseStamped, 'goal', 10)
        self.timer = self.create_timer(1.0, self.plan)

    def position(self):
        try:
            there = self.buffer.lookup_transform('map', 'base_link', Time())
        except TransformException as error:
            self.get_logger().info(f'{error}')
            return None
        return there.transform.translation.x, there.transform.translation.y

    def height(self):
        try:
            return self.buffer.lookup_transform('map', 'base_link', Time()).transform.translation.z
        except Exception as error:
            self.get_logger().info(f'{error}')

    def moved(self, pose):
        try:
            return self.buffer.transform(pose, 'map')
        except (LookupException, tf2_ros.ConnectivityException):
            return

    def goal(self, name):
        try:
            return self.goals[name]
        except KeyError:
            return None

    def area(self):
        try:
            return self.goals['kitchen'][0] * self.goals['kitchen'][1]
        except Exception:
            return None

    def next(self, blocking=False):
        try:
            return self.queue.get(blocking)
        except Empty:
            return None

    def stopped(self):
        try:
            return self.buffer.lookup_transform('map', 'base_link', Time())
        except TransformException:
            raise SystemExit

    def plan(self):
        {lines}


def main():
    rclpy.init()
    rclpy.spin(Planner())


main()
"""


def _node(lines: str) -> str:
    return NODE.replace("{lines}", lines.replace("; ", "\n        "))


@pytest.mark.parametrize(
    ("lines", "message", "line"),
    [
        (
            "x, y = self.position()  # here",
            "position() returns None where it catches TransformException: then this line raises TypeError",
            26,
        ),
        (
            "here = self.position(); print(here[0])  # here",
            "position() returns None where it catches TransformException: then this line raises TypeError",
            26,
        ),
        (
            "print(self.height() * 2.0)  # here",
            "height() returns None where it catches Exception: then this line raises TypeError",
            32,
        ),
        (
            "print(self.moved(PoseStamped()).pose)  # here",
            "moved() returns None where it catches LookupException or ConnectivityException: "
            "then this line raises AttributeError",
            39,
        ),
        (
            "self.pub.publish(self.moved(PoseStamped()))  # here",
            "moved() returns None where it catches LookupException or ConnectivityException: "
            "then this line raises TypeError",
            39,
        ),
    ],
)
def test_a_result_that_is_none_after_a_failure(judge: Judge, lines: str, message: str, line: int):
    (finding,) = judge("API001", _node(lines))
    assert finding.message == message
    assert finding.severity is Severity.WARNING
    assert [row.place.line for row in finding.related] == [line]


def test_what_to_do_about_it(judge: Judge):
    (finding,) = judge("API001", _node("x, y = self.position()  # here"))
    assert finding.help == "give the result of self.position() to a variable first, and go on only if it is not None"
    assert [row.message for row in finding.related] == ["position() returns None behind this except"]


@pytest.mark.parametrize(
    "lines",
    [
        "here = self.position(); if here is None:;     return; x, y = here",
        "here = self.position(); print(here[0] if here else 0.0)",
        "print(self.position())",
        "return self.position()",
        "try:;     x, y = self.position(); except TypeError:;     return",
        "try:;     x, y = self.position(); except Exception:;     return",
        "try:;     x, y = self.position(); except:;     return",
        "if self.buffer.can_transform('map', 'base_link', Time()):;     x, y = self.position()",
        "x, y = self.goal('kitchen')",
        "print(self.area() * 2.0)",
        "print(self.next(blocking=True).pose)",
        "print(self.stopped().transform)",
    ],
)
def test_a_result_that_is_asked_for_or_whose_failure_nobody_expects(judge: Judge, lines: str):
    judge("API001", _node(lines))


def test_a_function_that_is_called_where_any_failure_is_expected(judge: Judge):
    code = _node("x, y = self.position()").replace("1.0, self.plan)", "1.0, self.tick)")
    tick = "    def tick(self):\n        try:\n            self.plan()\n        except Exception as error:\n"
    tick += "            self.get_logger().warning(f'{error}')\n\n"
    judge("API001", code.replace("    def plan(self):", tick + "    def plan(self):"))
