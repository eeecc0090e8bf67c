"""How calls of rclpy go: the name of a publisher tells of each."""

from __future__ import annotations

import re

import rclpy
from rclpy.node import Node
from std_msgs.msg import Empty

made = 0


def fresh(**options):
    """A node that nothing was done with yet."""
    global made
    made += 1
    return Node(f"fresh_{made}", **options)


def tell(what, calls, node_of):
    """Makes each call, with a node, and tells what came of it."""
    rclpy.init()
    telling = Node("telling")
    for number, call in enumerate(calls):
        telling.create_publisher(Empty, f"{what}_{number}/{outcome(call, node_of())}", 1)


def outcome(call, node):
    """What a call gave, or raised, as a word that a name may hold."""
    try:
        value = call(node)
    except Exception as error:
        return type(error).__name__
    shown = type(value).__name__ if " object at 0x" in repr(value) else repr(value)
    return "is_" + re.sub(r"\W+", "_", shown)
