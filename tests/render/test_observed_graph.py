"""``graph --observed``: what a running system has otherwise, in data, text and pictures."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.observed.read import read
from archlint.render import html, text
from archlint.render import json as as_json
from archlint.render.picture import graph_of
from archlint.systems.model import System
from render.pictures import dot, mermaid

ROOT = Path(__file__).parents[2]
LAUNCH = "src/my_first_package/launch/robot.launch.py"


def running() -> dict[str, Any]:
    """The lesson's robot without its motor; the sensor publishes under another name, the control listens best effort,
    and a stranger drives."""
    record = json.loads((ROOT / "tests" / "observed" / "lesson.jazzy.json").read_text("utf-8"))
    nodes = {node["name"]: node for node in record["nodes"] if node["name"] != "/motor_node"}
    for end in nodes["/sensor_node"]["publishers"]:
        end["name"] = end["name"].replace("/sensor_data", "/readings")
    for end in nodes["/control_node"]["subscribers"]:
        end["qos"]["reliability"] = "best_effort"
    velocity = {"name": "/cmd_vel", "type": "geometry_msgs/msg/Twist"}
    log = {"name": "/rosout", "type": "rcl_interfaces/msg/Log"}
    return {**record, "nodes": [*nodes.values(), {"name": "/stranger", "publishers": [velocity, log]}]}


@pytest.fixture
def system(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> System:
    path = tmp_path / "robot.json"
    path.write_text(json.dumps(running(), indent=1), encoding="utf-8")
    monkeypatch.chdir(ROOT / "fixtures" / "lesson")
    return graph(Request((".",), Settings(), cached=False, jobs=1, launch=LAUNCH, observed=read(str(path))))


def test_the_data_name_each_difference(system: System):
    found = as_json.document(system)["observed"]
    assert (found["form"], found["nodes"], found["compared_with"]) == (
        "recording",
        2,
        f"the system that {LAUNCH} starts",
    )
    rows = [(one["status"], one["kind"], one["name"], one["expected"], one["observed"]) for one in found["differences"]]
    assert sorted(rows) == [
        ("different", "publisher", "/sensor_data", "/sensor_data", "/readings"),
        ("different", "subscriber", "/sensor_data", "reliable", "best effort"),
        ("missing", "node", "/motor_node", "/motor_node", None),
        ("unexpected", "node", "/stranger", None, "/stranger"),
    ]
    assert all(one["file"] and one["line"] for one in found["differences"])


def test_without_a_recording_nothing_is_said_of_one(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(ROOT / "fixtures" / "lesson")
    plain = graph(Request((".",), Settings(), cached=False, jobs=1))
    assert "observed" not in as_json.document(plain)
    assert "running system" not in text.render(plain)
    assert not any("observed" in data for _, data in graph_of(plain).nodes(data=True))


def test_the_text_ends_with_the_differences(system: System):
    said = text.render(system).partition("running system\n\n")[2]
    assert "2 nodes and 3 endpoints on both sides; 1 missing, 1 unexpected, 2 different." in said
    assert re.search(rf"  missing     /motor_node does not run, and {LAUNCH} starts it +{LAUNCH}:10\n", said)


def test_the_picture_marks_them(system: System):
    drawn = graph_of(system)
    marked = {key: data["observed"] for key, data in drawn.nodes(data=True) if data.get("observed")}
    lines = {(tail[1], head[1]): (edge["observed"], edge["remark"])
             for tail, head, edge in drawn.edges(data=True) if edge.get("observed")}  # fmt: skip

    assert marked == {
        ("node", "/motor_node"): "missing",
        ("node", "/stranger"): "unexpected",
        ("topic", "/cmd_vel"): "unexpected",
        ("topic", "/readings"): "unexpected",
    }
    assert lines == {
        ("/set_motor", "/motor_node"): ("missing", ""),
        ("/sensor_node", "/sensor_data"): ("different", "different: /readings"),
        ("/sensor_node", "/readings"): ("different", "different"),
        ("/sensor_data", "/control_node"): ("different", "different: best effort"),
        ("/stranger", "/cmd_vel"): ("unexpected", ""),
    }


def test_each_has_its_colour_and_its_word(system: System):
    drawn = dot(system)
    shapes = {match[1]: match[0] for match in re.finditer(r" \[label=<[^/]*(?:<[^>]*>)*(/\w+).*", drawn)}
    assert all(word in shapes["/motor_node"] for word in ("missing", "#e11d48", "dashed"))
    assert "unexpected" in shapes["/stranger"] and "#15803d" in shapes["/stranger"]
    assert "#1d4ed8" in shapes["/sensor_node"]
    assert re.search(r'different: best effort.*color="#0e7490"', drawn)
    assert "red is missing, green unexpected, teal different" in drawn


def test_mermaid_colours_them_too(system: System):
    drawn = mermaid(system)
    assert re.search(r'node_motor_node\(\["/motor_node<br>missing"\]\)', drawn)
    assert "classDef missing" in drawn and "classDef unexpected" in drawn
    assert re.search(r"linkStyle \d+ stroke:#e11d48", drawn)


def test_the_page_has_it_in_its_data(system: System):
    page = html.render(system)
    assert '"look":"missing"' in page
    assert re.search('"observed":"different","remark":"different: best effort', page)
