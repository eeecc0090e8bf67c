from __future__ import annotations

import re

import pytest

from archlint.render.mermaid import escape, render
from render.hostile import hostile
from render.lesson import lesson
from systems.builders import client, node, publisher, subscriber, system

LESSON = """\
flowchart LR
  n0(["/control_node"])
  n1(["/motor_node"])
  n2(["/sensor_node"])
  n3{{"/query_sensor<br>GetSensorData"}}
  n4{{"/set_motor<br>SetMotorSpeed"}}
  n5["/sensor_data<br>SensorReading"]
  n0 --> n3
  n0 --> n4
  n2 --> n5
  n3 --> n2
  n4 --> n1
  n5 --> n0
"""


def test_the_lesson() -> None:
    assert render(lesson()).startswith(LESSON)


def test_colours_by_kind() -> None:
    shown = render(lesson())
    assert "  class n0,n1,n2 node\n" in shown
    assert "  class n3,n4 service\n" in shown


def test_what_has_no_other_end_is_dotted() -> None:
    shown = render(system(node("/a", publisher("/x"), client("/s")), node("/b", subscriber("/x"))))
    assert "  n0 --> n3\n" in shown  # /a publishes /x
    assert "  n0 -.-> n2\n" in shown  # nobody serves /s


def test_packages_are_subgraphs() -> None:
    shown = render(system(node("/a", package="p"), node("/b", package="q")))
    assert '  subgraph g0["p"]\n    n0(["/a"])\n  end\n' in shown


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
    label = r'"[^"]*"'
    vertex = rf"n\d+(\(\[{label}\]\)|\[{label}\]|\{{\{{{label}\}}\}})"
    edge = r"n\d+ (-->|-\.->) n\d+"
    style = r"classDef \w+ [\w:#,]+|class [n\d,]+ \w+"
    statement = rf"flowchart LR|{vertex}|{edge}|subgraph g\d+\[{label}\]|end|{style}"
    assert all(re.fullmatch(statement, line.strip()) for line in render(hostile()).splitlines())


def test_more_edges_than_mermaid_draws() -> None:
    crowd = system(*(node(f"/n{number}", publisher(f"/t{number}")) for number in range(501)))
    assert render(crowd).startswith("%% 501 edges, and Mermaid draws 500: ")
    assert not render(lesson()).startswith("%%")


def test_more_text_than_mermaid_reads() -> None:
    wordy = system(*(node(f"/{'n' * 200}{number}", publisher("/" + "t" * 200)) for number in range(250)))
    assert re.match(r"%% \d+ characters, and Mermaid reads 50000: ", render(wordy))
