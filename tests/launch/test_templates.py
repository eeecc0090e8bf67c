"""Templates of launch files, in which a program replaces placeholders: nothing launches them as they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import node, write_robot

PUSHED = '<arg name="robot" default="{}"/><push_ros_namespace namespace="$(var robot)"/>' + node(name="bad name")


def told(root: Path, monkeypatch: pytest.MonkeyPatch, launch: str, **files: str) -> list[tuple[str, str]]:
    """The invalid names that are found, by file."""
    monkeypatch.chdir(root)
    write_robot(root, launch, **{"archlint.toml": 'select = ["NME002"]'} | files)
    found = check(Request((".",), load(root), cached=False, jobs=1)).findings
    return [(one.code, one.place.file) for one in found]


@pytest.mark.parametrize("placeholder", ["$ROBOT", "${robot}", "robots/$NAME", "@ROBOT@", "{{ robot.name }}"])
def test_a_file_with_placeholders_is_no_launch_file(tmp_path, monkeypatch, placeholder):
    assert told(tmp_path, monkeypatch, PUSHED.format(placeholder)) == []


@pytest.mark.parametrize("text", ["left", "$(env ROBOT left)", "$HOME", r"\$ROBOT", "me@robot", "^left$"])
def test_a_text_that_only_looks_like_a_placeholder(tmp_path, monkeypatch, text):
    found = told(tmp_path, monkeypatch, PUSHED.format("left") + f'<arg name="other" default="{text}"/>')
    assert ("NME002", "launch/it.launch.xml") in found


def test_what_a_shell_replaces_is_no_placeholder(tmp_path, monkeypatch):
    command = '<executable cmd="echo $ROBOT ${ROBOT}" shell="true"/>'
    assert ("NME002", "launch/it.launch.xml") in told(tmp_path, monkeypatch, PUSHED.format("left") + command)


def test_what_a_variable_of_the_environment_is_set_to_is_no_placeholder(tmp_path, monkeypatch):
    variable = '<set_env name="ROSCONSOLE_FORMAT" value="[${severity}] ${message}"/>'
    assert ("NME002", "launch/it.launch.xml") in told(tmp_path, monkeypatch, PUSHED.format("left") + variable)


def test_what_a_template_includes_is_not_judged_with_its_placeholders(tmp_path, monkeypatch):
    inner = '<launch><arg name="space" default="left"/><push_ros_namespace namespace="$(var space)"/></launch>'
    outer = '<include file="$(dirname)/inner.launch.xml"><arg name="space" value="{}"/></include>'
    files = {"launch/inner.launch.xml": inner.replace("</launch>", node() + "</launch>")}
    assert told(tmp_path, monkeypatch, outer.format("$ROBOT"), **files) == []
    assert told(tmp_path, monkeypatch, outer.format("a b"), **files) != []


def test_a_yaml_template(tmp_path, monkeypatch):
    text = "launch:\n- node: {pkg: robot, exec: talker, name: bad name}\n- arg: {name: x, default: VALUE}\n"
    name = "launch/b.launch.yaml"
    assert told(tmp_path, monkeypatch, "", **{name: text.replace("VALUE", "$ROBOT")}) == []
    assert told(tmp_path, monkeypatch, "", **{name: text.replace("VALUE", "ann")}) == [("NME002", name)]
