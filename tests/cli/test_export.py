"""``archlint export``."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "lesson")


def export(capsys: pytest.CaptureFixture[str], *words: str, status: int = 0) -> tuple[str, str]:
    assert main(["export", "--no-cache", *words]) == status
    shown = capsys.readouterr()
    return shown.out, shown.err


def test_interfaces_to_standard_output(lesson, capsys):
    out, err = export(capsys, "--format", "interface-yaml")
    documents = {document["node"]["name"]: document for document in yaml.safe_load_all(out)}
    assert [*documents] == ["control_node", "motor_node", "sensor_node"]
    assert documents["motor_node"]["services"] == [
        {"name": "set_motor", "type": "my_robot_interfaces/srv/SetMotorSpeed"}
    ]
    assert err == ""


def test_into_a_file(lesson, capsys, tmp_path):
    assert export(capsys, "--format", "nodl", "-o", str(tmp_path / "robot.nodl.xml")) == ("", "")
    assert '<node name="motor_node" executable="motor_node">' in (tmp_path / "robot.nodl.xml").read_text()


def test_the_policy_of_the_only_launch_file(lesson, capsys):
    out, _ = export(capsys, "--format", "sros2-policy")
    assert '<profile ns="/" node="sensor_node">' in out
    assert "<topic>/sensor_data</topic>" in out


def test_a_policy_needs_to_know_which_system(monkeypatch, capsys):
    monkeypatch.chdir(FIXTURES / "launched")
    _, err = export(capsys, "--format", "sros2-policy", status=2)
    assert "a policy is for one system: name its launch file with --launch (src/patrol/launch/fleet.launch.py" in err
    out, err = export(capsys, "--format", "sros2-policy", "--launch", "src/patrol/launch/fleet.launch.py")
    assert '<profile ns="/north" node="scanner">' in out
    assert "<topic>/north/front/scan</topic>" in out
    assert "left out: /tools/bag: its source is not in this workspace" in err


def test_a_format_has_to_be_named(lesson, capsys):
    _, err = export(capsys, status=2)
    assert "--format" in err


def test_a_format_that_is_not_there(lesson, capsys):
    _, err = export(capsys, "--format", "sros2", status=2)
    assert "did you mean sros2-policy?" in err
