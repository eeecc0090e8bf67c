"""A copy of an object holds what the object held, and is changed for itself."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, graph

NODE = """\
import copy
import rclpy
from std_msgs.msg import String


class Names:
    first = None

    def __init__(self):
        self.inside = ['a']


rclpy.init()
node = rclpy.create_node('x')
names = Names()
{statements}
node.create_publisher(String, {topic}, 10)
rclpy.spin(node)
"""


@pytest.mark.parametrize(
    ("statements", "topic", "name"),
    [
        ("names.first = 'left'; copied = copy.deepcopy(names)", "copied.first", "/left"),
        ("names.first = 'left'; copied = copy.copy(names)", "copied.first", "/left"),
        ("copied = copy.copy(names); copied.first = 'right'; again = copy.copy(copied)", "again.first", "/right"),
        ("names.first = 'left'; copied = copy.copy(names); copied.first = 'right'", "names.first", "/left"),
        ("copied = copy.deepcopy(names); copied.inside.append('b')", "names.inside[-1]", "/a"),
        ("copied = copy.copy(names); copied.inside.append('b')", "names.inside[-1]", "/b"),
        ("names.itself = names; copied = copy.deepcopy(names); names.first = 'b'; copied.first = 'c'",
         "copied.itself.first", "/c"),
    ],
)  # fmt: skip
def test_the_name_that_a_copy_holds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, statements, topic, name):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "node.py").write_text(NODE.format(statements=statements, topic=topic))
    system = graph(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert [end.name for end in system.endpoints] == [name]
