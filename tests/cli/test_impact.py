"""``archlint impact NAME``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"
PACKAGE, LAUNCH = "src/my_first_package/my_first_package", "src/my_first_package/launch/robot.launch.py"


def impact(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["impact", "--no-cache", *words]) == 0
    return capsys.readouterr().out


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "lesson")


@pytest.fixture
def launched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "launched")


def test_a_node(lesson, capsys):
    lines = impact(capsys, "sensor_node").splitlines()
    assert lines[:4] == [
        f"node  /sensor_node  {LAUNCH}",
        "used by",
        f"  /control_node  gets no message of /sensor_data any more  {PACKAGE}/control_node.py:12",
        f"  /control_node  gets no answer of /query_sensor any more  {PACKAGE}/control_node.py:19",
    ]
    assert f"  /motor_node  MotorNode.motor_callback  depends on it  {PACKAGE}/motor_node.py:18" in lines
    assert f"  starts it  {LAUNCH}:9" in lines


def test_an_interface_and_the_packages_that_need_it(lesson, capsys):
    [found] = json.loads(impact(capsys, "SetMotorSpeed", "--format", "json"))["matches"]
    assert (found["kind"], found["name"]) == ("interface", "my_robot_interfaces/srv/SetMotorSpeed")
    assert found["packages"] == ["my_first_package", "my_robot_interfaces"]
    fields = [(use["line"], use["message"]) for use in found["uses"] if use["kind"] == "field"]
    assert (53, "sets speed_rpm of the Request") in fields


def test_parameter_files_and_launch_files(launched, capsys):
    lines = impact(capsys, "/north/scanner").splitlines()
    assert "  sets its parameters under /north/scanner  src/patrol/config/patrol.yaml:2" in lines
    assert "  starts it  src/patrol/launch/robot.launch.xml:4" in lines


def test_a_topic_and_what_names_it(launched, capsys):
    [found] = json.loads(impact(capsys, "/north/front/scan", "--format", "json"))["matches"]
    [named] = found["parameter_files"]
    assert (named["file"], named["line"]) == ("src/patrol/config/patrol.yaml", 4)
    assert named["message"] == "names it in the parameter topic of /north/scanner"


def test_a_picture(lesson, capsys):
    drawn = impact(capsys, "sensor_data", "--format", "mermaid")
    assert "ControlNode.sensor_callback" in drawn
    assert "SensorNode.publish_sensor" not in drawn


def test_a_name_that_nothing_has(lesson, capsys):
    assert main(["impact", "--no-cache", "SensorReadng"]) == 2
    assert "did you mean" in capsys.readouterr().err
