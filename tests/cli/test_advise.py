"""``archlint advise``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"


def advise(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["advise", "--no-cache", *words]) == 0
    return capsys.readouterr().out


@pytest.fixture
def polled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "antipattern_1_service_for_continuous_data")


def test_text(polled, capsys):
    assert advise(capsys).splitlines() == [
        "something else fits better (1)",
        "  service /get_temperature  thermo_interfaces/srv/GetTemperature",
        "    used as a stream, 10 Hz",
        "    a topic fits better: what is asked for again and again is a stream, of which a topic sends each value "
        "once to all who want it",
        "    instead: publish the data in /thermometer, and subscribe to it in /display",
        "      /display calls it 10 times a second  src/thermo/thermo/display.py:20",
        "      the timer is made here  src/thermo/thermo/display.py:15",
        "      /display reads degrees of the answer  src/thermo/thermo/display.py:22",
    ]


def test_json(polled, capsys):
    document = json.loads(advise(capsys, "--format", "json"))
    [connection] = document["connections"]
    assert (document["version"], connection["kind"], connection["name"]) == (1, "service", "/get_temperature")
    assert (connection["use"], connection["fits"], connection["better"]) == ("stream", False, "topic")
    assert connection["systems"] == []
    assert connection["rate_hz"] == 10.0
    assert connection["evidence"][0] == {
        "message": "/display calls it 10 times a second",
        "file": "src/thermo/thermo/display.py",
        "line": 20,
        "column": 18,
    }


def test_markdown(polled, capsys, tmp_path):
    target = tmp_path / "advice.md"
    assert advise(capsys, "--format", "markdown", "-o", str(target)) == ""
    lines = target.read_text("utf-8").splitlines()
    assert "| service | `/get_temperature` | stream | 10 Hz | better: topic |" in lines
    assert "## Service `/get_temperature`" in lines
    assert "**Instead**: publish the data in /thermometer, and subscribe to it in /display." in lines


def test_what_a_launch_file_starts(capsys, monkeypatch):
    monkeypatch.chdir(FIXTURES / "launched")
    launch = "src/patrol/launch/robot.launch.xml"
    document = json.loads(advise(capsys, "--launch", launch, "--format", "json"))
    assert {name for connection in document["connections"] for name in connection["systems"]} == {launch}
    unknown = [row["reason"] for row in document["connections"] if row["use"] == "unknown"]
    assert unknown == ["no node here publishes it"]


def test_nothing_is_connected(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "node.py").write_text("import rclpy\nrclpy.init()\nnode = rclpy.create_node('a')\n", "utf-8")
    assert advise(capsys) == "no topic, service or action is here\n"


def test_a_format_that_is_none(polled, capsys):
    assert main(["advise", "--format", "yaml"]) == 2
    assert "yaml" in capsys.readouterr().err
