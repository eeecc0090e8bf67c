"""Mistakes for another value of a parameter than its default, which nobody gives: nobody meets them."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


class Layer:
    def __init__(self, size, attention=False, drop=0.0, path=None, mode='flat'):
        self.size = size
{inside}


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.layer = {call}


def main():
    rclpy.init()
    rclpy.spin(Talker())


main()
"""


def _layer(inside: str, call: str = "Layer(3)") -> str:
    return NODE.format(inside="\n".join(f"        {line}" for line in inside.splitlines()), call=call)


@pytest.mark.parametrize(
    "inside",
    [
        "if attention:\n    self.block = Block(size)",
        "if not attention:\n    return\nself.block = Block(size)",
        "self.block = Block(drop) if drop > 0.0 else None",
        "if path is not None and size:\n    self.block = Block(path)",
        "if attention is True:\n    self.block = Block(size)",
        "if attention is not False:\n    self.block = Block(size)",
        "if mode == 'deep':\n    self.block = Block(size)",
    ],
)
def test_a_branch_that_the_default_leaves_out(judge: Judge, inside: str):
    judge("API005", _layer(inside))


@pytest.mark.parametrize(
    ("inside", "call"),
    [
        ("if attention:\n    self.block = Block(size)  # here", "Layer(3, attention=True)"),
        ("if attention:\n    self.block = Block(size)  # here", "Layer(3, True)"),
        ("if attention:\n    self.block = Block(size)  # here", "Layer(*[3, True])"),
        ("if attention:\n    self.block = Block(size)  # here", "Layer(3, **{'attention': True})"),
        ("if not attention:\n    self.block = Block(size)  # here", "Layer(3)"),
        ("if attention is False:\n    self.block = Block(size)  # here", "Layer(3)"),
        ("if mode == 'flat':\n    self.block = Block(size)  # here", "Layer(3)"),
        ("if mode == 'deep':\n    self.block = Block(size)  # here", "Layer(3, mode='deep')"),
        ("if attention or size:\n    self.block = Block(size)  # here", "Layer(3)"),
        ("attention = size > 2\nif attention:\n    self.block = Block(size)  # here", "Layer(3)"),
        ("self.block = None if drop > 0.0 else Block(size)  # here", "Layer(3)"),
        ("if attention:\n    self.block = Block(size)  # here", "None"),
    ],
)
def test_a_branch_that_somebody_may_come_to(judge: Judge, inside: str, call: str):
    (told,) = judge("API005", _layer(inside, call))
    assert told.severity == Severity.ERROR


def test_a_class_that_derives_from_it_may_give_the_value(judge: Judge):
    inside = "if attention:\n    self.block = Block(size)  # here"
    wide = "\n\nclass Wide(Layer):\n    def __init__(self):\n        super().__init__(9, True)\n"
    (told,) = judge("API005", _layer(inside) + wide)
    assert told.severity == Severity.ERROR
