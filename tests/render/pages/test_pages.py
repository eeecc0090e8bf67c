"""The pages of a workspace, read as GitHub reads them."""

from __future__ import annotations

import posixpath
import re
from dataclasses import replace

import pytest

from archlint.model import NodeClass, ParameterDescription
from archlint.render.pages import MARK, pages
from archlint.ros.qos import Qos
from archlint.visible import visible
from render.hostile import NAMES, hostile
from render.lesson import lesson
from render.reading_markdown import headings, html_in, links_in, table_under, tables
from systems.builders import client, from_parameter, node, parameter, partial, publisher, subscriber, system, unknown


def only_node(*entities, **options):
    """The page of a node with some entities."""
    written = pages([system(node("/driver", *entities, package="robot", **options))], [], "../..")
    return written["nodes/robot.driver.md"]


def test_the_pages_of_the_lesson():
    launched = replace(lesson(), name="src/my_first_package/launch/robot.launch.py")
    written = pages([lesson()], [launched], "..")
    assert [*written] == [
        "README.md",
        "nodes/my_first_package.control_node.md",
        "nodes/my_first_package.motor_node.md",
        "nodes/my_first_package.sensor_node.md",
        "systems/robot.launch.py.md",
    ]
    assert all(text.startswith(f"{MARK}\n\n# ") and text.endswith("\n") for text in written.values())


def test_links_lead_from_page_to_page():
    launched = replace(lesson(), name="src/my_first_package/launch/robot.launch.py")
    written = pages([lesson()], [launched], "..")
    for page, text in written.items():
        inside = [link for link in links_in(text) if link.endswith(".md")]
        assert {posixpath.normpath(posixpath.join(posixpath.dirname(page), link)) for link in inside} <= written.keys()
    assert "systems/robot.launch.py.md" in links_in(written["README.md"])


def test_links_to_sources_start_at_the_page():
    text = only_node(publisher("scan"))
    file = node("/driver", publisher("scan"), package="robot").blueprint.place.file
    assert f"../../../{file}#L1" in [link.rpartition("#")[0] + "#L1" for link in links_in(text)]


def test_a_topic_with_type_qos_and_callback():
    text = only_node(subscriber("scan", "sensor_msgs/msg/LaserScan", callback="on_scan", qos=Qos(depth=5)))
    [[topic, type_, qos, callback, source]] = table_under(text, "Subscribes to")
    assert (topic, type_, qos) == ("/scan", "sensor_msgs/msg/LaserScan", "reliable, volatile, keep last 5")
    assert callback.endswith("on_scan")
    assert source.partition(":")[2].isdecimal()


def test_what_is_not_known_is_said_with_the_reason():
    text = only_node(
        publisher(unknown("it is read from a file")),
        publisher(partial("camera_*", "it depends on data")),
        publisher(from_parameter("topic", "out")),
    )
    names = [row[0] for row in table_under(text, "Publishes")]
    assert names == [
        "/camera_*; * is known only at run time: it depends on data",
        "/out; from parameter topic",
        "not known: it is read from a file",
    ]


def test_a_parameter_with_what_its_descriptor_says():
    described = ParameterDescription("How often | when", "a multiple", True, 0.1, 50.0, 0.1)
    text = only_node(parameter("rate", 2.0, "double", description=described))
    [row] = table_under(text, "Parameters")
    assert row[:5] == ["rate; read-only", "double", "2.0", "0.1 to 50, step 0.1", "How often | when (a multiple)"]


def test_defaults_that_are_empty_or_missing():
    text = only_node(
        parameter("empty", "", "string"),
        parameter("none", type="integer", known=False, without_default=True),
        parameter("computed", type="integer", known=False),
    )
    assert [row[:3] for row in table_under(text, "Parameters")] == [
        ["computed", "integer", "not known"],
        ["empty", "string", '""'],
        ["none", "integer", "none"],
    ]


