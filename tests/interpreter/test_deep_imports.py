"""How many imports inside each other are followed: no more than Python and g++ do, so that the work stays linear."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check
from archlint.interpreter.limits import IMPORTS

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from m0 import TOPIC

rclpy.init()
Node('talker').create_publisher(String, TOPIC, 10)
"""


def codes(folder: Path) -> set[str]:
    return {finding.code for finding in check(Request((str(folder),), Settings(), cached=False, jobs=1)).findings}


def chain(folder: Path, length: int, line: str, last: str) -> None:
    """So many modules, each of which imports the next one; the last one says something."""
    folder.joinpath("node.py").write_text(NODE)
    for number in range(length):
        folder.joinpath(f"m{number}.py").write_text(f"import rclpy\n{line.format(number + 1)}\n")
    folder.joinpath(f"m{length}.py").write_text(last)


@pytest.mark.parametrize("line", ["from m{} import TOPIC", "from m{} import *"])
def test_a_name_comes_as_far_as_python_brings_it(tmp_path: Path, line: str):
    chain(tmp_path, IMPORTS - 20, line, "TOPIC = 'bad-name'\n")
    assert codes(tmp_path) == {"NME002"}


@pytest.mark.parametrize("line", ["from m{} import TOPIC", "from m{} import *", "import m{0} as m\nm.TOPIC = m.TOPIC"])
def test_beyond_that_it_is_unknown(tmp_path: Path, line: str):
    chain(tmp_path, IMPORTS + 20, line, "TOPIC = 'bad-name'\n")
    assert codes(tmp_path) == set()
