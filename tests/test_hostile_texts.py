"""Texts that are made to stall their reader: a reader that goes back to where it has been would not end in this life.

How long each takes, and how that grows, is measured by ``python -m benchmarks.speed hostile``.
"""

from __future__ import annotations

import pytest

from archlint.ros.names import HOLE, pattern_matches
from archlint.syntax.descriptions import malformed_description
from archlint.syntax.entry_point_tables import entries_of_setup_cfg, parse_entry
from archlint.syntax.imported_names import imported
from archlint.syntax.interface_values import parse_value
from archlint.syntax.interfaces import parse_interface
from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.line_suppressions import suppressions_of_lines
from archlint.syntax.xacro_expansion import expand
from archlint.syntax.xacro_expressions import argument, may_be_same
from archlint.systems.overrides import key_matches
from archlint.workspace.cmake import parse_cmake
from archlint.workspace.comments import without_comments
from archlint.workspace.merge_marks import merge_in

MANY = 60_000


@pytest.mark.parametrize("line", [b"from a import (\n", b"from " + b"." * MANY + b"\n"], ids=["brackets", "dots"])
def test_imports_that_a_docstring_only_begins(line):
    source = b"from x import (y,\n z)\nimport b\n" + line * (MANY if len(line) < 100 else 1) + b"import c\n"
    found = imported(source)
    assert {b"x", b"x.y", b"x.z", b"b", b"c"} <= set(found)


def test_what_stands_behind_a_list_of_imports_on_its_last_line():
    assert imported(b"from x import (y)\nfrom u import v\n") == [b"x", b"x.y", b"u", b"u.v"]
    assert imported(b"f()\nfrom x import (\n y") == [b"x"]


def test_comments_of_cmake_that_nothing_closes():
    commands = parse_cmake("project(a)\n" + "#[[\n" * MANY + "install([[ a )\nfoo(b)\n")
    assert [command.name for command in commands] == ["project", "install", "foo"]


def test_a_comment_of_xml_that_nothing_closes():
    assert without_comments("a <!-- b -->" + "<!-- " * MANY + "c # d") == "a " + "<!-- " * MANY + "c "


@pytest.mark.parametrize("start", ["<!--", "<?"], ids=["comments", "unknown tags"])
def test_a_description_with_starts_that_nothing_closes(start):
    problem = malformed_description("arm.urdf", "<robot>\n<link/>\n" + start * MANY)
    assert problem is not None
    assert problem.line == 3


def test_a_description_with_unknown_tags_before_those_that_nothing_closes():
    assert malformed_description("arm.sdf", "<sdf><?ignore ?>\n<?><a/></sdf>") is None


def test_marks_of_a_merge_that_nothing_ends():
    assert merge_in("<<<<<<< mine\n" * MANY + "=======\n" * MANY) is None
    assert merge_in("x\n" + "<<<<<<< mine\n" * MANY + "=======\n>>>>>>> theirs\n") == 2


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


def test_suppressions_before_nothing():
    found = suppressions_of_lines("# archlint: ignore[LCH001]\n" * MANY)
    assert len(found) == MANY
    assert found[0].applies_to == (1, 1)
    assert suppressions_of_lines("# archlint: ignore[LCH001]\n#\n\nx: 1\n")[0].applies_to == (4, 4)


def test_suppressions_side_by_side():
    assert len(suppressions_of_lines("x: 1 " + "# archlint: ignore[LCH001] a " * MANY)) == MANY
    text = "<launch><![CDATA[" + "<!-- archlint: ignore[LCH001] " * MANY + "-->]]></launch>"
    [last] = read_launch_xml(text).suppressions
    assert last.column == len("<launch><![CDATA[") + (MANY - 1) * len("<!-- archlint: ignore[LCH001] ") + 1


def test_suppressions_and_elements():
    line = "<arg name='a'/> <!-- archlint: ignore[LCH001] -->\n<!-- archlint: ignore[LCH002] -->\n"
    many = MANY // 10
    found = read_launch_xml("<launch>\n" + line * many + "<let\n name='a'/></launch>").suppressions
    assert [suppression.applies_to for suppression in found[:2]] == [(2, 2), (4, 4)]
    assert found[-1].applies_to == (2 * many + 2, 2 * many + 3)


def test_an_interface_of_many_fields():
    interface = parse_interface("".join(f"int8 a{n}\nint8 A{n}=1\n" for n in range(MANY)) + "int8 a0\n", "msg")
    assert len(interface.section("message").fields) == len(interface.section("message").constants) == MANY
    assert [problem.message for problem in interface.problems] == ["field 'a0' is defined twice"]


def test_texts_of_an_interface_that_are_mostly_spaces():
    assert parse_value("string", "[a" + " " * MANY + "b, 'c,d' , e]", "unbounded", None, None) == [
        "a" + " " * MANY + "b",
        "c,d",
        "e",
    ]


def test_a_table_of_many_entry_points():
    rows = "".join(f"    run{n} = robot.a{n}:main\n" for n in range(MANY // 4))
    entries = entries_of_setup_cfg("[options.entry_points]\nconsole_scripts =\n" + rows)
    assert [(entry.name, entry.line) for entry in entries[:2]] == [("run0", 3), ("run1", 4)]
    assert entries[-1].line == MANY // 4 + 2


def test_a_name_of_holes():
    assert not pattern_matches("/" + f"a{HOLE}" * 40 + "b", "/" + "a" * 200)
    assert pattern_matches("/" + f"a{HOLE}" * 40 + "b", "/" + "a" * 200 + "b")
    assert not pattern_matches(f"/a{HOLE}a", "/a")


def _expanded(*lines: str):
    return expand("arm.xacro", f"<robot>{''.join(lines)}</robot>", lambda path, file: None)


def _property(number: int, value: str) -> str:
    return f'<xacro:property name="p{number}" value="{value}"/>'


def test_properties_that_each_name_the_next_one_twice():
    sums = [_property(number, f"${{p{number + 1} + p{number + 1}}}") for number in range(20)]
    expansion = _expanded(*sums, _property(20, "1"), '<link name="${p0}"/>')
    assert expansion is not None
    assert expansion.children[0].attributes == {"name": str(2**20)}
    texts = [_property(number, f"${{p{number + 1}}}${{p{number + 1}}}") for number in range(60)]
    expansion = _expanded(*texts, _property(60, "a"), '<link name="${p0}"/>')
    assert expansion is not None
    assert expansion.children[0].attributes == {}  # too long to be looked at


def test_blocks_that_each_have_the_one_before_twice():
    block = '<xacro:property name="b{0}"><a>{1}</a><a>{1}</a></xacro:property>'
    insert = '<xacro:insert_block name="b{}"/>'
    blocks = [block.format(number, insert.format(number - 1)) for number in range(1, 60)]
    expansion = _expanded(block.format(0, "<link/>"), *blocks, insert.format(59))
    assert expansion is not None
    assert expansion.open


def test_parameters_of_a_macro_with_a_quote_that_nothing_closes():
    macro = f"""<xacro:macro name="m" params="a:={"x" * 5_000}'"><link name="${{a}}"/></xacro:macro>"""
    expansion = _expanded(macro, "<xacro:m/>")
    assert expansion is not None
    assert expansion.open


def test_names_with_many_arguments():
    assert may_be_same("a".join([argument("side")] * 40), "a" * 2_000 + "b")
    assert not may_be_same(argument("side") + "_wheel", "left_foot")
