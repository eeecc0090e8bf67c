from __future__ import annotations

import subprocess
import sys

from archlint.systems.graph import to_networkx
from systems.builders import (
    action_client,
    client,
    node,
    partial,
    publisher,
    service,
    subscriber,
    system,
    unknown,
)


def test_edges_run_with_the_data() -> None:
    graph = to_networkx(system(node("/talker", publisher("/x")), node("/listener", subscriber("/x"))))
    assert list(graph.edges()) == [
        (("node", "/talker"), ("topic", "/x")),
        (("topic", "/x"), ("node", "/listener")),
    ]


def test_edges_run_with_the_request() -> None:
    graph = to_networkx(system(node("/asks", client("/s")), node("/answers", service("/s"))))
    assert list(graph.edges()) == [
        (("node", "/asks"), ("service", "/s")),
        (("service", "/s"), ("node", "/answers")),
    ]


def test_two_publishers_of_one_node_are_two_edges() -> None:
    graph = to_networkx(system(node("/n", publisher("/x"), publisher("/x", "std_msgs/msg/Int32"))))
    edges = graph.edges[("node", "/n"), ("topic", "/x"), 0], graph.edges[("node", "/n"), ("topic", "/x"), 1]
    assert {edge["type"] for edge in edges} == {"std_msgs/msg/String", "std_msgs/msg/Int32"}


def test_a_topic_and_a_service_of_one_name_are_two_vertices() -> None:
    graph = to_networkx(system(node("/x", publisher("/x"), client("/x"), action_client("/x"))))
    assert set(graph.nodes) == {("node", "/x"), ("topic", "/x"), ("service", "/x"), ("action", "/x")}


def test_nodes_of_one_name_stay_two() -> None:
    graph = to_networkx(system(node("/n"), node("/n", class_name="Other")))
    assert list(graph.nodes) == [("node", "/n"), ("node", "/n #2")]


def test_what_is_not_known_has_a_vertex_of_its_own() -> None:
    graph = to_networkx(system(node("/n", publisher(unknown()), publisher(unknown()))))
    assert [data["name"] for _, data in graph.nodes(data=True)] == ["/n", None, None]


def test_vertices_tell_what_is_at_their_ends() -> None:
    graph = to_networkx(
        system(
            node("/a", publisher("/used"), publisher("/unused"), publisher(partial("arm_*"))),
            node("/b", subscriber("/used", "std_msgs/msg/Int32")),
        )
    )
    assert graph.nodes["topic", "/used"]["matched"]
    assert graph.nodes["topic", "/used"]["types"] == ["std_msgs/msg/Int32", "std_msgs/msg/String"]
    assert not graph.nodes["topic", "/unused"]["matched"]
    assert graph.nodes["topic", "/arm_*"]["resolution"] == "partial"


def test_parameter_services_of_a_node_answer_its_clients() -> None:
    names = ("/server/get_parameters", "/elsewhere/get_parameters")
    graph = to_networkx(system(node("/server"), node("/asks", *map(client, names))))
    assert [graph.nodes["service", name]["matched"] for name in names] == [True, False]


def test_networkx_is_loaded_only_when_a_graph_is_made() -> None:
    code = "import sys, archlint.systems.graph, archlint.render.dot; sys.exit('networkx' in sys.modules)"
    path = [entry for entry in sys.path if entry]
    subprocess.run([sys.executable, "-c", f"import sys; sys.path[:0] = {path!r}; {code}"], check=True)