def test_the_docstring_of_the_class_is_the_first_thing_to_read():
    driver = node("/driver", publisher("scan"), package="robot")
    blueprint = driver.blueprint
    blueprint.classes = (NodeClass(blueprint.place, blueprint.class_name, docstring="Drives.\n\nSlowly."),)
    written = pages([system(driver)], [], ".")
    assert written["nodes/robot.driver.md"].split("\n\n")[1:4] == ["# /driver", "Drives.", "Slowly."]
    [titles, row] = tables(written["README.md"])[0]
    assert dict(zip(titles, row, strict=True))["What it is"] == "Drives."


def test_what_a_node_needs_and_who_offers_it():
    control = pages([lesson()], [], ".")["nodes/my_first_package.control_node.md"]
    assert table_under(control, "Needs") == [
        ["service /query_sensor", "/sensor_node"],
        ["service /set_motor", "/motor_node"],
        ["topic /sensor_data", "/sensor_node"],
    ]


def test_nobody_offers_what_a_node_needs():
    assert table_under(only_node(client("reset")), "Needs") == [
        ["service /reset", "no node of this workspace, under this name"]
    ]


def test_test_code_has_no_page():
    written = pages([system(node("/driver", publisher("scan"), test=True))], [], ".")
    assert [*written] == ["README.md"]


def test_a_system_has_its_picture_and_its_connections():
    launched = replace(lesson(), name="robot.launch.py")
    text = pages([], [launched], ".")["systems/robot.launch.py.md"]
    assert re.search(r"\n```mermaid\n%%.*\nflowchart LR\n", text)
    assert [row[0] for row in table_under(text, "Nodes")] == ["/control_node", "/motor_node", "/sensor_node"]
    assert [row[0] for row in table_under(text, "Services")] == ["/query_sensor", "/set_motor"]


def test_a_launch_file_alone_has_pages_of_its_nodes_with_what_they_need():
    control = pages([], [replace(lesson(), name="robot.launch.py")], ".")["nodes/my_first_package.control_node.md"]
    assert table_under(control, "Needs")[0] == ["service /query_sensor", "/sensor_node"]


def test_a_large_system_has_several_pictures(monkeypatch):
    monkeypatch.setattr("archlint.render.mermaid.EDGE_LIMIT", 20)
    nodes = [
        node(f"/{name}/n{number}", *(publisher(f"t{number * i}") for i in range(9)), subscriber("t0"))
        for name in ("left", "right")
        for number in range(4)
    ]
    text = pages([], [system(*nodes, name="robot.launch.py")], ".")["systems/robot.launch.py.md"]
    drawn = text.partition("## Picture")[2].partition("## Nodes")[0]
    assert drawn.count("```mermaid") > 1


def test_a_topic_that_carries_nothing_says_why():
    best_effort = Qos(reliability="best_effort")
    ends = [node("/camera", publisher("scan", qos=best_effort)), node("/driver", subscriber("scan", qos=Qos()))]
    text = pages([], [system(*ends, name="robot.launch.py")], ".")["systems/robot.launch.py.md"]
    [[*_, note]] = table_under(text, "Topics")
    assert note == "no message gets from /camera to /driver: best effort offered, reliable requested"


def test_pages_that_would_have_one_name():
    nodes = [node(name, publisher("scan"), package="robot") for name in ("/a/driver", "/b/driver", "/c/Driver")]
    written = pages([system(*nodes)], [], ".")
    names = [page for page in written if page.startswith("nodes/")]
    assert len(names) == len({name.casefold() for name in names}) == 3


@pytest.mark.parametrize("number", range(len(NAMES)))
def test_names_that_try_to_be_more_than_names(number):
    written = pages([hostile()], [replace(hostile(), name=f"launch/{NAMES[number]}.launch.py")], ".")
    package, name = visible(NAMES[number]), f"/n{number}"
    pages_about = [text for text in written.values() if name in headings(text)]
    assert len(pages_about) == 1
    for text in written.values():
        assert all(html == f"{MARK}\n" or html == "<br>" for html in html_in(text))
    [[topic, type_, *_]] = table_under(pages_about[0], "Publishes")
    assert type_ == package
    assert package in topic or "refused by ROS" in topic


def test_the_same_system_gives_the_same_bytes():
    assert pages([hostile()], [lesson()], "..") == pages([hostile()], [lesson()], "..")
