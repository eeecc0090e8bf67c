"""How long archlint looks at source that is made to stall whoever reads it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping

from archlint.syntax.entry_point_tables import entries_of_setup_cfg
from archlint.syntax.interfaces import parse_interface
from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.launch_yaml import suppressions_of_lines
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


def stalling(many: int) -> Iterator[tuple[str, float, float]]:
    """Of each text with so many parts: what it is, seconds of CPU until it is accepted or refused, and how much of that
    one with half of the parts takes."""
    of_python = {name: (inspect, text) for name, text in TEXTS.items()}
    for name, (read, text) in {**of_python, **READERS}.items():
        half, whole = _seconds(read, text(many // 2)), _seconds(read, text(many))
        yield name, whole, half / whole


def _seconds(read: Callable[[str], object], text: str) -> float:
    started = time.process_time()
    read(text)
    return time.process_time() - started
