"""Launch files whose lists hold themselves or grow without end: each run ends."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.launch import parameters
from archlint.launch.run import LaunchRun
from archlint.launch.substitutions import performing

LAUNCH = """\
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node


def work(context):
    for _ in range(400):
        for _ in range(400):
            x = 1
    return []


def generate_launch_description():
    odd = ['a']
    table = {'a': 1}
    {line}
    return LaunchDescription([
        Node(package='p', executable='n', name=odd, parameters=[table]),
        Node(package='p', executable='n', name='after'),
        *(OpaqueFunction(function=work) for _ in range({functions})),
    ])
"""


def launched(line: str, functions: int = 0) -> list[str | None]:
    """The names of the nodes that a launch file starts; no part of it may fail."""
    Path("launch").mkdir()
    Path("package.xml").write_text("<package format='3'><name>p</name><version>0.0.0</version></package>")
    source = LAUNCH.replace("{line}", line).replace("{functions}", str(functions))
    Path("launch/odd.launch.py").write_text(source)
    request = pipeline.Request((".",), Settings(), cached=False, jobs=1, launch="launch/odd.launch.py")
    system = pipeline.graph(request)
    assert system.workspace is not None
    assert system.workspace.faults.by_place() == []
    return [node.name for node in system.nodes]


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("odd.append(odd)", None),
        ("for _ in range(500): odd = [odd]", None),
        ("for _ in range(50): odd = [odd]", "/a"),
        ("for _ in range(40): odd = [odd, odd]", None),
        ("for _ in range(40): odd = PathJoinSubstitution([odd, odd])", None),
        ("table['b'] = table", "/a"),
        ("table['b'] = [table]", "/a"),
        ("for _ in range(40): table = {'a': table, 'b': table}", "/a"),
        ("rows = [1]\n    rows.append(rows)\n    table['b'] = rows", "/a"),
    ],
)
def test_lists_in_themselves_and_trees_of_lists_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, name: str | None
):
    counts = {"texts": 0, "dicts": 0}
    perform, entries = performing._perform, parameters._entries

    def count_text(*given):
        counts["texts"] += 1
        return perform(*given)

    def count_dict(*given):
        counts["dicts"] += 1
        return entries(*given)

    monkeypatch.setattr(performing, "_perform", count_text)
    monkeypatch.setattr(parameters, "_entries", count_dict)
    monkeypatch.chdir(tmp_path)

    assert sorted(launched(line), key=str) == sorted(["/after", name], key=str)
    assert counts["texts"] < 50_000
    assert counts["dicts"] < 50_000


def test_the_functions_of_a_launch_file_share_their_statements(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("archlint.launch.run.LAUNCH_STEPS", 4_000)
    executed = 0
    original = LaunchRun.execute

    def counted(run, block):
        nonlocal executed
        executed += 1
        return original(run, block)

    monkeypatch.setattr(LaunchRun, "execute", counted)

    assert sorted(map(str, launched("pass", functions=20))) == ["/a", "/after"]
    assert executed < 3 * (4_000 + 20 * 400)
