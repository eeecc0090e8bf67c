"""How long archlint looks at source that is made to stall whoever reads it."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.syntax.entry_point_tables import entries_of_setup_cfg
from archlint.syntax.interfaces import parse_interface
from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.line_suppressions import suppressions_of_lines
from archlint.syntax.python.gate import inspect
from archlint.workspace.cmake import parse_cmake

TEXTS: Mapping[str, Callable[[int], str]] = {
    "brackets": lambda many: "x = " + "(" * many,
    "a sum": lambda many: "x = " + "1+" * many + "1",
    "a sum over lines": lambda many: "x = (\n" + "1 +\n" * many + "1)",
    "a sum below an error": lambda many: "def f(:\n    pass\nx = " + "1+" * many + "1",
    "attributes": lambda many: "x" + ".b" * many,
    "calls": lambda many: "x" + "()" * many,
    "`not`": lambda many: "x = " + "not " * many + "x",
    "signs": lambda many: "x = " + "-" * many + "1",
    "powers": lambda many: "x = " + "2**" * many + "2",
    "`lambda`": lambda many: "x = " + "lambda: " * many + "1",
    "conditions": lambda many: "x = " + "1 if 1 else " * many + "1",
    "`elif`": lambda many: "if x: pass\n" + "elif x: pass\n" * many,
    "texts side by side": lambda many: "x = (" + "'a'\n" * many + ")",
    "quotes": lambda many: "'" * many,
    "long quotes": lambda many: "'''" * many,
    "quotes and backslashes": lambda many: "'\\\n" * many,
    "escaped quotes": lambda many: "x = '" + "\\'" * many,
    "numbers": lambda many: "x = [" + "1.0, " * many + "]",
}


LINE = "# archlint: ignore[LCH001]\n"
READERS: Mapping[str, tuple[Callable[[str], object], Callable[[int], str]]] = {
    "YAML: suppressions before nothing": (suppressions_of_lines, lambda many: LINE * many),
    "YAML: suppressions on one line": (suppressions_of_lines, lambda many: "x: 1" + " # archlint: ignore[A] a" * many),
    "XML: suppressions in data": (
        read_launch_xml,
        lambda many: "<launch><![CDATA[" + "<!-- archlint: ignore[A] " * many + "-->]]></launch>",
    ),
    "XML: suppressions and elements": (
        read_launch_xml,
        lambda many: "<launch>" + "<arg name='a'/>\n<!-- archlint: ignore[A] -->\n" * (many // 20) + "</launch>",
    ),
    "msg: fields": (
        lambda text: parse_interface(text, "msg"),
        lambda many: "".join(f"int8 a{n}\n" for n in range(many)),
    ),
    "msg: spaces in a text": (
        lambda text: parse_interface(text, "msg"),
        lambda many: "string[] a [b" + " " * many + "c]\n",
    ),
    "setup.cfg: entry points": (
        entries_of_setup_cfg,
        lambda many: (
            "[options.entry_points]\nconsole_scripts =\n" + "".join(f"    a{n} = b.c{n}:d\n" for n in range(many // 4))
        ),
    ),
    "CMake: comments that nothing closes": (parse_cmake, lambda many: "project(a)\n" + "#[[\n" * many),
}


def _judge(text: str) -> None:
    """Check a node by itself, as a system that is closed."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        folder.joinpath("node.py").write_text(text, encoding="utf-8")
        folder.joinpath("archlint.toml").write_text("closed-world = true\n", encoding="utf-8")
        check(Request((temporary,), load(folder), cached=False, jobs=1))


def _nodes(many: int, line: str) -> str:
    """So many nodes, of two kinds in turn."""
    head = "import rclpy\nfrom rclpy.qos import *\nfrom std_msgs.msg import String\nrclpy.init()\n"
    return head + "".join(f"a = rclpy.create_node('n{n}')\n{line.format(n=n)}\n" for n in range(many))


_OFFER = "a.create_publisher(String, 'x', qos_profile_sensor_data)"
_SYSTEMS: Mapping[str, Callable[[int], str]] = {
    "system: names with one side only": lambda many: _nodes(
        many, "a.create_publisher(String, 'said_{n}', 1); a.create_subscription(String, 'heard_{n}', print, 1)"
    ),
    "system: ends of one topic that do not fit": lambda many: _nodes(
        many, _OFFER + "; a.create_subscription(String, 'x', print, 10)"
    ),
}
"""Systems whose ends are all to be held against each other."""


def stalling(many: int) -> Iterator[tuple[str, float, float]]:
    """Of each text with so many parts, and of systems with a node for 500: what it is, seconds of CPU until it is
    accepted or refused, and how much of that one with half of the parts takes."""
    of_python = {name: (inspect, text) for name, text in TEXTS.items()}
    of_systems = {name: (_judge, lambda parts, text=text: text(parts // 500)) for name, text in _SYSTEMS.items()}
    for name, (read, text) in {**of_python, **READERS, **of_systems}.items():
        half, whole = _seconds(read, text(many // 2)), _seconds(read, text(many))
        yield name, whole, half / whole


def _seconds(read: Callable[[str], object], text: str) -> float:
    started = time.process_time()
    read(text)
    return time.process_time() - started
