"""Launch files that are broken or hostile: a word about it, in bounded time, and nothing is executed."""

from __future__ import annotations

import time

import pytest

from archlint.syntax.launch_xml import read_launch_xml
from archlint.syntax.launch_yaml import read_launch_yaml
from archlint.syntax.parameter_files import read_parameters
from programs.launching import PYTHON, names

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


@pytest.mark.parametrize(
    ("path", "data", "words"),
    [
        ("launch/a.launch.py", b"def generate_launch_description(:\n", "syntax error"),
        ("launch/a.launch.xml", b'<launch><arg name="caf\xe9"/></launch>', "byte 0xe9 is no utf-8"),
        ("launch/a.launch.yaml", b"launch:\n- arg: {name: caf\xe9}\n", "byte 0xe9 is no utf-8"),
        ("launch/a.launch.xml", b" " * 8_000_001, "too large"),
        ("setup.py", b"from setuptools import setup\nsetup(\n", "syntax error"),
    ],
)
def test_a_file_that_cannot_be_read_is_told_of(launches, path, data, words):
    (launches.root / "robot/launch").mkdir(exist_ok=True)
    (launches.root / "robot" / path).write_bytes(data)
    loader = launches.loader()
    loader.relevant = lambda file: False
    (problem,) = loader.problems()
    assert problem[0] == f"robot/{path}" and words in problem[3]


def test_xml_says_itself_how_it_is_encoded(launches):
    text = (
        '<?xml version="1.0" encoding="ISO-8859-1"?><launch><node pkg="robot" exec="talker" name="n"/><!--é--></launch>'
    )
    (launches.root / "robot/launch").mkdir(exist_ok=True)
    (launches.root / "robot/launch/it.launch.xml").write_bytes(text.encode("latin-1"))
    assert names(launches.run("robot/launch/it.launch.xml")) == ["n"]


def test_one_line_of_megabytes_is_read_at_once():
    text = "<launch>" + '<node pkg="robot" exec="talker" name="é"/>' * 40_000 + "</launch>"
    started = time.perf_counter()
    (first, *_, last) = read_launch_xml(text).root.children
    assert first.span[1] == 9 and last.span[1] == 9 + 39_999 * 42
    assert time.perf_counter() - started < 8


def test_substitutions_nested_too_deeply_are_unknown(launches):
    launched = launches.xml('<node pkg="robot" exec="talker" name="' + "$(var " * 3000 + ")" * 3000 + '"/>')
    assert [use.name for use in launched.undeclared] == []
    assert names(launched) == ["?"]


@pytest.mark.parametrize("body", ["    1 / 0\n", "    raise RuntimeError('no')\n", "    LaunchDescription([])\n"])
def test_a_launch_file_that_gives_no_description_says_so(launches, body):
    launches.file("robot/launch/it.launch.py", f"{PYTHON}\ndef generate_launch_description():\n{body}")
    gaps = launches.run("robot/launch/it.launch.py").gaps
    assert any("returns no launch description" in gap.reason for gap in gaps)


def test_yaml_of_another_kind_is_nobodys_business():
    assert read_launch_yaml("image: map.pgm\nresolution: 0.05\n").root is None
    assert read_parameters("image: map.pgm\n").sections == ()


def test_ros1_files_are_recognised(launches):
    launched = launches.xml('<node pkg="robot" type="talker.py" name="talker"/><rosparam file="$(find robot)/x.yaml"/>')
    assert launched.ros1
    assert launched.started == []


@pytest.mark.parametrize(
    "body",
    [
        "    raise RuntimeError('no')\n",
        "    return None\n",
        "    return LaunchDescription(unknown())\n",
        "    return generate_launch_description()\n",
        "    while True:\n        pass\n",
        "    return LaunchDescription([OpaqueFunction(function=lambda context: [OpaqueFunction(function=print)])])\n",
    ],
)
def test_python_that_leads_nowhere(launches, body):
    launches.file(
        "robot/launch/it.launch.py",
        "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\n"
        f"def generate_launch_description():\n{body}",
    )
    assert launches.run("robot/launch/it.launch.py").started == []


def test_an_include_of_itself_through_a_function_ends(launches):
    launches.file(
        "robot/launch/it.launch.py",
        "from launch import LaunchDescription\nfrom launch.actions import OpaqueFunction\n"
        "def again(context):\n    return [OpaqueFunction(function=again)]\n"
        "def generate_launch_description():\n    return LaunchDescription([OpaqueFunction(function=again)])\n",
    )
    assert launches.run("robot/launch/it.launch.py").started == []


NODE_OF_PYTHON = (
    "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    "def generate_launch_description():\n    return LaunchDescription([Node(package='robot', executable='talker')])\n"
)


@pytest.mark.parametrize(
    ("text", "nodes"),
    [
        (f"#! /usr/bin/env python3\n{NODE_OF_PYTHON}", 1),
        (NODE_OF_PYTHON, 0),
        ("# ours\nlaunch:\n- node: {pkg: robot, exec: talker}\n", 1),
        ("\n<launch><node pkg='robot' exec='talker'/></launch>\n", 1),
    ],
)
def test_a_suffix_that_says_nothing(launches, text, nodes):
    launches.file("robot/launch/it.launch", text)
    loader = launches.loader()
    assert loader.launch_files() == (["robot/launch/it.launch"] if nodes else [])
    assert loader.problems() == []
    assert len(launches.run("robot/launch/it.launch").started) == nodes


def test_a_suffix_that_says_nothing_of_a_file_that_is_broken(launches):
    launches.file("robot/launch/it.launch", "launch = <launch>\n")
    assert [problem[3] for problem in launches.loader().problems()] == ["malformed XML: syntax error"]
