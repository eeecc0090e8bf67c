"""XML and YAML that is broken or hostile: a word about it, and little work."""

from __future__ import annotations

import time

import pytest

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
        ("launch:\n- node:\n    pkg: !robot a\n", 3, "the tag !robot means nothing"),
        ("launch:\n- arg: {name: a, default: !!python/object/apply:os.getcwd []}\n", 2, "the tag !!python/object/"),
        ("launch:\n- node:\n    pkg: !!python/name:os.system\n", 3, "the tag !!python/name:os.system means"),
    ],
)
def test_broken_yaml(text, line, words):
    (problem,) = read_launch_yaml(text).problems
    assert words in problem.message and problem.line == line


def test_aliases_that_explode():
    started = time.perf_counter()
    (problem,) = read_parameters(ALIASES).problems
    assert "more values" in problem.message
    assert time.perf_counter() - started < 5


def test_a_parameter_file_is_told_of_even_if_it_breaks_before_it_says_what_it_is():
    (problem,) = read_parameters("talker: [\n").problems
    assert "malformed YAML" in problem.message


def test_one_line_of_megabytes_is_read_at_once():
    text = "<launch>" + '<node pkg="robot" exec="talker" name="é"/>' * 40_000 + "</launch>"
    started = time.perf_counter()
    (first, *_, last) = read_launch_xml(text).root.children
    assert first.span[1] == 9 and last.span[1] == 9 + 39_999 * 42
    assert time.perf_counter() - started < 8


def test_yaml_of_another_kind_is_nobodys_business():
    assert read_launch_yaml("image: map.pgm\nresolution: 0.05\n").root is None
    assert read_parameters("image: map.pgm\n").sections == ()
