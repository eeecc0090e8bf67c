"""Data that a callback leaves in an attribute for another."""

from __future__ import annotations

import pytest

from dataflow.tracing import Traced

KEEPER = """
def __init__(self):
    super().__init__("keeper")
    self.latest = None
    self.items = []
    self.state = State()
    self.create_subscription(String, "in", self.on_in, 10)
    self.pub = self.create_publisher(String, "out", 10)
    self.create_timer(0.1, self.tick)

def on_in(self, message):
    {leave}

def tick(self):
    {take}
    self.pub.publish(String())

def keep(self, message):
    self.latest = message

@property
def newest(self):
    return self.latest
"""
PAIRS = {
    "assigned and read": ("self.latest = message", "text = self.latest"),
    "appended and taken": ("self.items.append(message)", "text = self.items.pop()"),
    "an item": ("self.items[0] = message", "text = self.items[0]"),
    "a part of it": ("self.state.pose = message", "text = self.state.pose.x"),
    "a part, read as a whole": ("self.state.pose = message", "work(self.state)"),
    "a whole, of which a part is read": ("self.state = message", "text = self.state.pose"),
    "by a method": ("self.keep(message)", "text = self.latest"),
    "through a property": ("self.latest = message", "text = self.newest"),
    "in a condition": ("self.latest = message", "if self.latest is None: return"),
    "one of two targets": ("self.first, self.latest = message, 1", "text = self.latest"),
}
APART = {
    "another attribute": ("self.latest = message", "text = self.items"),
    "another part": ("self.state.pose = message", "text = self.state.speed"),
    "for the log alone": ("self.latest = message", "self.get_logger().info(f'{self.latest}')"),
    "a local variable": ("latest = message", "text = self.latest"),
    "written by both, read by none": ("self.latest = message", "self.latest = None"),
    "read by both": ("text = self.latest", "text = self.latest"),
}


def keeper(leave: str, take: str) -> str:
    return KEEPER.format(leave=leave, take=take)


@pytest.mark.parametrize(("leave", "take"), PAIRS.values(), ids=PAIRS)
def test_it_goes_from_one_callback_to_the_other(traced: Traced, leave: str, take: str) -> None:
    assert "topic /in" in traced(keeper=keeper(leave, take)).before("/out")


@pytest.mark.parametrize(("leave", "take"), APART.values(), ids=APART)
def test_the_callbacks_have_nothing_to_do_with_each_other(traced: Traced, leave: str, take: str) -> None:
    assert traced(keeper=keeper(leave, take)).before("/out") == {"Keeper.tick"}


def test_attributes_that_the_same_callbacks_use_are_one_step(traced: Traced) -> None:
    traced(keeper=keeper("self.latest = self.first = message", "text = self.latest or self.first"))
    assert "kept self.first, self.latest" in traced.before("/out")


def test_a_base_class_keeps_it(traced: Traced) -> None:
    traced.file(
        "base.py",
        """
        from rclpy.node import Node
        from std_msgs.msg import String

        class Base(Node):
            def __init__(self, name):
                super().__init__(name)
                self.latest = None
                self.create_subscription(String, "in", self.on_in, 10)

            def on_in(self, message):
                self.latest = self.changed(message)
        """,
    )
    traced.file(
        "node.py",
        """
        import rclpy
        from base import Base
        from std_msgs.msg import String

        class Derived(Base):
            def __init__(self):
                super().__init__("derived")
                self.pub = self.create_publisher(String, "out", 10)
                self.create_timer(0.1, self.tick)

            def changed(self, message):
                self.seen = True
                return message

            def tick(self):
                if self.seen:
                    self.pub.publish(self.latest)

        rclpy.init()
        rclpy.spin(Derived())
        """,
    )
    assert traced.before("/out") == {"Derived.tick", "kept self.latest, self.seen", "Base.on_in", "topic /in"}


def test_a_global_variable_keeps_it(traced: Traced) -> None:
    traced.file(
        "node.py",
        """
        import rclpy
        from std_msgs.msg import String

        latest = None

        def on_in(message):
            global latest
            latest = message

        def tick():
            publisher.publish(latest)

        rclpy.init()
        node = rclpy.create_node("keeper")
        node.create_subscription(String, "in", on_in, 10)
        publisher = node.create_publisher(String, "out", 10)
        node.create_timer(0.1, tick)
        rclpy.spin(node)
        """,
    )
    assert traced.before("/out") == {"tick", "kept latest", "on_in", "topic /in"}
