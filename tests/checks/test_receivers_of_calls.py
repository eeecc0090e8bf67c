"""API001: calls that lack a node or an object, and functions that only look like methods."""

from __future__ import annotations

import pytest

from checks.judging import Judge

ANGLES = """
import math

import rclpy
from rclpy.node import Node


def normalize({params}):
    return math.atan2(math.sin(angle), math.cos(angle))


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_timer(0.1, self.look)

    def look(self):
        print(normalize(0.5){mark}
        print({other})


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize("params", ["self, angle", "self, angle, most=3.0"])
def test_a_function_with_the_self_of_a_method(judge: Judge, params: str) -> None:
    """Every call leaves it out: not the calls are wrong."""
    [finding] = judge("API001", ANGLES.format(params=params, mark=")  # here", other="1"))
    assert finding.message == "normalize() fails: 'angle' is missing, as 'self' takes the first argument"
    assert finding.help == "normalize() is no method: take 'self' out of its parameters"


@pytest.mark.parametrize("other", ["normalize(self, 0.5)", "[*map(normalize, [self], [0.5])]"])
def test_a_function_to_which_others_pass_the_object(judge: Judge, other: str) -> None:
    [finding] = judge("API001", ANGLES.format(params="self, angle", mark=")  # here", other=other))
    assert finding.help == "give what it takes: normalize(self, angle)"


SPINS = """
import rclpy
from rclpy.node import Node


class Robot(Node):
    def __init__(self):
        super().__init__('robot')

    def wait(self):
        {in_method}


def main():
    rclpy.init()
    {made}
    robot.wait()
    {in_main}


main()
"""


def test_a_spin_without_the_node_that_is_there(judge: Judge) -> None:
    """The other arguments stay as they are."""
    text = SPINS.format(
        in_method="rclpy.spin_once(timeout_sec=0.1)  # here",
        made="robot = Robot()",
        in_main="rclpy.spin()  # here",
    )
    helps = [finding.help for finding in judge("API001", text)]
    assert helps == ["write spin_once(self, timeout_sec=…)", "write spin(robot)"]


def test_a_spin_for_a_future_in_place_of_the_node(judge: Judge) -> None:
    lines = "answer = robot.create_future()\n    rclpy.spin_until_future_complete({})  # here"
    text = SPINS.format(in_method="pass", made="robot = Robot()", in_main=lines.format("answer, timeout_sec=2.0"))
    [finding] = judge("API001", text)
    assert finding.help == "write spin_until_future_complete(robot, answer, timeout_sec=…)"
    text = SPINS.format(in_method="pass", made="robot = Robot()", in_main=lines.format("robot"))
    [finding] = judge("API001", text)
    assert finding.help == "write spin_until_future_complete(node, future)"


def test_a_spin_where_no_node_has_a_name(judge: Judge) -> None:
    text = SPINS.format(in_method="pass", made="robot, other = Robot(), Robot()", in_main="rclpy.spin()  # here")
    [finding] = judge("API001", text)
    assert finding.help == "pass the node that it is to spin: spin(…)"


DETECTOR = """
import sys
from pathlib import Path

import rclpy
from rclpy.node import Node

ROOT = Path(__file__).resolve().parents[3]
{path}
from models.common import load


class Detector(Node):
    def __init__(self):
        super().__init__('detector')
        self.model = load('net', half=True){mark}


def main():
    rclpy.init()
    rclpy.spin(Detector())
"""


@pytest.mark.parametrize("path", ["sys.path.append(str(ROOT))", "sys.path = [str(ROOT), *sys.path]"])
def test_a_module_that_several_folders_have(judge: Judge, path: str) -> None:
    """Which of them is meant depends on where the program says that Python is to look."""
    for folder in ("old", "new"):
        (judge.folder / folder / "models").mkdir(parents=True)
        (judge.folder / folder / "models" / "__init__.py").write_text("", encoding="utf-8")
        (judge.folder / folder / "models" / "common.py").write_text(
            "def load(name):\n    return name\n", encoding="utf-8"
        )
    assert not judge("API001", DETECTOR.format(path=path, mark=""))


def test_the_only_module_of_a_name(judge: Judge) -> None:
    (judge.folder / "new" / "models").mkdir(parents=True)
    (judge.folder / "new" / "models" / "__init__.py").write_text("", encoding="utf-8")
    (judge.folder / "new" / "models" / "common.py").write_text("def load(name):\n    return name\n", encoding="utf-8")
    judge("API001", DETECTOR.format(path="sys.path.append(str(ROOT))", mark="  # here"))
