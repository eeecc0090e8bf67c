"""OWN001: topics that the remappings of a launch file make one."""

from __future__ import annotations

import pytest

from robot_package import node

PLANNER = """\
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.out = self.create_publisher(Twist, '/plan', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        self.out.publish(Twist())


def main():
    rclpy.init()
    rclpy.spin(Planner())
"""


def _remapped(name: str, target: str | None) -> str:
    return "\n" + node("" if target is None else f'<remap from="/plan" to="{target}"/>', name=name)


def test_the_remapping_is_what_is_wrong(findings):
    """Each robot has a planner, and the third is given the topic of the second."""
    launch = _remapped("a", "/a/plan") + _remapped("b", "/b/plan") + _remapped("c", "/b/plan")
    (finding,) = findings("OWN001", launch, **{"robot/talker.py": PLANNER})
    assert finding.message == "/b and /c both publish the topic '/b/plan'"
    assert (finding.place.file, finding.place.line) == ("launch/it.launch.xml", 4)
    assert [(row.place.file, row.place.line) for row in finding.related] == [
        ("launch/it.launch.xml", 3),
        ("robot/talker.py", 9),
    ]
    assert finding.help == (
        "remap each to a topic of its own, or list the topic under shared-topics if it is meant to be shared"
    )


@pytest.mark.parametrize("target", [None, "/plan"])
def test_what_no_remapping_makes_one_is_told_in_the_code(findings, target: str | None):
    launch = _remapped("a", target) + _remapped("b", target)
    (finding,) = findings("OWN001", launch, **{"robot/talker.py": PLANNER})
    assert (finding.place.file, finding.place.line) == ("robot/talker.py", 9)
