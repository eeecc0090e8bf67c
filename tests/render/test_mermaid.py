from __future__ import annotations

import re

import pytest

from archlint.render.diagram.model import Diagram
from archlint.render.mermaid import escape, fits, markdown
from archlint.render.view import View
from archlint.systems.model import System
from render.hostile import hostile
from render.lesson import lesson
from render.pictures import diagram
from render.pictures import mermaid as render
from systems.builders import client, node, publisher, subscriber, system

SETTINGS = '%%{init: {"flowchart": {"wrappingWidth": 800}}}%%'
LESSON = (
    f"{SETTINGS}\n"
    + """\
flowchart LR
  node_control_node(["/control_node"])
  node_motor_node(["/motor_node"])
  node_sensor_node(["/sensor_node"])
  service_query_sensor{{"/query_sensor<br>GetSensorData"}}
  service_set_motor{{"/set_motor<br>SetMotorSpeed"}}
  topic_sensor_data["/sensor_data<br>SensorReading<br>queue 10"]
  node_control_node --> service_query_sensor
  node_control_node --> service_set_motor
  node_sensor_node --> topic_sensor_data
  service_query_sensor --> node_sensor_node
  service_set_motor --> node_motor_node
  topic_sensor_data --> node_control_node
"""
)


def test_the_lesson() -> None:
    assert render(lesson()).startswith(LESSON)


def test_colours_by_kind() -> None:
    shown = render(lesson())
    assert "  class node_control_node,node_motor_node,node_sensor_node node\n" in shown
    assert "  class service_query_sensor,service_set_motor service\n" in shown


def test_what_has_no_other_end_is_dotted() -> None:
    shown = render(system(node("/a", publisher("/x"), client("/s")), node("/b", subscriber("/x"))))
    assert "  node_a --> topic_x\n" in shown  # /a publishes /x
    assert "  node_a -.-> service_s\n" in shown  # nobody serves /s


def test_packages_are_subgraphs() -> None:
    shown = render(system(node("/a", package="p"), node("/b", package="q")))
    assert '  subgraph g0["p"]\n    node_a(["/a"])\n  end\n' in shown


@pytest.mark.parametrize(
    ("text", "escaped"),
    [
        ('a"b', "a#quot;b"),
        ("#quot;", "#35;quot;"),
        ("<b>", "#lt;b#gt;"),
        ("&", "#amp;"),
        ("`", "#96;"),
        ("a\nb", "a<br>b"),
        ("\x1b", "␛"),
    ],
)
def test_escaping(text: str, escaped: str) -> None:
    assert escape(text) == escaped


def test_no_name_leaves_its_label() -> None:
    label, id = r'"[^"]*"', r"(?:(?:node|topic)_[A-Za-z0-9_]*|caption)"
    vertex = rf"{id}(\(\[{label}\]\)|\[{label}\]|\{{\{{{label}\}}\}})"
    edge = rf"{id} (-->|-\.->) {id}"
    style = rf"classDef \w+ [\w:#,-]+|class {id}(,{id})* \w+"
    statement = rf"{re.escape(SETTINGS)}|flowchart LR|{vertex}|{edge}|subgraph g\d+\[{label}\]|end|{style}"
    assert [
        line for line in render(hostile()).splitlines() if not re.fullmatch(statement, line.strip(), re.ASCII)
    ] == []


def crowd(nodes: int) -> System:
    """Nodes of two packages, each with a line to a topic that eight of a package have."""
    return system(
        *(
            node(f"/n{number}", publisher(f"/p{number % 2}/t{number // 16}"), package=f"p{number % 2}")
            for number in range(nodes)
        )
    )


def each_of(made: System) -> Diagram:
    return diagram(made, View(expand=("*",), every_line=True))


def test_what_is_too_large_shows_its_groups() -> None:
    drawn = render(crowd(501), View(expand=("*",), every_line=True))
    assert drawn.startswith("%% too large for Mermaid: these are the groups; --format markdown draws each\n")
    assert '[("p0<br>251 nodes, 32 topics")]' in drawn
    assert "/n17" not in drawn
    assert "too large" not in render(lesson())


def test_markdown_is_split_where_one_chart_is_too_large() -> None:
    pages = re.findall(r"### ([^\n]*)\n\n```mermaid\n(.*?)```", markdown(each_of(crowd(1100))), re.DOTALL)
    assert [title for title, _ in pages] == [
        "All groups",
        *("p0 (1 of 2)", "p0 (2 of 2)"),
        *("p1 (1 of 2)", "p1 (2 of 2)"),
    ]
    assert all(fits(chart) for _, chart in pages)
    drawn = [re.findall(r'\(\["(/n\d+)"\]\)', chart) for _, chart in pages]
    assert sorted(name for names in drawn for name in names) == sorted(f"/n{number}" for number in range(1100))


def test_markdown_of_what_fits_is_one_chart() -> None:
    assert markdown(diagram(lesson())) == f"```mermaid\n{render(lesson())}```\n"


def test_a_title_is_no_markup() -> None:
    hostile_groups = system(
        *(node(f"/n{number}", publisher(f"/t{number}"), package=f"<b>`{number % 2}#") for number in range(501))
    )
    assert "### &lt;b>\\`0\\#\n" in markdown(each_of(hostile_groups))
