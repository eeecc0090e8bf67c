"""API003: constructors that use the node before it is one."""

from __future__ import annotations

import pytest

from checks.judging import Judge

CLASS = """
import rclpy
from helpers import prepare
from rclpy.node import Node


class Mixin:
    def __init__(self, name):
        self.mixed = name


class Robot({bases}):
    def __init__(self):
        {body}

    def set_up(self):
        self.create_timer(1.0, self.tick){mark}

    def tick(self):
        pass
"""


def robot(*lines: str, bases: str = "Node", mark: str = "") -> str:
    return CLASS.format(bases=bases, body="\n        ".join(lines), mark=mark)


@pytest.mark.parametrize(
    "source",
    [
        robot("self.get_parameter('rate')  # here", "super().__init__('robot')"),
        robot("self.create_timer(1.0, self.tick)  # here"),
        robot("self.create_timer(1.0, self.tick)  # here", "self.create_rate(1.0)", "Node.__init__(self, 'robot')"),
        robot("self.set_up()", "super().__init__('robot')", mark="  # here"),
        robot("super().__init__('robot')", "self.create_rate(1.0)  # here", bases="Mixin, Node"),
    ],
    ids=["before", "never", "by its class", "in a method", "a mixin that does not pass it on"],
)
def test_a_node_that_is_used_before_it_is_initialised(judge: Judge, source: str):
    [finding] = judge("API003", source)
    assert finding.message.endswith("() fails: Robot has not called super().__init__() yet")


@pytest.mark.parametrize(
    "source",
    [
        robot("super().__init__('robot')", "self.create_timer(1.0, self.tick)"),
        robot("Node.__init__(self, 'robot')", "self.set_up()"),
        robot("self.name = 'robot'", "super().__init__(self.name)", "self.set_up()"),
        robot("super().__init__('robot')", "self.set_up()", bases="Node, Mixin"),
        robot("if rclpy.ok():", "    super().__init__('robot')", "self.set_up()"),
        robot("prepare(self)", "self.set_up()", bases="prepare.Base"),
        robot("rclpy.init()"),
        robot("super.__init__('robot')", "self.set_up()"),  # a TypeError right there: API001
        robot("Node.__init__('robot')", "self.set_up()"),  # a TypeError: API001
        robot("super().__init('robot')", "self.set_up()"),  # an AttributeError right there: API002
        robot("super().init('robot')", "self.set_up()"),
    ],
    ids=[
        *("first", "by its class", "attributes before", "a mixin behind", "undecided", "foreign base", "no use"),
        *("super without parentheses", "without self", "a private name", "no underscores"),
    ],
)
def test_a_node_that_is_initialised_first(judge: Judge, source: str):
    judge("API003", source)


@pytest.mark.parametrize("constructor", ["super().__init__()", "self.name = 'robot'"])
def test_a_class_to_be_mixed_into_a_node(judge: Judge, constructor: str):
    """What it is a base of beside Node decides whether it is a node by then."""
    source = f"""
        from std_msgs.msg import String


        class Listening:
            def __init__(self):
                {constructor}
                self.create_subscription(String, 'data', self.hear, 10)

            def hear(self, message):
                pass


        class Hearing(Listening):
            def __init__(self):
                super().__init__()
        """
    judge("API003", source)


def test_a_class_that_is_derived_from_calls_the_constructor_of_its_base(judge: Judge):
    judge(
        "API003",
        """
        from rclpy.node import Node


        class Base(Node):
            def __init__(self, name):
                super().__init__(name)
                self.set_up()

            def set_up(self):
                pass


        class Robot(Base):
            def __init__(self):
                super().__init__('robot')

            def set_up(self):
                self.create_timer(1.0, print)
        """,
    )


PROGRAM = """
import os
import rclpy
from rclpy.context import Context
from rclpy.node import Node


class Robot(Node):
    def __init__(self, **options):
        super().__init__('robot', **options)


def main():
    {body}


if __name__ == '__main__':
    main()
"""


def program(*lines: str) -> str:
    return PROGRAM.format(body="\n    ".join(lines))


@pytest.mark.parametrize(
    ("source", "node"),
    [
        (program("robot = Robot()  # here", "rclpy.init()", "rclpy.spin(robot)"), "Robot"),
        (program("robot = rclpy.create_node('robot')  # here", "rclpy.init(args=None)"), "create_node"),
    ],
    ids=["of a class", "without one"],
)
def test_a_node_that_is_made_before_rclpy_is_initialised(judge: Judge, source: str, node: str):
    [finding] = judge("API003", source)
    assert finding.message == f"{node}() fails: rclpy.init() is called after it"


@pytest.mark.parametrize(
    "source",
    [
        program("rclpy.init()", "robot = Robot()", "rclpy.spin(robot)"),
        program("robot = Robot()", "if not rclpy.ok():", "    rclpy.init()"),
        program("if os.environ.get('SIM'):", "    robot = Robot()", "rclpy.init()"),
        program("context = Context()", "rclpy.init(context=context)", "robot = Robot(context=context)"),
        program("rclpy.init()", "Robot()", "rclpy.shutdown()", "rclpy.init()", "Robot()"),
    ],
    ids=["first", "perhaps", "a node in a branch", "a context of its own", "twice"],
)
def test_a_node_that_is_made_after_it(judge: Judge, source: str):
    judge("API003", source)


def test_a_class_that_is_mixed_into_a_node(judge: Judge):
    judge(
        "API003",
        """
        import rclpy


        class Scenes:
            def __init__(self):
                super(Scenes, self).__init__()
                self.create_subscription(object, 'scene', print, 5)


        class Objects(Scenes):
            def __init__(self):
                super(Objects, self).__init__()
                self.create_client(object, 'start')
        """,
    )
