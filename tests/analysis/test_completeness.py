"""Nodes of which a rule says that they lack something: only where no class from elsewhere may give it to them."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

ROBOT = """\
import abc
import elsewhere
import rclpy
from elsewhere.node import LifecycleNode
from rclpy.node import Node
from rclpy.node import Node as RosNode
from robot.base import Foreign, Plain
from robot.generated import Generated
from typing import Generic, TypeVar

Data = TypeVar('Data')
Either = elsewhere.Node if elsewhere.simulated else Node

class Robot({bases}):
    def __init__(self):
        super().__init__('robot')
        self.rate = self.get_parameter('rate').value

def main():
    rclpy.init()
    rclpy.spin(Robot())

main()
"""
BASE = """\
from elsewhere import Mixin
from rclpy.node import Node

class Foreign(Node, Mixin): pass
class Plain(Node): pass
"""


@pytest.mark.parametrize(
    ("bases", "reported"),
    [
        ("Node", True),
        ("RosNode", True),
        ("Node, Generic[Data]", True),
        ("Node, metaclass=abc.ABCMeta", True),
        ("Plain", True),
        ("Foreign", False),  # its base from elsewhere may declare the parameter
        ("Node, Generated", False),  # a module that the build makes
        ("LifecycleNode", False),  # another package's, whatever its name
        ("Either", False),
        ("Node, metaclass=elsewhere.Meta", False),
    ],
)
def test_a_parameter_that_nothing_declares(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, bases: str, reported: bool):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot").mkdir()
    for name, text in {"__init__.py": "", "base.py": BASE, "node.py": ROBOT.format(bases=bases)}.items():
        (tmp_path / "robot" / name).write_text(dedent(text), encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["PRM003"]\n', encoding="utf-8")
    findings = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [finding.code for finding in findings] == ["PRM003"] * reported
