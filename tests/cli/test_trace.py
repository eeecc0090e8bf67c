"""``archlint trace NAME``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURES = Path(__file__).parents[2] / "fixtures"
PACKAGE, LAUNCH = "src/my_first_package/my_first_package", "src/my_first_package/launch/robot.launch.py"
CONTROL = f"{PACKAGE}/control_node.py"


@pytest.fixture
def lesson(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "lesson")


@pytest.fixture
def transforms(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(FIXTURES / "transforms")


def trace(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["trace", "--no-cache", *words]) == 0
    return capsys.readouterr().out


def test_where_a_request_comes_from(lesson, capsys):
    lines = trace(capsys, "set_motor").splitlines()
    assert lines[:7] == [
        f"service  /set_motor  my_robot_interfaces/srv/SetMotorSpeed  {LAUNCH}",
        "comes from",
        f"  called by /control_node ControlNode.control_loop  {CONTROL}:55, timer, every 2 s  only under a condition",
        "    reads /control_node self.latest_temp",
        f"      set by /control_node ControlNode.sensor_callback  {CONTROL}:28, subscription, every 1 s",
        "        on topic /sensor_data  1 Hz, my_robot_interfaces/msg/SensorReading",
        f"          published by /sensor_node SensorNode.publish_sensor  {PACKAGE}/sensor_node.py:33, timer, every 1 s",
    ]


def test_how_long_it_takes_and_what_is_assumed(lesson, capsys):
    lines = trace(capsys, "set_motor", "--from", "sensor_node").splitlines()
    first = lines.index("takes at most")
    assert lines[first + 1 : first + 8] == [
        "  /sensor_node SensorNode.publish_sensor → /sensor_data → /control_node → /set_motor",
        "    1 s + 1 s + 2 s + 1 s = 5 s, and the service /set_motor",
        "          1 s  SensorNode.publish_sensor of /sensor_node has its turn every 1 s",
        "          1 s  ControlNode.sensor_callback of /control_node waits while ControlNode.control_loop runs: it "
        "waits in wait_for_service() for up to 1 s",
        "          2 s  ControlNode.control_loop of /control_node reads it every 2 s",
        f"          1 s  ControlNode.control_loop waits in wait_for_service() for up to 1 s at {CONTROL}:47",
        "    not known  the service /set_motor takes its time",
    ]
    assert "  computing and the transport of messages, requests and answers take no time" in lines


def test_the_way_to_another_node(lesson, capsys):
    out = trace(capsys, "sensor_data", "--to", "motor_node")
    assert "comes from" not in out
    assert "  received by /control_node ControlNode.sensor_callback" in out
    assert "served by /motor_node MotorNode.motor_callback" in out
    assert "answer taken by" not in out


def test_a_client_that_is_not_used(lesson, capsys):
    lines = trace(capsys, "query_sensor").splitlines()
    assert lines[2] == f"  called by /control_node  {CONTROL}:19  no call of it is seen"


def test_as_data(lesson, capsys):
    document = json.loads(trace(capsys, "/sensor_data", "--format", "json"))
    [found] = document["traces"]
    assert (document["version"], found["kind"], found["system"]) == (1, "topic", LAUNCH)
    steps = {step["id"]: step for step in found["steps"]}
    names = [(steps[number]["kind"], steps[number]["name"]) for number in found["comes_from"]]
    assert names == [("topic", "/sensor_data"), ("callback", "SensorNode.publish_sensor")]
    [source] = [step for step in found["steps"] if step["name"] == "SensorNode.publish_sensor"]
    assert (source["role"], source["period_s"], source["node"]) == ("timer", 1.0, "/sensor_node")
    assert {link["kind"] for link in found["links"]} == {"send", "arrive", "set", "read"}
    assert found["ways"][0]["known_s"] == 1.0
    assert all(step["id"] == number for number, step in enumerate(found["steps"]))


def test_pictures(lesson, capsys, tmp_path):
    mermaid = trace(capsys, "/sensor_data", "--to", "set_motor", "--format", "mermaid")
    assert mermaid.startswith("flowchart LR\n")
    assert '(["ControlNode.control_loop<br>timer, every 2 s"])' in mermaid
    assert trace(capsys, "/sensor_data", "-o", str(tmp_path / "trace.dot")) == ""
    assert 'label="/control_node"' in (tmp_path / "trace.dot").read_text()


MISTAKES = {
    ("/sensor_dta",): "no topic, service, action, frame or node is called `/sensor_dta`; did you mean '/sensor_data'?",
    (
        "sensor_data",
        "--to",
        "motr_node",
    ): "no topic, service, action, frame or node is called `motr_node`; did you mean '/motor_node'?",
    (
        "sensor_data",
        "--from",
        "motor_node",
    ): "no way is known from `motor_node` to `sensor_data`: a system must have one that goes through all of them",
    ("sensor_data", "-o", "trace.doc"): "the suffix of trace.doc does not name a format: use one of .txt, .json, .mmd, "
    ".mermaid, .dot, .gv, .svg, or --format",
}


@pytest.mark.parametrize(("words", "said"), MISTAKES.items(), ids=lambda value: " ".join(value)[:20])
def test_a_wrong_call_says_what_is_wrong(lesson, capsys, words, said):
    assert main(["trace", "--no-cache", *words]) == 2
    assert capsys.readouterr().err == f"archlint: error: {said}\n"


def test_the_frames_between_what_is_looked_up(transforms, capsys):
    rover = "src/rover/rover"
    lines = trace(capsys, "cmd_vel").splitlines()
    assert lines[1:11] == [
        "comes from",
        f"  published by /docking Docking.approach  {rover}/docking.py:24, timer, every 0.1 s",
        "    looks up the frame camera",
        "      sent by /camera_mount  src/rover/launch/rover.launch.py:6, its source is not here",
        "    looks up the frame footprint  20 Hz",
        f"      sent by /odometry Odometry.send  {rover}/odometry.py:26, timer, every 0.05 s",
        "        reads /odometry self.speed",
        f"          set by /odometry Odometry.drive  {rover}/odometry.py:16, subscription, every 0.1 s",
        "    looks up the frame odom  5 Hz",
        f"      sent by /localization Localization.locate  {rover}/localization.py:18, timer, every 0.2 s",
    ]
    assert "laser" not in trace(capsys, "cmd_vel")


def test_a_frame_as_data_and_as_a_picture(transforms, capsys):
    [traced] = json.loads(trace(capsys, "footprint", "--to", "cmd_vel", "--format", "json"))["traces"]
    assert (traced["kind"], traced["name"]) == ("frame", "footprint")
    [frame] = [step for step in traced["steps"] if step["name"] == "footprint"]
    assert (frame["kind"], frame["rate_hz"]) == ("frame", 20)
    [link] = [link for link in traced["links"] if link["from"] == frame["id"]]
    assert (link["kind"], link["certain"], link["line"]) == ("read", True, 18)
    assert '[/"frame footprint<br>20 Hz"/]' in trace(capsys, "footprint", "--format", "mermaid")
    assert 'label="frame footprint\\n20 Hz", shape=tab' in trace(capsys, "footprint", "--format", "dot")


def test_a_frame_that_nobody_sends_is_the_root(transforms, capsys):
    lines = trace(capsys, "map").splitlines()
    assert lines[2] == "  no node here is seen to send it as the child of another frame"
    assert lines[4] == "  no transform that is looked up is seen to depend on it"
