"""XML and YAML that is broken or hostile: a word about it, and little work."""

from __future__ import annotations

import pytest

from archlint.syntax import safe_yaml
from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.launch_yaml import read_launch_yaml
from archlint.syntax.parameter_files import read_parameters

ENTITIES = '<!DOCTYPE launch [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]><launch><node pkg="&b;"/></launch>'
ALIASES = (
    "a: &a [x, x, x, x, x, x, x, x, x]\n"
    + "".join(f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join(['*' + chr(97 + i)] * 9)}]\n" for i in range(9))
    + "n:\n  ros__parameters:\n    p: *j\n"
)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<launch><node></launch>", "mismatched tag"),
        (ENTITIES, "entity declarations are not allowed"),
        ("<launch>" + "<group>" * 300 + "</group>" * 300 + "</launch>", "more elements"),
        ("<launch>\0</launch>", "not well-formed"),
        ("", "no element found"),
    ],
)
def test_broken_xml(text, words):
    (problem,) = read_launch_xml(text).problems
    assert words in problem.message


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("launch:\n- node: {pkg: a\n", 3, "malformed YAML"),
        ("launch:\n- node:\n    pkg: !robot a\n", 3, "the tag !robot has no meaning"),
        ("launch:\n- arg: {name: a, default: !!python/object/apply:os.getcwd []}\n", 2, "the tag !!python/object/"),
        ("launch:\n- node:\n    pkg: !!python/name:os.system\n", 3, "the tag !!python/name:os.system has no meaning"),
    ],
)
def test_broken_yaml(text, line, words):
    (problem,) = read_launch_yaml(text).problems
    assert words in problem.message and problem.line == line


def test_aliases_that_explode(monkeypatch):
    counted = 0
    spend = safe_yaml.YamlReader.spend

    def counting(*given):
        nonlocal counted
        counted += 1
        spend(*given)

    monkeypatch.setattr(safe_yaml.YamlReader, "spend", counting)
    (problem,) = read_parameters(ALIASES).problems
    assert "too many values" in problem.message
    assert counted <= safe_yaml.NODES + 1


def test_a_parameter_file_is_told_of_even_if_it_breaks_before_it_says_what_it_is():
    (problem,) = read_parameters("talker: [\n").problems
    assert "malformed YAML" in problem.message


class Bytes(bytes):
    """Bytes that count how many of them are cut out."""

    taken = 0

    def __getitem__(self, at):
        found = super().__getitem__(at)
        Bytes.taken += len(found) if isinstance(at, slice) else 1
        return found


class Text(str):
    """A text whose bytes count."""

    def encode(self, *given):
        return Bytes(super().encode(*given))


def test_one_line_of_megabytes_is_gone_through_once():
    text = Text("<launch>" + '<node pkg="robot" exec="talker" name="é"/>' * 40_000 + "</launch>")
    Bytes.taken = 0
    (first, *_, last) = read_launch_xml(text).root.children
    assert first.span[1] == 9 and last.span[1] == 9 + 39_999 * 42
    assert Bytes.taken < 2 * len(text.encode())


def test_yaml_of_another_kind_is_nobodys_business():
    assert read_launch_yaml("image: map.pgm\nresolution: 0.05\n").root is None
    assert read_parameters("image: map.pgm\n").sections == ()


def test_rcl_takes_a_tab_for_a_blank_where_it_indents_nothing():
    read = read_parameters(
        "/camera:\n  ros__parameters:\n    ip: 10.0.0.2\t# left\n    gains: [1,\n\t2]\n    rate:\t5 \t\n"
    )
    assert read.problems == ()
    (section,) = read.sections
    assert [(one.name, one.value, one.span) for one in section.entries] == [
        ("ip", "10.0.0.2", (3, 5, 3, 7)),
        ("gains", [1, 2], (4, 5, 4, 10)),
        ("rate", 5, (6, 5, 6, 9)),
    ]


@pytest.mark.parametrize("text", ["\ta: 1\n", "a:\n\tb: 1\n", "a:\n  b: 1\n \tc: 2\n"])
def test_no_tab_indents(text):
    (problem,) = read_parameters(text).problems
    assert problem.message.startswith("malformed YAML: found")


def test_launch_reads_yaml_with_another_scanner_than_rcl():
    (problem,) = read_launch_yaml("launch:\n- log:\n    message: up\t# all\n").problems
    assert problem.line == 3


@pytest.mark.parametrize("text", ["[" * 100_000, "- " * 20_000, "{a: " * 5_000])
def test_what_is_nested_too_deeply_ends_no_process(text):
    (problem,) = read_parameters(text).problems
    assert problem.message == "nested too deeply"
