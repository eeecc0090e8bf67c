"""Values that no robot needs and Python has: each is followed or is unknown, and none costs a finding or an hour."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline

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
    "found = [1]; found.insert(large * large, 2); found.insert(-large * large, 0)",
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
