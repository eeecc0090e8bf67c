"""``archlint show NAME``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"


@pytest.fixture
def launched(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "launched")


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "lesson")


@pytest.fixture
def transforms(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "transforms")


def show(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["show", "--no-cache", *words]) == 0
    return capsys.readouterr().out


def test_a_topic_with_both_ends(lesson, capsys):
    package, launch = "src/my_first_package/my_first_package", "src/my_first_package/launch/robot.launch.py"
    assert show(capsys, "sensor_data") == (
        "topic /sensor_data  my_robot_interfaces/msg/SensorReading\n"
        f"  published by   /sensor_node   {package}/sensor_node.py:12:27  "
        f"reliable, volatile, keep last 10, 1 Hz, {launch}\n"
        f"  subscribed by  /control_node  {package}/control_node.py:12:29  reliable, volatile, keep last 10, {launch}\n"
        f"  named at       {package}/control_node.py:14:13\n"
        f"                 {package}/sensor_node.py:13:28\n"
    )


def test_a_service_lines_up(lesson, capsys):
    lines = show(capsys, "set_motor").splitlines()[1:]
    assert [line[:13] for line in lines] == [
        "  served by  ",
        "  called by  ",
        "  named at   ",
        "             ",
    ]
    assert all(line[13] != " " for line in lines)


def test_a_service_as_data(lesson, capsys):
    shown = json.loads(show(capsys, "/set_motor", "--format", "json"))
    [service] = shown["matches"]
    assert (shown["version"], shown["name"], service["kind"]) == (1, "/set_motor", "service")
    assert service["types"] == ["my_robot_interfaces/srv/SetMotorSpeed"]
    assert [(end["node"], end["line"]) for end in service["servers"]] == [("/motor_node", 10)]
    assert [(end["node"], end["line"]) for end in service["clients"]] == [("/control_node", 21)]
    assert [(place["line"], place["column"]) for place in service["places"]] == [(22, 28), (12, 13)]


def test_a_parameter_and_what_sets_it(launched, capsys):
    assert show(capsys, "topic").splitlines() == [
        "parameter topic  of /north/scanner, /south/scanner",
        "  declared       string = 'scan'  src/patrol/patrol/scanner.py:9:17",
        "  launched with  = 'front/scan'   /north/scanner, src/patrol/launch/fleet.launch.py",
        "  set at         src/patrol/config/patrol.yaml:4:5",
    ]
    [parameter] = json.loads(show(capsys, "topic", "--format", "json"))["matches"]
    assert (parameter["type"], parameter["default"]) == ("string", "scan")
    assert [(row["node"], row["value"]) for row in parameter["values"]] == [("/north/scanner", "front/scan")]


def test_a_frame_with_both_ends(transforms, capsys):
    launch = "src/rover/launch/rover.launch.py"
    assert show(capsys, "footprint").splitlines() == [
        "frame footprint",
        f"  sent by       /odometry      src/rover/rover/odometry.py:26:9       in odom, {launch}",
        f"  sent in it    /camera_mount  {launch}:6:98  camera, {launch}",
        f"  sent in it    /laser_mount   {launch}:6:98  laser, {launch}",
        "  looked up by  no node here",
    ]
    [frame] = json.loads(show(capsys, "map", "--format", "json"))["matches"]
    assert (frame["kind"], frame["sent"]) == ("frame", [])
    assert [(row["node"], row["child"]) for row in frame["sent_in_it"]] == [("/localization", "odom")]
    [row] = frame["looked_up"]
    assert (row["node"], row["target"], row["source"], row["line"]) == ("/docking", "map", "camera", 18)


def test_a_node_by_its_name_or_class(launched, capsys):
    north, south = show(capsys, "Scanner").split("\n\n")
    assert north.startswith("node /north/scanner  Scanner  patrol/scanner  src/patrol/patrol/scanner.py:6  src/patrol/")
    assert show(capsys, "/south/scanner") == south
    [node] = json.loads(show(capsys, "/south/scanner", "--format", "json"))["matches"]
    assert (node["kind"], node["name"], [end["name"] for end in node["publishers"]]) == (
        "node",
        "/south/scanner",
        ["/south/scan"],
    )


def test_a_name_as_the_code_writes_it(launched, capsys):
    blocks = show(capsys, "~/state").split("\n\n")
    assert [block.split("  ")[0] for block in blocks] == [
        "topic /north/base/wheels/state",
        "topic /south/base/wheels/state",
    ]


def test_one_side_alone(launched, capsys):
    lines = show(capsys, "/base/scan", "--launch", "src/patrol/launch/robot.launch.xml").splitlines()
    assert "  published by   no node here" in [line.rstrip() for line in lines]


def test_a_name_that_nothing_has(lesson, capsys):
    assert main(["show", "--no-cache", "/sensor_dta"]) == 2
    said = "no node, topic, service, action, frame or parameter is called `/sensor_dta`; did you mean '/sensor_data'?"
    assert capsys.readouterr().err == f"archlint: error: {said}\n"


def test_it_writes_to_a_file(lesson, capsys, tmp_path):
    assert show(capsys, "/set_motor", "-o", str(tmp_path / "motor.txt")) == ""
    assert (tmp_path / "motor.txt").read_text().startswith("service /set_motor  ")


def test_no_name_is_a_wrong_call(lesson, capsys):
    assert main(["show"]) == 2
    assert "the following arguments are required: NAME" in capsys.readouterr().err
