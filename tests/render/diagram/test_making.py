"""The picture as data: what is gathered, grouped, collapsed, and said on the lines between nodes."""

from __future__ import annotations

import pytest

from archlint.render.diagram.ids import ids_of
from archlint.render.view import View
from archlint.ros.qos import Qos
from archlint.systems.model import System
from archlint.systems.nodes import Node
from render.lesson import lesson
from render.pictures import diagram, lines, titles
from systems.builders import action_server, client, node, publisher, service, subscriber, system, timer


def robot() -> System:
    return system(
        node("/arm/driver", publisher("state"), subscriber("goal"), package="arm", launched_by="arm.launch.py"),
        node("/arm/planner", subscriber("state"), publisher("goal"), package="plan", launched_by="arm.launch.py"),
        node("/base/driver", subscriber("/arm/state"), service("stop"), package="base"),
    )


def frames(made: System, **options: object) -> dict[str, set[str]]:
    drawn = diagram(made, View(**options))
    return {title: {key[1] for key, own in drawn.groups.items() if own == title} for title in {*drawn.groups.values()}}


def test_nodes_by_launch_file() -> None:
    assert frames(robot(), group="launch") == {"arm.launch.py": {"/arm/driver", "/arm/planner", "/arm/goal"}}


def test_nodes_by_process() -> None:
    assert frames(robot(), group="process")["base/driver"] == {"/base/driver", "/base/stop"}


def test_a_collapsed_group_says_what_it_holds() -> None:
    drawn = diagram(robot(), View(collapse=("/arm",)))
    box = drawn.shapes["group", "/arm"]
    assert box.label == ("/arm", "2 nodes, 1 topic")
    assert lines(drawn) == {("/arm", "/arm/state"), ("/arm/state", "/arm"), ("/arm/state", "/base/driver")} | {
        ("/base/stop", "/base/driver")
    }
    assert drawn.caption[0] == "3 nodes, 2 topics, 1 service"


def test_nodes_alone_have_the_topics_on_their_lines() -> None:
    drawn = diagram(robot(), View(style="nodes"))
    assert titles(drawn) == {"/arm/driver", "/arm/planner", "/base/driver"}
    assert {(line.tail[1], line.head[1]): line.labels for line in drawn.lines} == {
        ("/arm/driver", "/arm/planner"): ("/arm/state",),
        ("/arm/driver", "/base/driver"): ("/arm/state",),
        ("/arm/planner", "/arm/driver"): ("/arm/goal",),
    }


def test_nodes_alone_ask_each_other_in_the_direction_of_the_request() -> None:
    drawn = diagram(lesson(), View(style="nodes"))
    assert lines(drawn) == {
        ("/control_node", "/sensor_node"),
        ("/control_node", "/motor_node"),
        ("/sensor_node", "/control_node"),
    }


def test_a_topic_of_too_many_pairs_stays_a_shape() -> None:
    crowd = system(*(node(f"/n{n}", publisher("/tf_like"), subscriber("/tf_like")) for n in range(7)))
    assert "/tf_like" in titles(diagram(crowd, View(style="nodes")))


def test_loose_ends_of_a_node_are_listed_in_one_shape() -> None:
    drawn = diagram(system(node("/n", *(publisher(f"/t{n}") for n in range(3)), subscriber("/in"))))
    [ends] = [shape for shape in drawn.shapes.values() if shape.kind == "ends"]
    assert ends.label == ("3 topics", "/t0", "/t1", "/t2")
    assert lines(drawn) == {("/n", "3 topics"), ("/in", "/n")}
    assert drawn.caption[0] == "1 node, 4 topics"


def test_two_loose_ends_stand_for_themselves() -> None:
    assert titles(diagram(system(node("/n", publisher("/a"), publisher("/b"))))) == {"/n", "/a", "/b"}


def test_the_caption_counts_what_is_not_shown() -> None:
    assert diagram(robot(), View(hide=("/base/*",))).caption[0] == ("2 nodes, 2 topics; not shown: 1 node, 1 service")


def test_the_pattern_is_named_with_its_figures() -> None:
    caption = "\n".join(diagram(lesson()).caption)
    assert "pattern: request clusters" in caption
    assert "pairs 1 by topics, 2 by services" in caption


@pytest.mark.parametrize(
    ("qos", "said"),
    [
        (Qos(depth=5), ("/x", "String", "2 Hz · queue 5")),
        (Qos(reliability="best_effort", depth=1), ("/x", "String", "2 Hz · best effort · queue 1")),
        (None, ("/x", "String", "2 Hz")),
    ],
)
def test_a_topic_says_how_often_and_how(qos: Qos | None, said: tuple[str, ...], monkeypatch) -> None:
    made = system(node("/n", publisher("/x", qos=qos), timer(0.5)), node("/m", subscriber("/x")))
    [end] = made.topics["/x"].providers
    monkeypatch.setattr("archlint.render.diagram.parts.rates", lambda _: {id(end.creation): 2.0})
    assert diagram(made).shapes["topic", "/x"].label == said


