from __future__ import annotations

import re

import pygraphviz
import pytest

from archlint.render.dot import escape, quote
from render.hostile import NAMES, hostile
from render.lesson import lesson
from render.pictures import dot as render
from render.pictures import parsed, words
from systems.builders import action_server, client, node, partial, publisher, service, subscriber, system


def vertex(graph: pygraphviz.AGraph, label: str) -> pygraphviz.Node:
    [found] = [graph.get_node(n) for n in graph.nodes() if shown(graph, n)[0] == label]
    return found


def shown(graph: pygraphviz.AGraph, name: str) -> list[str]:
    """What is written in a shape, line by line."""
    return words(graph.get_node(name).attr["label"])


def line(graph: pygraphviz.AGraph, tail: str, head: str) -> pygraphviz.Edge:
    return graph.get_edge(vertex(graph, tail), vertex(graph, head))


def test_the_lesson_has_each_node_interface_and_edge() -> None:
    graph = parsed(lesson())
    assert sorted(shown(graph, n) for n in graph.nodes()) == [
        ["/control_node"],
        ["/motor_node"],
        ["/query_sensor", "GetSensorData"],
        ["/sensor_data", "SensorReading", "queue 10"],
        ["/sensor_node"],
        ["/set_motor", "SetMotorSpeed"],
    ]
    assert len(graph.edges()) == 6


def test_kinds_differ_in_shape_and_not_in_colour_alone() -> None:
    made = system(node("/n", publisher("/t"), service("/s"), action_server("/a")))
    graph = parsed(made)
    shapes = [vertex(graph, label).attr["shape"] for label in ("/n", "/t", "/s", "/a")]
    assert len({*shapes}) == 4 - 1  # nodes are boxes too, rounded ones
    assert "rounded" in vertex(graph, "/n").attr["style"]
    assert "rounded" not in vertex(graph, "/t").attr["style"]


def test_an_end_that_nobody_holds_is_dashed() -> None:
    graph = parsed(system(node("/a", publisher("/used"), publisher("/unused")), node("/b", subscriber("/used"))))
    assert "dashed" in vertex(graph, "/unused").attr["style"]
    assert "dashed" not in vertex(graph, "/used").attr["style"]
    assert line(graph, "/a", "/unused").attr["style"] == "dashed"
    assert line(graph, "/a", "/used").attr["style"] == "solid"
    assert "a dashed topic, service or action: nothing at the other end" in graph.graph_attr["label"]


def test_a_conditional_endpoint_is_dotted() -> None:
    graph = parsed(system(node("/a", client("/s", conditional=True)), node("/b", service("/s"))))
    assert line(graph, "/a", "/s").attr["style"] == "dotted"
    assert line(graph, "/s", "/b").attr["style"] == "solid"


def test_edges_tell_where_they_come_from() -> None:
    graph = parsed(lesson())
    tooltip = line(graph, "/sensor_node", "/sensor_data").attr["tooltip"]
    assert "publisher, src/my_first_package/my_first_package/sensor_node.py:10" in tooltip
    assert "reliable, volatile, keep last 10" in tooltip


def test_several_endpoints_between_two_vertices_are_one_line() -> None:
    graph = parsed(system(node("/n", publisher("/x"), publisher("/x", "std_msgs/msg/Int32"))))
    assert len(graph.edges()) == 1
    assert line(graph, "/n", "/x").attr["tooltip"].count("publisher") == 2


def test_types_that_differ_stand_out() -> None:
    graph = parsed(system(node("/a", publisher("/x", "p/msg/A")), node("/b", subscriber("/x", "p/msg/B"))))
    wrong = vertex(graph, "/x")
    assert shown(graph, wrong)[:2] == ["/x", "A ≠ B"]
    assert wrong.attr["color"] == "#b91c1c"


def test_types_of_one_name_are_told_apart_by_their_packages() -> None:
    graph = parsed(system(node("/a", publisher("/x", "p/msg/A")), node("/b", subscriber("/x", "q/msg/A"))))
    assert shown(graph, vertex(graph, "/x"))[:2] == ["/x", "p/msg/A ≠ q/msg/A"]


def clusters(graph: pygraphviz.AGraph) -> dict[str, list[str]]:
    return {
        part.graph_attr["label"]: sorted(words(part.get_node(n).attr["label"])[0] for n in part.nodes())
        for part in graph.subgraphs()
    }


def test_namespaces_are_frames() -> None:
    made = system(
        node("/arm/driver", publisher("state"), publisher("/joints")),
        node("/arm/planner", subscriber("state")),
        node("/base/driver", subscriber("/joints")),
    )
    assert clusters(parsed(made)) == {
        "/arm": ["/arm/driver", "/arm/planner", "/arm/state"],
        "/base": ["/base/driver"],
    }


def test_packages_are_frames_where_all_nodes_share_a_namespace() -> None:
    made = system(node("/a", publisher("/x"), package="p"), node("/b", subscriber("/x"), package="q"))
    assert clusters(parsed(made)) == {"p": ["/a"], "q": ["/b"]}


def test_one_package_needs_no_frame() -> None:
    assert clusters(parsed(lesson())) == {}


def test_test_code_stands_aside() -> None:
    graph = parsed(system(node("/probe", test=True)))
    assert vertex(graph, "/probe").attr["fillcolor"] == "#ffffff"


@pytest.mark.parametrize(
    ("text", "quoted"),
    [
        ("plain", '"plain"'),
        ('a"b', '"a\\"b"'),
        ("a\\", '"a\\\\"'),
        ("a\nb", '"a\\nb"'),
        ("<b>", '"<b>"'),
        ("&lt;", '"&amp;lt;"'),
        ("\x1b", '"␛"'),
    ],
)
def test_quoting(text: str, quoted: str) -> None:
    assert quote(text) == quoted


@pytest.mark.parametrize(
    ("text", "escaped"),
    [("<b>", "&lt;b&gt;"), ("&lt;", "&amp;lt;"), ('a"b', "a&quot;b"), ("\x1b", "␛"), ("]]>", "&#93;&#93;&gt;")],
)
def test_escaping(text: str, escaped: str) -> None:
    assert escape(text) == escaped


def test_no_name_leaves_its_quotes() -> None:
    graph = parsed(hostile())
    nodes = [n for n in graph.nodes() if re.fullmatch(r"/n\d+", shown(graph, n)[0])]
    assert len(nodes) == len(NAMES)
    assert all(re.fullmatch(r"(node|topic)_\w*", n, re.ASCII) for n in graph.nodes())
    assert not graph.has_node("evil")


def test_each_line_is_one_of_ours() -> None:
    id = r"(?:node|topic)_[A-Za-z0-9_]*"
    statement = rf"(graph|node|edge|{id}( -> {id})?) \[.*\];|subgraph cluster_\w* \{{|\}}"
    opening, *lines, closing = render(hostile()).splitlines()
    assert (opening, closing) == ("digraph archlint {", "}")
    assert all(re.fullmatch(statement, text.strip()) for text in lines)


def test_the_same_system_is_the_same_text() -> None:
    assert render(lesson()) == render(lesson())


def test_a_pattern_keeps_its_hole() -> None:
    graph = parsed(system(node("/n", publisher(partial("arm_*/state")))))
    assert vertex(graph, "/arm_*/state").attr["style"] == "filled,dashed"
    assert "*: known only at run time" in graph.graph_attr["label"]
