"""Launch files that are broken or hostile: a word about it, in bounded time, and nothing is executed."""

from __future__ import annotations

import pytest

from launching import PYTHON, names


@pytest.mark.parametrize(
    ("path", "data", "words"),
    [
        ("launch/a.launch.py", b"def generate_launch_description(:\n", "syntax error"),
        ("launch/a.launch.xml", b'<launch><arg name="caf\xe9"/></launch>', "byte 0xe9 is not valid utf-8"),
        ("launch/a.launch.yaml", b"launch:\n- arg: {name: caf\xe9}\n", "byte 0xe9 is not valid utf-8"),
        ("launch/a.launch.xml", b" " * 8_000_001, "too large"),
        ("setup.py", b"from setuptools import setup\nsetup(\n", "syntax error"),
    ],
)
def test_a_file_that_cannot_be_read_is_told_of(launches, path, data, words):
    (launches.root / "robot/launch").mkdir(exist_ok=True)
    (launches.root / "robot" / path).write_bytes(data)
    loaded = launches.of_workspace(relevant=lambda file: False)
    (problem,) = loaded.files.problems()
    assert problem[0] == f"robot/{path}" and words in problem[3]


def test_xml_says_itself_how_it_is_encoded(launches):
    text = (
        '<?xml version="1.0" encoding="ISO-8859-1"?><launch><node pkg="robot" exec="talker" name="n"/><!--é--></launch>'
    )
    (launches.root / "robot/launch").mkdir(exist_ok=True)
    (launches.root / "robot/launch/it.launch.xml").write_bytes(text.encode("latin-1"))
    assert names(launches.run("robot/launch/it.launch.xml")) == ["n"]


def test_substitutions_nested_too_deeply_are_unknown(launches):
    launched = launches.xml('<node pkg="robot" exec="talker" name="' + "$(var " * 3000 + ")" * 3000 + '"/>')
    assert [use.name for use in launched.undeclared] == []
    assert names(launched) == ["?"]


@pytest.mark.parametrize("body", ["    1 / 0\n", "    raise RuntimeError('no')\n", "    LaunchDescription([])\n"])
def test_a_launch_file_that_gives_no_description_says_so(launches, body):
    launches.file("robot/launch/it.launch.py", f"{PYTHON}\ndef generate_launch_description():\n{body}")
    gaps = launches.run("robot/launch/it.launch.py").gaps
    assert any("returns an unknown launch description" in gap.reason for gap in gaps)


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
    loaded = launches.of_workspace()
    assert loaded.files.all() == (["robot/launch/it.launch"] if nodes else [])
    assert loaded.files.problems() == []
    assert len(launches.run("robot/launch/it.launch").started) == nodes


def test_a_suffix_that_says_nothing_of_a_file_that_is_broken(launches):
    launches.file("robot/launch/it.launch", "launch = <launch>\n")
    assert [problem[3] for problem in launches.of_workspace().files.problems()] == ["malformed XML: syntax error"]
