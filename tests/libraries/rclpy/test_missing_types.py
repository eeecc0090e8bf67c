"""A type that its package does not define: MSG002 says so, and the graph shows what the code writes."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, graph
from archlint.render.json import document

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Strnig


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(Strnig, 'words', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


def test_the_type_is_shown_as_it_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "node.py").write_text(NODE, encoding="utf-8")

    [node] = document(graph(Request((".",), load(tmp_path), cached=False, jobs=1)))["nodes"]

    assert [(one["name"], one["type"]) for one in node["publishers"]] == [("/words", "std_msgs/msg/Strnig")]
