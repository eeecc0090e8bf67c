"""API002: what objects of the workspace's own classes do not have, in a list, a dict or a variable."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node


class Wheel:
    def __init__(self, radius):
        self.radius = radius

    def turn(self, speed):
        self.speed = speed

    def calibrate(self):
        self.offset = 0.0


class Track:
    def __init__(self, length):
        self.length = length

    def turn(self, speed):
        print(speed)


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.wheels = [Wheel(0.1), Wheel(0.1)]
        self.named = {'left': Wheel(0.2)}
        self.front = self.wheels[0]
        self.both = [Wheel(0.1), Track(1.0)]
        self.front.colour = 'red'
        self.create_timer(1.0, self.tick)

    def tick(self):
        {line}

    def pick(self):
        return self.both[int(input())]


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize(
    ("line", "name", "meant"),
    [
        ("self.wheels[0].trun(1.0)", "trun", "turn"),
        ("print([wheel.radios for wheel in self.wheels])", "radios", "radius"),
        ("self.named['left'].brake()", "brake", ""),
        ("print(self.front.raduis)", "raduis", "radius"),
    ],
)
def test_what_an_object_does_not_have(judge: Judge, line: str, name: str, meant: str):
    [finding] = judge("API002", NODE.replace("{line}", f"{line}  # here"))
    assert finding.message.startswith(f"class Wheel has no '{name}': this line fails with an AttributeError")
    assert finding.meant == meant


def test_an_attribute_of_the_items_of_a_loop(judge: Judge):
    line = "for wheel in self.wheels:\n            print(wheel.sped)  # here"
    [finding] = judge("API002", NODE.replace("{line}", line))
    assert finding.help == "write speed"


@pytest.mark.parametrize(
    "line",
    [
        "self.wheels[0].turn(1.0)",
        "print(self.front.offset)",  # another method gives it
        "print(self.front.colour)",  # other code gives it
        "[item.turn(1.0) for item in self.both]",
        "print(self.pick().radius)",  # of one of them
        "for item in self.both:\n            if isinstance(item, Track):\n                print(item.length)",
        "print(self.front.weight if hasattr(self.front, 'weight') else 0)",
        "try:\n            self.front.brake()\n        except AttributeError:\n            pass",
        "print(getattr(self.front, 'brake', None))",
    ],
)
def test_what_an_object_has_or_may_have(judge: Judge, line: str):
    assert not judge("API002", NODE.replace("{line}", line))
