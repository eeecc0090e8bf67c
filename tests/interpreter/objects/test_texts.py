"""What a text comes to that code puts together from values which are not all known."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, graph

NODE = """\
import sys
import rclpy
from std_msgs.msg import String

name = 'policy' if len(sys.argv) > 1 else {other}
node = rclpy.create_node('x')
node.create_publisher(String, {topic}, 10)
rclpy.spin(node)
"""


@pytest.mark.parametrize(
    ("topic", "other", "names"),
    [
        ("f'/{name}/health'", "None", [("/*/health", "partial"), ("/policy/health", "exact")]),
        ("'/{}/health'.format(name)", "None", [("/*/health", "partial"), ("/policy/health", "exact")]),
        ("'/a/' + (name or 'plain')", "None", [("/a/plain", "exact"), ("/a/policy", "exact")]),
        ("f'/{name}/health'", "'None'", [("/None/health", "exact"), ("/policy/health", "exact")]),
        (
            'f\'/{node.declare_parameter("n", "policy").value or None}/health\'',
            "'a'",
            [("/*/health", "partial"), ("/policy/health", "parameter")],
        ),
        ("f'/{None}/health'", "'a'", [("/None/health", "exact")]),
    ],
)
def test_nobody_means_a_name_with_none_in_it(tmp_path: Path, monkeypatch, topic, other, names):
    """``None`` that is one of several values stands there until the value comes."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "node.py").write_text(NODE.replace("{topic}", topic).replace("{other}", other))
    system = graph(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert sorted((end.name or "", end.resolution) for end in system.endpoints) == names
