"""``--launch FILE arg:=value …`` of ``check`` and ``graph``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main
from robot_package import SETUP, manifest, write_files
from systems.test_launched import TALKER

LAUNCH = """<launch>
  <arg name="robot" default="alice"/>
  <node pkg="robot" exec="talker" namespace="$(var robot)"/>
</launch>
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    texts = {
        "src/robot/package.xml": manifest(),
        "src/robot/setup.py": SETUP,
        "src/robot/robot/talker.py": TALKER,
        "src/robot/launch/up.launch.xml": LAUNCH,
    }
    return write_files(tmp_path, texts)


FILE = "src/robot/launch/up.launch.xml"


@pytest.mark.parametrize(("words", "name"), [([], "/alice/talker"), (["robot:=bob"], "/bob/talker")])
def test_the_graph_of_a_launch_file(folder, capsys, words, name):
    status = main(["graph", "--format", "json", "--no-cache", "--launch", FILE, *words])
    made = json.loads(capsys.readouterr().out)
    assert status == 0
    assert [(node["name"], node["launched_by"]) for node in made["nodes"]] == [(name, FILE)]
    assert made["system"] == FILE


def test_words_that_are_no_arguments_are_paths(folder, capsys):
    assert main(["graph", "--format", "json", "--no-cache", "--launch", FILE, "robot:=bob", "src"]) == 0
    assert "/bob/talker" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("file", "words"),
    [("gone.launch.py", "no such file: gone.launch.py"), ("src/robot/setup.py", "is not a launch file")],
)
def test_what_cannot_be_launched(folder, capsys, file, words):
    assert main(["check", "--no-cache", "--launch", file]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize("command", ["check", "graph"])
def test_arguments_that_the_launch_file_does_not_know_and_wants_are_told(folder, capsys, command):
    (folder / FILE).write_text(LAUNCH.replace("<node", '<arg name="sim"/><node if="$(var sim)"'))
    main([command, "--no-cache", "--launch", FILE, "robbot:=bob"])
    assert capsys.readouterr().err.splitlines()[:2] == [
        f"archlint: warning: {FILE} has no argument 'robbot'; did you mean 'robot'?",
        f"archlint: warning: {FILE} needs a value for 'sim': sim:=true or sim:=false",
    ]
    main([command, "--no-cache", "--launch", FILE, "robot:=bob", "sim:=true"])
    assert "archlint: warning" not in capsys.readouterr().err


@pytest.mark.parametrize("command", ["check", "graph"])
def test_a_launch_file_of_ros_1_cannot_be_launched(folder, capsys, command):
    (folder / "old.launch").write_text('<launch><node pkg="robot" type="talker.py" name="talker"/></launch>')
    assert main([command, "--no-cache", "--launch", "old.launch"]) == 2
    assert "old.launch is for ROS 1" in capsys.readouterr().err


def test_only_the_launched_system_is_judged(folder, capsys):
    (folder / "archlint.toml").write_text('select = ["LCH001"]')
    (folder / "src/robot/launch/other.launch.xml").write_text('<launch><node pkg="robot" exec="taker"/></launch>')
    assert main(["check", "--no-cache", "--format", "concise"]) == 1
    assert "LCH001" in capsys.readouterr().out
    assert main(["check", "--no-cache", "--format", "concise", "--launch", FILE]) == 0


def test_what_a_parameter_file_holds_for_other_launch_files_is_not_judged(folder, capsys):
    (folder / "archlint.toml").write_text('select = ["PRM004", "PRM005"]')
    values = "/**: {ros__parameters: {mass: 1.0}}\nlistener: {ros__parameters: {rate: 2.0}}\n"
    (folder / "src/robot/config").mkdir()
    (folder / "src/robot/config/all.yaml").write_text(values)
    starts = '<launch><node pkg="robot" exec="talker"><param from="$(dirname)/../config/all.yaml"/></node></launch>'
    (folder / "src/robot/launch/one.launch.xml").write_text(starts)
    arguments = ["check", "--no-cache", "--format", "concise", "--launch", "src/robot/launch/one.launch.xml"]

    assert main(arguments) == 0  # the other launch file may start what the values are for
    (folder / FILE).unlink()
    assert main(arguments) == 1
    shown = capsys.readouterr().out
    assert "PRM004" in shown
    assert "PRM005" in shown


def test_a_launch_file_of_another_package_that_starts_nothing_of_this_one_is_told(folder, capsys):
    write_files(folder, {"src/arm/package.xml": manifest("arm"), "src/arm/arm/talker.py": TALKER})
    (folder / ".git").mkdir()
    main(["check", "--no-cache", "src/arm", "--launch", FILE])
    assert f"{FILE} starts no node of src/arm, so little is checked there" in capsys.readouterr().err
    for path in ("src/robot", ".", FILE, "src/robot/robot/talker.py"):
        main(["check", "--no-cache", path, "--launch", FILE])
        assert "starts no node" not in capsys.readouterr().err
