"""A workspace of very many programs: the first are followed whole, the rest in part, and that is said."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.programs import budget
from archlint.render.json import unresolved

PROGRAM = """\
import rclpy
from rclpy.node import Node

from library import TOPIC
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('NAME')
        for row in range(40):
            self.get_logger().info(str(row))
        self.create_publisher(String, TOPIC, 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""
LIBRARY = "rows = []\n" + "rows.append('rclpy')\n" * 40 + "TOPIC = 'chatter'\n"

CUT = "the workspace has too much code to follow all of it"


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("a", "b", "c"):
        (tmp_path / f"{name}.py").write_text(PROGRAM.replace("NAME", name), encoding="utf-8")
    (tmp_path / "library.py").write_text(LIBRARY, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def checked(path: Path) -> pipeline.Report:
    return pipeline.check(pipeline.Request([str(path)], Settings(), cached=False))


def test_a_workspace_that_stays_below_the_bound_is_followed_whole(workspace: Path):
    assert not any(CUT in notice for notice in checked(workspace).notices)
    assert unresolved(pipeline.graph(pipeline.Request([str(workspace)], Settings(), cached=False))) == []


def test_programs_behind_the_bound_are_followed_in_part_and_named(workspace: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(budget, "WORKSPACE_STEPS", 50)
    monkeypatch.setattr(budget, "LATE_STEPS", 20)

    report = checked(workspace)
    system = pipeline.graph(pipeline.Request([str(workspace)], Settings(), cached=False))

    assert f"{CUT}, so these 2 files are analysed only in part: b.py, c.py" in report.notices
    assert [(row["file"], row["reason"]) for row in unresolved(system)] == [("b.py", CUT), ("c.py", CUT)]
    assert {node.name: node.blueprint.complete for node in system.nodes} == {"/a": True, "/b": False, "/c": False}


def test_a_late_program_that_is_short_is_whole(workspace: Path, monkeypatch: pytest.MonkeyPatch):
    # library.py has more statements than a late program may run, and is run for all of them.
    monkeypatch.setattr(budget, "WORKSPACE_STEPS", 0)
    monkeypatch.setattr(budget, "LATE_STEPS", 30)
    short = PROGRAM.replace("range(40)", "range(4)")
    for name in ("a", "b", "c"):
        (workspace / f"{name}.py").write_text(short.replace("NAME", name), encoding="utf-8")

    system = pipeline.graph(pipeline.Request([str(workspace)], Settings(), cached=False))

    assert not any(CUT in notice for notice in checked(workspace).notices)
    assert {(node.name, end.name) for node in system.nodes for end in node.endpoints} == {
        ("/a", "/chatter"),
        ("/b", "/chatter"),
        ("/c", "/chatter"),
    }
