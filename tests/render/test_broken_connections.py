"""A connection that quality of service keeps from ever carrying a message looks broken in every format."""

from __future__ import annotations

import json

import pytest

from archlint.render import json as graph_json
from archlint.render import text
from archlint.render.html import render as html
from archlint.render.picture import broken_ends
from archlint.render.view import View
from archlint.ros.qos import Qos
from archlint.systems.model import System
from render.pictures import diagram, dot, mermaid, parsed, svg, words
from systems.builders import client, node, publisher, service, subscriber, system

BEST_EFFORT = Qos(reliability="best_effort")
RELIABLE = Qos()
REASON = "best effort offered, reliable requested"


def scan(publishing: Qos = BEST_EFFORT, listening: Qos = RELIABLE) -> System:
    return system(
        node("/lidar", publisher("/scan", "sensor_msgs/msg/LaserScan", publishing)),
        node("/mapper", subscriber("/scan", "sensor_msgs/msg/LaserScan", listening)),
    )


def test_json_lists_the_pair_and_the_reason() -> None:
    [topic] = json.loads(graph_json.render(scan()))["topics"]
    assert topic["undelivered"] == [{"publisher": "/lidar", "subscriber": "/mapper", "reason": REASON}]


def test_text_says_it_under_the_topic() -> None:
    assert f"no message from /lidar reaches /mapper: {REASON}" in text.render(scan())


def test_dot_draws_both_ends_red_with_the_reason() -> None:
    graph = parsed(scan())
    lines = [edge.attr for edge in graph.edges()]
    assert [(line["color"], line["style"], line["arrowhead"]) for line in lines] == [("#b91c1c", "dashed", "none")] * 2
    assert all(words(line["label"]) == ["✕ best effort offered", "reliable requested"] for line in lines)
    assert "red and crossed out" in graph.graph_attr["label"]


def test_mermaid_crosses_it_out_in_red() -> None:
    drawn = mermaid(scan())
    assert drawn.count(f'--x|"{REASON}"|') == 2
    assert "linkStyle 0,1 stroke:#b91c1c" in drawn


def test_a_picture_carries_the_colour_and_the_words() -> None:
    drawn = svg(scan())
    assert "#b91c1c" in drawn
    assert REASON in drawn


def test_a_page_has_the_words() -> None:
    assert f'"broken":"{REASON}"' in html(scan())
    assert '"broken"' not in html(scan(listening=BEST_EFFORT))


@pytest.mark.parametrize("show", [text.render, dot, mermaid, svg])
@pytest.mark.parametrize(
    "listening",
    [BEST_EFFORT, Qos(reliability=None), Qos(reliability="system_default")],
    ids=["fits", "not known", "left to the middleware"],
)
def test_what_works_or_is_not_known_is_drawn_whole(show, listening: Qos) -> None:
    drawn = show(scan(listening=listening))
    assert "no message gets" not in drawn
    assert "#b91c1c" not in drawn


def test_one_bad_publisher_of_several_is_the_broken_end() -> None:
    made = system(
        node("/good", publisher("/scan", qos=RELIABLE)),
        node("/bad", publisher("/scan", qos=BEST_EFFORT)),
        node("/mapper", subscriber("/scan", qos=RELIABLE)),
    )
    broken = broken_ends(made)
    assert [end.node.name for end in made.endpoints if id(end) in broken] == ["/bad"]


def test_one_demanding_subscription_of_several_is_the_broken_end() -> None:
    made = system(
        node("/lidar", publisher("/scan", qos=BEST_EFFORT)),
        node("/modest", subscriber("/scan", qos=BEST_EFFORT)),
        node("/strict", subscriber("/scan", qos=RELIABLE)),
    )
    broken = broken_ends(made)
    assert [end.node.name for end in made.endpoints if id(end) in broken] == ["/strict"]


STRING, INT = "std_msgs/msg/String", "std_msgs/msg/Int32"


def test_ends_of_different_types_are_broken_too() -> None:
    made = system(node("/talker", publisher("/chat", STRING)), node("/listener", subscriber("/chat", INT)))
    assert [line.broken for line in diagram(made).lines] == ["String published, Int32 subscribed"] * 2
    assert "no message from /talker reaches /listener: String published, Int32 subscribed" in text.render(made)


def test_and_so_are_those_of_services() -> None:
    made = system(
        node("/asker", client("/ask", "std_srvs/srv/Trigger")), node("/oracle", service("/ask", "std_srvs/srv/Empty"))
    )
    assert [line.broken for line in diagram(made).lines] == ["Empty served, Trigger called"] * 2
    assert "no request from /asker reaches /oracle: Empty served, Trigger called" in text.render(made)


def test_full_types_where_the_short_ones_are_the_same() -> None:
    made = system(node("/a", publisher("/x", "p/msg/A")), node("/b", subscriber("/x", "q/msg/A")))
    assert {line.broken for line in diagram(made).lines} == {"p/msg/A published, q/msg/A subscribed"}


def test_ends_that_have_another_partner_are_not_broken_and_say_whom_they_miss() -> None:
    made = system(
        node("/best", publisher("/scan", qos=BEST_EFFORT)),
        node("/sure", publisher("/scan", qos=RELIABLE)),
        node("/modest", subscriber("/scan", qos=BEST_EFFORT)),
        node("/strict", subscriber("/scan", qos=RELIABLE)),
    )
    lines = {(line.tail[1], line.head[1]): line for line in diagram(made).lines}
    assert {line.broken for line in lines.values()} == {""}
    assert lines["/best", "/scan"].held_back == (f"not to /strict: {REASON}",)
    assert lines["/scan", "/strict"].held_back == (f"not from /best: {REASON}",)
    assert lines["/sure", "/scan"].held_back == ()


def test_between_nodes_only_the_pair_is_broken() -> None:
    made = system(
        node("/best", publisher("/scan", qos=BEST_EFFORT)),
        node("/sure", publisher("/scan", qos=RELIABLE)),
        node("/strict", subscriber("/scan", qos=RELIABLE)),
    )
    lines = {(line.tail[1], line.head[1]): line.broken for line in diagram(made, View(style="nodes")).lines}
    assert lines == {("/best", "/strict"): REASON, ("/sure", "/strict"): ""}
