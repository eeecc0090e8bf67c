"""Planting known defects: where, what changes, and what counts as found."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.mutations import code, endpoints, launch, package  # noqa: F401
from benchmarks.mutations.defect import PLANTERS, Defect, Sites
from benchmarks.mutations.plant import Bench, Outcome, edited
from benchmarks.mutations.python_source import misspelt
from benchmarks.mutations.trees import closure, copied, packages

MANIFEST = """\
<package format="3">
  <name>robot</name><version>1.0.0</version><description>it</description>
  <maintainer email="a@b.org">a</maintainer><license>MIT</license>
  <depend>rclpy</depend>
  <depend>std_msgs</depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""
NODES = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter(
            'rate',
            1.0,
        )
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(self.get_parameter('rate').value, self.talk)

    def talk(self):
        self.publisher.publish(String(data='hello'))


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.on_text, 10)

    def on_text(self, message):
        self.get_logger().info(message.data)


def main():
    rclpy.init()
    executor = rclpy.executors.SingleThreadedExecutor()
    executor.add_node(Talker())
    executor.add_node(Listener())
    executor.spin()
"""
SETUP = """\
from setuptools import setup

setup(
    name='robot',
    version='1.0.0',
    packages=['robot'],
    entry_points={'console_scripts': ['robot = robot.nodes:main']},
)
"""


@pytest.fixture
def sites(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Sites:
    monkeypatch.chdir(tmp_path)
    files = {"package.xml": MANIFEST, "setup.py": SETUP, "robot/__init__.py": "", "robot/nodes.py": NODES}
    for name, text in files.items():
        path = tmp_path / "robot" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    every = packages(tmp_path)
    return Sites(every["robot"], every)


def planted(sites: Sites, what: str) -> list[tuple[Defect, Outcome]]:
    folder = sites.home.root / "copy"
    copied(closure(sites.home, sites.beside), folder)
    bench = Bench(folder, sites.home.root / "cache")
    return [(defect, bench.plant(defect)) for defect in PLANTERS[what](sites)]


@pytest.mark.parametrize(
    ("word", "wrong"),
    [("chatter", "chaqter"), ("scan_front", "scan_frqnt"), ("CamelCase", "CameqCase"), ("q", "x"), ("12", None)],
)
def test_one_letter_of_the_longest_part_changes(word: str, wrong: str | None):
    assert misspelt(word) == wrong


@pytest.mark.parametrize(
    ("what", "rule"),
    [
        ("one letter of a subscription's topic changed", "TOP004"),
        ("another message type at one end", "TOP001"),
        ("best effort offered to a reliable subscription", "QOS001"),
        ("a declaration dropped", "PRM003"),
        ("a callback that does not exist", "EXE006"),
        ("an entry point misspelt", "PKG002"),
        ("a dependency dropped", "PKG001"),
    ],
)
def test_what_is_planted_is_found_at_its_place(sites: Sites, what: str, rule: str):
    outcomes = planted(sites, what)
    assert outcomes
    for defect, outcome in outcomes:
        assert outcome.found is not None and outcome.found.code == rule, defect
        assert outcome.others == []


def test_a_defect_that_no_rule_tells_is_missed(sites: Sites):
    [(defect, _)] = planted(sites, "a declaration dropped")
    elsewhere = Defect(defect.edits, ("TMO001",), defect.places)
    outcome = Bench(sites.home.root / "copy", sites.home.root / "cache").plant(elsewhere)
    assert outcome.found is None
    assert [one.code for one in outcome.others] == ["PRM003"]


def test_no_line_moves(sites: Sites):
    [defect] = PLANTERS["a declaration dropped"](sites)
    before = sites.home.text("robot/robot/nodes.py")
    after = edited(before, list(defect.edits))
    assert after.count(b"\n") == before.count(b"\n")
    compile(after, "nodes.py", "exec")


def test_the_workspace_is_as_it_was_afterwards(sites: Sites):
    planted(sites, "another message type at one end")
    copy = sites.home.root / "copy" / "robot" / "robot" / "nodes.py"
    assert copy.read_text(encoding="utf-8") == NODES
