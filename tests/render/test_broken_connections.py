"""A connection that quality of service keeps from ever carrying a message looks broken in every format."""

from __future__ import annotations

import json

import pygraphviz
import pytest

from archlint.render import dot, mermaid, text
from archlint.render import json as graph_json
from archlint.render.drawing import svg
from archlint.render.html import render as html
from archlint.render.picture import broken_ends
from archlint.ros.qos import Qos
from archlint.systems.model import System
from systems.builders import node, publisher, subscriber, system

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
    graph = pygraphviz.AGraph(string=dot.render(scan()))
    lines = [edge.attr for edge in graph.edges()]
    assert [(line["color"], line["style"], line["arrowhead"]) for line in lines] == [("#b91c1c", "dashed", "none")] * 2
    assert all(REASON in line["label"] for line in lines)
    assert "red and crossed out" in graph.graph_attr["label"]


def test_mermaid_crosses_it_out_in_red() -> None:
    drawn = mermaid.render(scan())
    assert drawn.count(f'--x|"{REASON}"|') == 2
    assert "linkStyle 0,1 stroke:#b91c1c" in drawn


@pytest.mark.parametrize("show", [svg, html])
def test_pictures_carry_the_colour_and_the_words(show) -> None:
    drawn = show(scan())
    assert "#b91c1c" in drawn
    assert REASON in drawn


@pytest.mark.parametrize("show", [text.render, dot.render, mermaid.render, svg, html])
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
