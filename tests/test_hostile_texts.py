"""Texts that are made to stall their reader: a reader that goes back to where it has been would not end in this life.

How long each takes, and how that grows, is measured by ``python -m benchmarks.speed hostile``.
"""

from __future__ import annotations

import pytest

from archlint.syntax.entry_point_tables import parse_entry
from archlint.syntax.files import _imported
from archlint.syntax.launch_xml import read_launch_xml
from archlint.systems.overrides import key_matches
from archlint.workspace.cmake import parse_cmake
from archlint.workspace.comments import without_comments

MANY = 60_000


@pytest.mark.parametrize("line", [b"from a import (\n", b"from " + b"." * MANY + b"\n"], ids=["brackets", "dots"])
def test_imports_that_a_docstring_only_begins(line):
    source = b"from x import (y,\n z)\nimport b\n" + line * (MANY if len(line) < 100 else 1) + b"import c\n"
    found = _imported(source)
    assert {b"x", b"x.y", b"x.z", b"b", b"c"} <= set(found)


def test_what_stands_behind_a_list_of_imports_on_its_last_line():
    assert _imported(b"from x import (y)\nfrom u import v\n") == [b"x", b"x.y", b"u", b"u.v"]
    assert _imported(b"f()\nfrom x import (\n y") == [b"x"]


def test_comments_of_cmake_that_nothing_closes():
    commands = parse_cmake("project(a)\n" + "#[[\n" * MANY + "install([[ a )\nfoo(b)\n")
    assert [command.name for command in commands] == ["project", "install", "foo"]


def test_a_comment_of_xml_that_nothing_closes():
    assert without_comments("a <!-- b -->" + "<!-- " * MANY + "c # d") == "a " + "<!-- " * MANY + "c "


def test_suppressions_that_nothing_closes():
    text = "<launch><!-- archlint: ignore[LCH001] x --><![CDATA[" + "<!-- archlint: ignore[ " * MANY + "]]></launch>"
    [suppression] = read_launch_xml(text).suppressions
    assert (suppression.codes, suppression.reason) == (["LCH001"], True)


@pytest.mark.parametrize(
    "text", ["a" + " " * MANY + "b", "a = b" + " " * MANY + "c", "a = " + "b." * MANY + "-", " " * MANY + "="]
)
def test_an_entry_point_of_spaces(text):
    entry = parse_entry(text)
    assert entry is not None
    assert entry.module is None


def test_a_key_of_stars():
    assert not key_matches("/**/a" * 40 + "/b", "/a" * 60)
    assert key_matches("/**/a" * 40 + "/b", "/a" * 60 + "/b")
