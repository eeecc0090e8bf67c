"""``spin_once()`` in a loop: it spins to the end of the program where nothing but ROS's own end leaves the loop."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent, indent

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.model import SpinDuration

MAIN = """\
import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('robot')
BODY


main()
"""


def lasting(folder: Path, monkeypatch: pytest.MonkeyPatch, body: str) -> SpinDuration:
    """How long the only executor of a program spins."""
    monkeypatch.chdir(folder)
    (folder / "robot.py").write_text(MAIN.replace("BODY", indent(dedent(body).strip(), "    ")), encoding="utf-8")
    system = graph(Request((".",), Settings(), cached=False, jobs=1))
    [use] = [use for program in system.programs for use in program.executors]
    return use.lasting


@pytest.mark.parametrize(
    "loop",
    [
        "while rclpy.ok():\n    rclpy.spin_once(node)",
        "while True:\n    rclpy.spin_once(node)",
        "while True:\n    for item in range(3):\n        if input():\n            break\n    rclpy.spin_once(node)",
        "while True:\n    if input():\n        continue\n    rclpy.spin_once(node)",
        "try:\n    while rclpy.ok():\n        rclpy.spin_once(node)\nexcept KeyboardInterrupt:\n    pass",
    ],
)
def test_nothing_leaves_the_loop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, loop: str) -> None:
    assert lasting(tmp_path, monkeypatch, loop) is SpinDuration.TO_THE_END


@pytest.mark.parametrize(
    "loop",
    [
        "while not done:\n    rclpy.spin_once(node)",
        "while rclpy.ok() and input():\n    rclpy.spin_once(node)",
        "for _ in range(int(input())):\n    rclpy.spin_once(node)",
        "while True:\n    rclpy.spin_once(node)\n    if input():\n        break",
        "while rclpy.ok():\n    rclpy.spin_once(node)\n    if input():\n        return",
        "while True:\n    with open('x') as x:\n        if x.read():\n            break\n    rclpy.spin_once(node)",
        "while True:\n    rclpy.spin_once(node)\n    for item in range(3):\n        if input():\n            return",
    ],
)
def test_something_else_leaves_the_loop(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, loop: str) -> None:
    assert lasting(tmp_path, monkeypatch, f"done = input()\n{loop}") is SpinDuration.A_WHILE


def test_a_single_call_is_a_moment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert lasting(tmp_path, monkeypatch, "rclpy.spin_once(node)") is SpinDuration.A_MOMENT
