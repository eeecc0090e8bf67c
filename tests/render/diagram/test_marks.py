"""Findings in a picture: on the line, the topic or the node that they are about."""

from __future__ import annotations

from dataclasses import replace

from archlint.finding import Finding, Related, Severity
from archlint.place import Place
from archlint.render import text
from archlint.render.diagram.model import Diagram
from archlint.render.view import View
from archlint.systems.model import System
from render.pictures import diagram, dot, finding, mermaid
from systems.builders import node, publisher, subscriber, system


def crossing() -> System:
    return system(
        node("/left", publisher("/cmd")),
        node("/right", publisher("/cmd")),
        node("/motor", subscriber("/cmd"), publisher("/state")),
    )


def place_of(made: System, name: str, topic: str) -> Place:
    [place] = [end.place for end in made.endpoints if (end.node.name, end.name) == (name, topic)]
    return place


def badges(drawn: Diagram) -> dict[object, list[str]]:
    shapes = {key[1]: [badge.text for badge in shape.badges] for key, shape in drawn.shapes.items()}
    lines = {(line.tail[1], line.head[1]): [badge.text for badge in line.badges] for line in drawn.lines}
    return {where: codes for where, codes in (*shapes.items(), *lines.items()) if codes}


def test_at_one_end_of_several() -> None:
    made = crossing()
    found = finding("QOS004", place_of(made, "/left", "/cmd"), "/left")
    assert badges(diagram(made, findings=[found])) == {("/left", "/cmd"): ["QOS004"]}


def test_at_what_two_nodes_share() -> None:
    made = crossing()
    found = finding("OWN001", place_of(made, "/left", "/cmd"))
    found = replace(found, related=(Related(place_of(made, "/right", "/cmd"), "so does this"),))
    drawn = diagram(made, findings=[found])
    assert badges(drawn) == {"/cmd": ["OWN001"]}
    assert drawn.shapes["topic", "/cmd"].remarks == ("2 publishers",)


def test_what_is_found_at_several_ends_is_said_once() -> None:
    made = crossing()
    found = [finding("NME001", place_of(made, name, "/cmd"), name) for name in ("/left", "/right")]
    assert badges(diagram(made, findings=found)) == {"/cmd": ["NME001 ×2"]}


def test_in_the_code_of_a_node() -> None:
    made = crossing()
    inside = replace(place_of(made, "/motor", "/cmd"), line=90, end_line=90)
    named, unnamed = finding("SRV003", inside, "/motor"), finding("TMO001", inside)
    assert badges(diagram(made, findings=[named, unnamed])) == {"/motor": ["SRV003", "TMO001"]}


def test_elsewhere_it_is_not_drawn() -> None:
    assert badges(diagram(crossing(), findings=[finding("LCH002", Place("a.launch.py", 1, 1, 1, 9))])) == {}


def test_information_has_no_badge() -> None:
    made = crossing()
    found = finding("GRF001", place_of(made, "/left", "/cmd"), "/left", Severity.INFO)
    assert badges(diagram(made, findings=[found])) == {}


def test_between_nodes_the_badge_is_on_the_line() -> None:
    made = system(node("/a", publisher("/x")), node("/b", subscriber("/x")))
    found = finding("QOS001", place_of(made, "/a", "/x"), "/a")
    assert badges(diagram(made, View(style="nodes"), [found])) == {("/a", "/b"): ["QOS001"]}


def test_a_collapsed_group_counts_its_findings() -> None:
    made = system(node("/arm/a", publisher("x")), node("/arm/b", subscriber("x")), node("/base/c"))
    found: list[Finding] = [finding("SRV003", place_of(made, "/arm/a", "/arm/x"), "/arm/a")]
    box = diagram(made, View(collapse=("/arm",)), found).shapes["group", "/arm"]
    assert box.label == ("/arm", "2 nodes, 1 topic", "1 error")


def test_each_format_has_the_codes() -> None:
    made = crossing()
    found = [finding("SRV003", replace(place_of(made, "/motor", "/cmd"), line=90), "/motor")]
    assert ">SRV003</FONT>" in dot(made, findings=found)
    assert 'node_motor(["/motor<br>✖ SRV003"])' in mermaid(made, findings=found)
    heading = next(line for line in text.render(made, findings=found).splitlines() if line.startswith("/motor"))
    assert heading.endswith("  SRV003")
