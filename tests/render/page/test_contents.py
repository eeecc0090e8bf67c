"""What the data of a page say."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from archlint.finding import Finding, Related, Severity
from archlint.place import Place
from archlint.render.page.contents import page_data
from archlint.render.page.model import PageContents, PageSystem
from archlint.ros.qos import Qos
from archlint.systems.model import System
from render.lesson import READING, lesson
from render.pictures import diagram
from systems.builders import node, parameter, publisher, subscriber, system


def data_of(shown: System, *findings: Finding, **arguments: str) -> dict[str, Any]:
    return page_data(PageContents([PageSystem(shown, arguments)], findings))


def vertex(data: dict[str, Any], name: str) -> dict[str, Any]:
    [found] = [vertex for vertex in data["systems"][0]["vertices"] if vertex.get("name") == name]
    return found


def edges(data: dict[str, Any]) -> list[tuple[str, str]]:
    [shown] = data["systems"]
    names = [vertex["name"] for vertex in shown["vertices"]]
    return [(names[edge["tail"]], names[edge["head"]]) for edge in shown["edges"]]


def at(file: str, line: int) -> Place:
    return Place(file, line, 5, line, 9)


def finding(place: Place, **more: Any) -> Finding:
    return Finding("TOP001", "topic-type-mismatch", Severity.ERROR, "two types", place, **more)


def test_lines_run_with_the_data_and_requests():
    assert set(edges(data_of(lesson()))) == {
        ("/sensor_node", "/sensor_data"),
        ("/sensor_data", "/control_node"),
        ("/control_node", "/query_sensor"),
        ("/query_sensor", "/sensor_node"),
        ("/control_node", "/set_motor"),
        ("/set_motor", "/motor_node"),
    }


def test_a_node_has_what_the_json_of_the_graph_says():
    data = data_of(lesson())
    sensor = vertex(data, "/sensor_node")
    assert (sensor["class"], sensor["package"], sensor["namespace"]) == ("SensorNode", "my_first_package", "/")
    assert [timer["callback"] for timer in sensor["timers"]] == ["SensorNode.publish_sensor"]
    assert [parameter["default"] for parameter in sensor["parameters"]] == [1.0]
    assert "lifecycle" not in sensor, "what is false is left out"
    assert vertex(data, "/sensor_data")["types"] == [READING]


def test_a_parameter_whose_default_is_zero():
    data = data_of(system(node("/arm", parameter("speed", 0, "integer"))))
    assert [parameter["default"] for parameter in vertex(data, "/arm")["parameters"]] == [0]


def test_an_end_has_its_quality_of_service_and_its_callback():
    data = data_of(lesson())
    [shown] = data["systems"]
    ends = [end for edge in shown["edges"] for end in edge["ends"] if end["kind"] == "subscriber"]
    assert [(end["callback"], end["qos"]["depth"]) for end in ends] == [("ControlNode.sensor_callback", 10)]


def test_a_connection_that_quality_of_service_keeps_apart_says_so():
    offered = replace(Qos(), reliability="best_effort")
    data = data_of(system(node("/a", publisher("/x", qos=offered)), node("/b", subscriber("/x"))))
    broken = {end["broken"] for edge in data["systems"][0]["edges"] for end in edge["ends"]}
    assert broken == {"best effort offered, reliable requested"}


def test_a_finding_belongs_to_the_node_that_it_names_and_to_what_its_place_creates():
    shown = lesson()
    [control] = [node for node in shown.nodes if node.name == "/control_node"]
    [end] = [end for end in control.endpoints if end.name == "/sensor_data"]
    data = data_of(shown, finding(end.place), finding(at("else.py", 3), node="/motor_node"))
    assert vertex(data, "/control_node")["findings"] == [0]
    assert vertex(data, "/sensor_data")["findings"] == [0]
    assert vertex(data, "/motor_node")["findings"] == [1]
    assert "findings" not in vertex(data, "/sensor_node")
    assert data["systems"][0]["findings"] == []


def test_a_related_place_counts_too():
    shown = lesson()
    [sensor] = [node for node in shown.nodes if node.name == "/sensor_node"]
    [end] = [end for end in sensor.endpoints if end.name == "/sensor_data"]
    found = finding(at("else.py", 3), related=(Related(end.place, "published here"),))
    assert vertex(data_of(shown, found), "/sensor_data")["findings"] == [0]


def test_a_finding_is_where_other_pictures_have_its_badge():
    """One in the file of a node, below its class, names no node and is about nothing that is created."""
    shown = lesson()
    node = next(node for node in shown.nodes if node.name == "/motor_node")
    assert node.blueprint is not None
    told = finding(replace(node.blueprint.place, line=node.blueprint.place.line + 90))
    badges = {shape.title for shape in diagram(shown, findings=[told]).shapes.values() if shape.badges}
    data = data_of(shown, told)
    assert badges == {"/motor_node"}
    assert vertex(data, "/motor_node")["findings"] == [0]
    assert data["systems"][0]["findings"] == []


def test_a_finding_about_nothing_in_the_picture_is_listed_apart():
    assert data_of(lesson(), finding(at("setup.py", 1)))["systems"][0]["findings"] == [0]


@pytest.mark.parametrize(
    ("launch", "condition", "arguments", "holds"),
    [
        (None, None, {}, True),
        ("robot.launch.py", None, {}, True),
        ("other.launch.py", None, {}, False),
        ("robot.launch.py", "sim:=true", {"sim": "true"}, True),
        ("robot.launch.py", "sim:=true", {"sim": "false"}, False),
    ],
)
def test_where_a_finding_of_a_launch_file_holds(
    launch: str | None, condition: str | None, arguments: dict[str, str], holds: bool
):
    shown = replace(lesson(), name="robot.launch.py")
    found = finding(at("setup.py", 1), system=launch, condition=condition)
    assert data_of(shown, found, **arguments)["systems"][0]["findings"] == ([0] if holds else [])


def test_groups_are_namespaces_where_nodes_have_several():
    data = data_of(system(node("/arm/a", publisher("x")), node("/leg/b", publisher("x"), subscriber("/arm/x"))))
    groups = {vertex["name"]: vertex["group"] for vertex in data["systems"][0]["vertices"]}
    assert groups == {"/arm/a": "/arm", "/leg/b": "/leg", "/leg/x": "/leg", "/arm/x": ""}


def test_the_title_of_a_system_has_its_arguments():
    shown = replace(lesson(), name="robot.launch.py")
    assert data_of(shown, sim="true")["systems"][0]["title"] == "robot.launch.py  sim:=true"


def test_nothing_to_show():
    [shown] = data_of(system())["systems"]
    assert (shown["vertices"], shown["edges"], shown["drawing"]) == ([], [], None)


@pytest.mark.parametrize(
    ("group", "closed"),
    [(None, ["/arm"]), ("package", ["arm_driver"])],
)
def test_groups_that_are_closed_at_first(group, closed):
    made = system(
        node("/arm/driver", publisher("state"), package="arm_driver"),
        node("/base/driver", publisher("state"), package="base_driver"),
        node("/camera", package="vision"),
    )
    data = page_data(PageContents([PageSystem(made)], group=group, collapse=("*arm*",)))
    assert data["systems"][0]["collapsed"] == closed
