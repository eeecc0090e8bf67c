"""The type of a create call: a class, or a text where the row says so; what is neither is in the graph's gaps."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, graph
from archlint.libraries import tables
from archlint.render.json import document

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        CREATE

    def on_text(self, message):
        pass


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
BY_TEXT = "rclpy.node.Node.create_subscription_by_text"
"""A method that subscribes like ``create_subscription`` and takes its type as a text; rclpy has none."""


@pytest.fixture
def with_row_of_texts(monkeypatch: pytest.MonkeyPatch) -> None:
    row = replace(tables.TABLE["rclpy.node.Node.create_subscription"], path=BY_TEXT, type_as_text=True)
    monkeypatch.setitem(tables.TABLE, BY_TEXT, row)


def graph_of(path: Path, monkeypatch: pytest.MonkeyPatch, create: str) -> dict[str, Any]:
    monkeypatch.chdir(path)
    (path / "node.py").write_text(NODE.replace("CREATE", create), encoding="utf-8")
    return document(graph(Request((".",), load(path), cached=False, jobs=1)))


def subscribers(shown: dict[str, Any]) -> list[tuple[str, str | None]]:
    [node] = shown["nodes"]
    return [(end["name"], end["type"]) for end in node["subscribers"]]


def gaps(shown: dict[str, Any]) -> list[tuple[str, int, str]]:
    return [(entry["kind"], entry["line"], entry["reason"]) for entry in shown["unresolved"]]


@pytest.mark.usefixtures("with_row_of_texts")
@pytest.mark.parametrize(
    ("type_", "known"),
    [
        ("'std_msgs/msg/String'", "std_msgs/msg/String"),
        ("f'std_msgs/msg/{rclpy.kind()}'", None),
        ("rclpy.kind()", None),
    ],
)
def test_a_row_may_take_the_type_as_a_text(tmp_path, monkeypatch, type_, known):
    create = f"self.create_subscription_by_text({type_}, 'said', self.on_text, 10)"

    shown = graph_of(tmp_path, monkeypatch, create)

    assert subscribers(shown) == [("/said", known)]
    assert gaps(shown) == []


@pytest.mark.usefixtures("with_row_of_texts")
def test_a_text_that_names_no_interface_is_a_gap(tmp_path, monkeypatch):
    create = "self.create_subscription_by_text('std_msgs.String', 'said', self.on_text, 10)"

    shown = graph_of(tmp_path, monkeypatch, create)

    assert subscribers(shown) == []
    assert gaps(shown) == [("call", 9, "'std_msgs.String' is not the name of an interface")]


def test_a_text_where_a_class_belongs_is_a_gap(tmp_path, monkeypatch):
    create = "self.create_subscription('std_msgs/msg/String', 'said', self.on_text, 10)"

    shown = graph_of(tmp_path, monkeypatch, create)

    assert subscribers(shown) == []
    assert gaps(shown) == [("call", 9, "'std_msgs/msg/String' is not an interface class")]


def test_a_create_call_of_another_library_is_no_gap(tmp_path, monkeypatch):
    shown = graph_of(tmp_path, monkeypatch, "rclpy.session().create_client('s3', 'bucket')")

    assert gaps(shown) == []