def test_a_subscription_says_what_it_wants_otherwise() -> None:
    made = system(
        node("/n", publisher("/x")), node("/m", subscriber("/x", qos=Qos(reliability="best_effort", depth=1)))
    )
    assert [line.labels for line in diagram(made).lines] == [(), ("best effort · queue 1",)]


def test_requests_that_lead_in_a_circle() -> None:
    made = system(
        node("/a", client("/s"), service("/t")),
        node("/b", client("/t"), service("/s")),
        node("/c", client("/s"), action_server("/act")),
    )
    drawn = diagram(made)
    assert {line.ends for line in drawn.lines if line.cycle} == {
        (("node", "/a"), ("service", "/s")),
        (("service", "/s"), ("node", "/b")),
        (("node", "/b"), ("service", "/t")),
        (("service", "/t"), ("node", "/a")),
    }


def test_the_centre_of_a_hub_is_marked() -> None:
    made = system(
        node("/mux", *(subscriber(f"/in{n}") for n in range(4))),
        *(node(f"/source{n}", publisher(f"/in{n}")) for n in range(4)),
    )
    remarks = {key[1]: shape.remarks for key, shape in diagram(made).shapes.items() if shape.remarks}
    assert remarks == {"/mux": ("hub: 4 in, 0 out",)}


def test_what_holds_two_parts_together_is_marked() -> None:
    made = system(
        node("/a", publisher("/ab")),
        node("/b", subscriber("/ab"), publisher("/bc")),
        node("/c", subscriber("/bc"), publisher("/cd")),
        node("/d", subscriber("/cd"), publisher("/de")),
        node("/e", subscriber("/de")),
    )
    remarks = {key[1]: shape.remarks for key, shape in diagram(made).shapes.items() if shape.remarks}
    assert remarks == {"/c": ("single point of failure: 2 parts without it",)}


def test_an_id_does_not_depend_on_what_else_is_drawn() -> None:
    before = ids_of([("node", "/b"), ("topic", "/x")])
    after = ids_of([("node", "/a"), ("node", "/b"), ("topic", "/x"), ("topic", "/y")])
    assert before.items() <= after.items()
    assert before["node", "/b"] == "node_b"


def test_ids_are_different_and_harmless() -> None:
    ids = ids_of([("topic", name) for name in ("/a/b", "/a_b", "/A_b", "größe", "end", '"];', "")])
    assert len(set(ids.values())) == 7
    assert all(id.isascii() and id.replace("_", "a").isalnum() for id in ids.values())


def labels(*nodes: Node) -> list[tuple[str, ...]]:
    return [shape.label for key, shape in diagram(system(*nodes)).shapes.items() if key[0] == "node"]


def test_nodes_of_one_name_say_their_packages() -> None:
    namesakes = [node("/driver", package="left"), node("/driver", package="right"), node("/other", package="left")]
    assert labels(*namesakes) == [("/driver", "left"), ("/driver", "right"), ("/other",)]


def test_nodes_of_one_name_and_package_say_their_files() -> None:
    assert labels(*(node("/driver", file=f"src/robot/{name}.py") for name in ("sonar", "lidar"))) == [
        ("/driver", "sonar.py"),
        ("/driver", "lidar.py"),
    ]


def test_nodes_of_one_name_in_files_of_one_name_say_both() -> None:
    namesakes = [
        node("/driver", package=package, file=f"src/{package}/{file}.py")
        for package in ("left", "right")
        for file in ("sonar", "lidar")
    ]
    assert [label[1] for label in labels(*namesakes)] == [
        *("left: sonar.py", "left: lidar.py"),
        *("right: sonar.py", "right: lidar.py"),
    ]


def test_the_same_node_twice_has_nothing_to_tell_it_apart() -> None:
    assert labels(node("/driver"), node("/driver")) == [("/driver",), ("/driver",)]


def test_what_is_grey_and_dashed_is_said() -> None:
    said = "grey and dashed: test code, no node, or a node whose source is not here"
    assert said in " · ".join(diagram(system(node("/mock", test=True), node("/driver"))).caption)
    assert said not in " · ".join(diagram(system(node("/driver"))).caption)


def test_a_neighbour_is_not_taken_for_test_code() -> None:
    assert "grey and dashed" not in " · ".join(diagram(lesson()).caption)
