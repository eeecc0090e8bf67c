"""What main may meet after a spin that ends: callbacks ran meanwhile, or none did."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph

ASKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Asker(Node):
    def __init__(self):
        super().__init__('asker')
        self.answer = None
        self.language = 'en'
        self.subscription = self.create_subscription(String, 'answer', self.on_answer, 10)

    def on_answer(self, msg):
        self.answer = msg.data


def main():
    rclpy.init()
    node = Asker()
BODY


main()
"""


def published(folder: Path, monkeypatch: pytest.MonkeyPatch, *body: str) -> list[str | None]:
    """The topics that a main with such a body publishes."""
    monkeypatch.chdir(folder)
    (folder / "asker.py").write_text(ASKER.replace("BODY", indent("\n".join(body), "    ")), encoding="utf-8")
    system = graph(Request((".",), Settings(), cached=False, jobs=1))
    return [end.name for end in system.endpoints if end.kind == "publisher"]


ONCE = "rclpy.spin_once(node, timeout_sec=1.0)"
FUTURE = "rclpy.spin_until_future_complete(node, Future())"
UNTIL = "while node.answer is None:\n    rclpy.spin_once(node)"


@pytest.mark.parametrize("spin", [ONCE, UNTIL, f"from rclpy.task import Future\n{FUTURE}"])
@pytest.mark.parametrize("test", ["node.answer", "node.answer is None", "node.answer == 'yes'"])
def test_a_callback_may_have_answered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, spin: str, test: str):
    after = f"node.create_publisher(String, 'yes' if {test} else 'no', 10)"
    assert published(tmp_path, monkeypatch, spin, after) == ["/no", "/yes"]


def test_no_callback_has_run_before_the_spin(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    before = "node.create_publisher(String, 'yes' if node.answer else 'no', 10)"
    assert published(tmp_path, monkeypatch, before, ONCE) == ["/no"]


@pytest.mark.parametrize("spin", [ONCE, UNTIL])
def test_what_no_method_changes_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, spin: str):
    after = "node.create_publisher(String, node.language, 10)"
    assert published(tmp_path, monkeypatch, spin, after) == ["/en"]
