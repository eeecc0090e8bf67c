"""Where in a text a name stands."""

from __future__ import annotations

import pytest

from archlint.lookup.texts import Texts
from archlint.place import Place


def found_in(file: str, line: str, at: str, written: str) -> str | None:
    """The line with the name in brackets; ``at`` is what the place covers."""
    start = line.index(at) + 1
    place = Texts({file: line}.get).name_at(Place(file, 1, start, 1, start + len(at)), written)
    return None if place is None else f"{line[: place.column - 1]}[{written}]{line[place.end_column - 1 :]}"


@pytest.mark.parametrize(
    ("file", "line", "at", "shown"),
    [
        ("it.py", "f('scan')", "'scan'", "f('[scan]')"),
        ("it.py", 'f(r"""scan""")', 'r"""scan"""', 'f(r"""[scan]""")'),
        ("it.py", "f('scan')", "scan", "f('[scan]')"),
        ("it.py", "f(f'scan')", "f'scan'", None),
        ("it.py", "f('sc' 'an')", "'sc' 'an'", None),
        ("it.py", "f(scan)", "scan", None),
        ("it.launch.xml", '<remap from="scan" to="scan2"/>', 'from="scan"', '<remap from="[scan]" to="scan2"/>'),
        ("it.launch.xml", "<remap from='/scan'/>", "from='/scan'", None),
        ("it.launch.yaml", "- from: scan  # it", "from: scan", "- from: [scan]  # it"),
        ("it.launch.yaml", '- name: "scan"', "name", '- name: "[scan]"'),
        ("params.yaml", "scan: 1", "scan", "[scan]: 1"),
    ],
)
def test_a_name_without_its_quotes(file: str, line: str, at: str, shown: str | None):
    assert found_in(file, line, at, "scan") == shown


@pytest.mark.parametrize(
    ("line", "column", "expected"),
    [("node.create_timer(1.0, f)", 8, True), ("node.create_timer(1.0, f)", 20, False)],
)
def test_the_name_of_what_is_called(line: str, column: int, expected: bool):
    assert Texts({"it.py": line}.get).is_callee(Place("it.py", 1, 1, 1, len(line) + 1), 1, column) is expected
