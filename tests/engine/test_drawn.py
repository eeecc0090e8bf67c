"""A drawing is kept: the same request is answered without following anything, and any other is drawn anew."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.cli import main
from archlint.programs.linker import Linker

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'chatter', 10)


def main():
    rclpy.init()
    rclpy.spin(Talker())


if __name__ == '__main__':
    main()
"""


@pytest.fixture
def draw(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Draws a node with a cache; gives what was printed, and whether any program was linked for it."""
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "node.py").write_text(NODE, "utf-8")
    monkeypatch.chdir(tmp_path / "src")
    linked: list[object] = []
    run_all = Linker.run_all
    monkeypatch.setattr(Linker, "run_all", lambda self, entries: [linked.append(self), run_all(self, entries)][1])

    def run(*options: str) -> tuple[str, bool]:
        linked.clear()
        assert main(["graph", ".", "--isolated", "--cache-dir", str(tmp_path / "cache"), *options]) == 0
        return capsys.readouterr().out, bool(linked)

    return run


def test_the_same_drawing_is_not_made_twice(draw):
    first, linked = draw("--format", "json")
    assert linked
    assert '"/chatter"' in first
    assert draw("--format", "json") == (first, False)


def test_an_edit_is_drawn(draw):
    draw("--format", "json")
    Path("node.py").write_text(NODE.replace("chatter", "news"), "utf-8")
    second, linked = draw("--format", "json")
    assert linked
    assert '"/news"' in second and '"/chatter"' not in second


@pytest.mark.parametrize("other", [["--format", "dot"], ["--format", "json", "--all"], ["--color", "always"]])
def test_another_drawing_of_the_same_nodes_is_another(draw, other):
    first, _ = draw("--format", "json")
    second, linked = draw(*other)
    assert linked
    assert second != first


def test_what_graphviz_draws_is_drawn_each_time(draw, monkeypatch):
    monkeypatch.setattr("archlint.render.drawing.svg", lambda diagram: f"<svg>{len(diagram.shapes)}</svg>\n")
    assert draw("--format", "svg") == draw("--format", "svg") == ("<svg>2</svg>\n", True)
