"""Values that no robot needs and Python has: each is followed or is unknown, and none costs a finding or an hour."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.interpreter.values import ALTERNATIVES, Known, Unknown, join_texts, one_of
from archlint.launch import parameters, substitutions
from archlint.launch.run import LaunchRun

NODE = """\
import functools
import itertools
import os

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from std_msgs.msg import String


class Odd(Node):
    def __init__(self):
        super().__init__('odd')
        huge = (10 ** 60) ** 60 * 10 ** 60
        large = 2 ** 63
        text = 'x' * 16000
        {line}
        self.create_publisher(String, 'after', 10)


def main():
    rclpy.init()
    rclpy.spin(Odd())


if __name__ == '__main__':
    main()
"""
"""``huge`` fits no float and ``large`` no length of a list."""

LINES = [
    "found = range(large)",
    "found = range(-large, large)",
    "found = [] * large",
    "found = () * (large * large)",
    "found = sum([huge, 1.5])",
    "found = sum([10 ** 64, 1.5])",
    "self.create_timer(huge, print)",
    "found = self.wait(Duration(seconds=huge))",
    "found = '{²}'.format(1)",
    "found = '{0[²]}'.format([1])",
    "found = ('{' + '9' * 5000 + '}').format(1)",
    "found = 'a'.center(-large)",
    "found = 'a'.split('a', large * large)",
    "found = 'a'.rsplit('a', -large * large)",
    "found = abs()",
    "found = int()",
    "found = f'{huge}{-huge}'",
    "self.declare_parameter('odd', huge)",
    "found = int('9' * 4000)",
    "found = int('9' * 5000)",
    "found = ('\\t' * 1000).expandtabs(16000)",
    "for _ in range(500): text = os.path.join(text, text)",
    "found = [0]\n        for _ in range(500): found = list(itertools.chain(found, found))",
    "found = print\n        for _ in range(500): found = functools.partial(found, 1)\n        found()",
    "found = os\n        for _ in range(500): found = getattr(found, text)",
    "found = '{0}{0}{0}{0}{0}{0}{0}{0}{0}{0}'.format(text)",
    "found = text.join([text] * 4000)",
]


@pytest.mark.parametrize("line", LINES)
def test_an_odd_value_is_no_fault_and_what_follows_is_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str
):
    monkeypatch.chdir(tmp_path)
    Path("node.py").write_text(NODE.replace("{line}", line))
    request = pipeline.Request((".",), Settings(), cached=False, jobs=1)

    assert [one.code for one in pipeline.check(request).findings if one.code == "LNT003"] == []
    assert list(pipeline.graph(request).topics) == ["/after"]


def test_arguments_that_double_with_each_call_stay_few(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    calls = "".join(f"    def f{n}(self, *a):\n        self.f{n + 1}(*a, *a)\n\n" for n in range(30))
    doubles = f"\n\nclass Doubles(Odd):\n{calls}    def f30(self, *a):\n        pass\n"
    source = NODE.replace("{line}", "self.f0(1)") + doubles
    monkeypatch.chdir(tmp_path)
    Path("node.py").write_text(source.replace("rclpy.spin(Odd())", "rclpy.spin(Doubles())"))

    assert list(pipeline.graph(pipeline.Request((".",), Settings(), cached=False, jobs=1)).topics) == ["/after"]


class Counted(Known):
    """A constant that counts how often it is compared."""

    compared = 0

    def __eq__(self, other: object) -> bool:
        Counted.compared += 1
        return super().__eq__(other)

    __hash__ = Known.__hash__


def test_choosing_among_thousands_compares_as_many_as_are_kept():
    Counted.compared = 0
    assert isinstance(one_of([Counted(number) for number in range(4_000)]), Unknown)
    assert Counted.compared <= (ALTERNATIVES + 2) ** 2


def test_of_what_is_not_known_the_first_reason_stays():
    unknowns = [Unknown(f"reason {number}") for number in range(50)]
    found = one_of([Known(1), *unknowns, Known(2), Known(1)])
    assert found == one_of([Known(1), unknowns[0], Known(2)])


def test_a_text_too_long_is_never_put_together():
    assert join_texts([Known("a" * 9_000)] * 2_000) == Unknown("a text too long to follow")
    assert join_texts([Known("a"), Known(""), Known("b")]) == Known("ab")
    unknown = Unknown("data")
    assert join_texts([Known(""), unknown, Known(""), unknown]) == unknown


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
    assert system.world is not None
    assert system.world.faults.found() == []
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
    perform, entries = substitutions._perform, parameters._entries

    def count_text(*given):
        counts["texts"] += 1
        return perform(*given)

    def count_dict(*given):
        counts["dicts"] += 1
        return entries(*given)

    monkeypatch.setattr(substitutions, "_perform", count_text)
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
