"""The options of ``archlint graph`` that choose what is shown."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from archlint.cli import main

LESSON = str(Path(__file__).parents[2] / "fixtures" / "lesson")


def drawn(capsys: pytest.CaptureFixture[str], *options: str) -> str:
    assert main(["graph", LESSON, "--isolated", "--no-cache", *options]) == 0
    return capsys.readouterr().out


def test_nodes_alone(capsys: pytest.CaptureFixture[str]) -> None:
    shown = drawn(capsys, "--format", "mermaid", "--style", "nodes")
    assert 'node_control_node -->|"/set_motor"| node_motor_node' in shown
    assert "service_set_motor" not in shown


def test_what_is_near_a_name(capsys: pytest.CaptureFixture[str]) -> None:
    shown = drawn(capsys, "--format", "mermaid", "--focus", "set_motor")
    assert "node_motor_node" in shown and "node_sensor_node" not in shown
    assert "not shown: 1 node, 1 topic, 1 service" in shown


def test_text_leaves_out_what_is_hidden_and_still_names_the_other_end(capsys: pytest.CaptureFixture[str]) -> None:
    shown = drawn(capsys, "--hide", "/motor_node")
    assert "MotorNode" not in shown
    assert "/set_motor  my_robot_interfaces/srv/SetMotorSpeed\n  served by      /motor_node\n" in shown


def test_json_has_the_part_that_is_asked_for(capsys: pytest.CaptureFixture[str]) -> None:
    part = json.loads(drawn(capsys, "--format", "json", "--only", "/motor_node"))
    assert [node["name"] for node in part["nodes"]] == ["/motor_node"]


def test_a_name_that_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["graph", LESSON, "--isolated", "--no-cache", "--focus", "/moter_node"]) == 2
    assert "nothing here is called /moter_node; did you mean '/motor_node'?" in capsys.readouterr().err


def test_a_style_that_there_is_not(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["graph", LESSON, "--style", "node"]) == 2
    assert "did you mean nodes?" in capsys.readouterr().err


LAUNCHED = Path(LESSON).parent / "launched"
LAUNCH_FILE = next(LAUNCHED.rglob("*.launch.py"))
NO_FRAME = "--group launch draws no frame: only with --launch FILE is it known which launch file starts a node"


@pytest.mark.parametrize(("options", "said"), [(("--launch", str(LAUNCH_FILE)), False), ((), True)])
def test_frames_of_launch_files_want_a_launch_file(
    capsys: pytest.CaptureFixture[str], options: tuple[str, ...], said: bool
) -> None:
    words = ["graph", str(LAUNCHED), "--isolated", "--no-cache", "--format", "dot", "--group", "launch", *options]
    assert main(words) == 0
    shown = capsys.readouterr()
    assert (NO_FRAME in shown.err) is said
    assert ("subgraph cluster_" in shown.out) is not said


def test_frames_of_namespaces_want_a_namespace(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["graph", LESSON, "--isolated", "--no-cache", "--format", "dot", "--group", "namespace"]) == 0
    assert "--group namespace draws no frame: no node is in a namespace" in capsys.readouterr().err
