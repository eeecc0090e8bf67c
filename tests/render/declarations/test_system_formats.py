"""A launched system as a policy of SROS 2, and as GraphML."""

from __future__ import annotations

import io
from dataclasses import replace

import networkx
import pytest

from archlint.render.declarations import graphml, sros2_policy
from archlint.systems.implicit import with_implicit
from archlint.systems.model import System
from archlint.visible import visible
from render.declarations.formats import POLICY, valid
from render.hostile import NAMES, hostile
from render.lesson import lesson
from systems.builders import action_client, action_server, client, node, partial, publisher, service, subscriber, system

OWN = [
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "get_type_description",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
]


def policy_of(judged: System, distro: str | None = None):
    return sros2_policy.render(with_implicit(judged, distro, of_actions=False))


def allowed(judged: System, distro: str | None = None) -> dict[tuple[str, str], list[str]]:
    """What the only node of a system is allowed: names by what may be done with them."""
    [profile] = valid(policy_of(judged, distro).text, POLICY).iter("profile")
    return {(each.tag, *each.keys()): [name.text for name in each] for each in profile}


def test_a_node_is_allowed_what_it_has_and_what_every_node_has():
    driver = node("/arm/driver", publisher("scan"), subscriber("~/speed"), service("/reset"), client("stop"))
    assert allowed(system(driver)) == {
        ("topics", "publish"): ["/arm/scan", "/parameter_events", "/rosout"],
        ("topics", "subscribe"): ["/arm/driver/speed"],
        ("services", "reply"): sorted(["/reset", *(f"/arm/driver/{name}" for name in OWN)]),
        ("services", "request"): ["/arm/stop"],
    }


def test_humble_has_no_type_descriptions():
    replies = allowed(system(node("/driver", publisher("scan"))), "humble")["services", "reply"]
    assert "/driver/get_type_description" not in replies
    assert len(replies) == 6


def test_actions_are_actions():
    names = allowed(system(node("/arm", action_server("move"), action_client("grip"))))
    assert (names["actions", "execute"], names["actions", "call"]) == (["/move"], ["/grip"])
    assert not any("_action" in name for listed in names.values() for name in listed)


def test_simulated_time_is_a_topic_to_hear():
    driver = replace(node("/driver", publisher("scan")), overrides={"use_sim_time": True})
    assert allowed(system(driver))["topics", "subscribe"] == ["/clock"]


def test_each_process_has_an_enclave():
    root = valid(policy_of(lesson()).text, POLICY)
    assert [enclave.get("path") for enclave in root.iter("enclave")] == ["/control_node", "/motor_node", "/sensor_node"]
    assert [(p.get("ns"), p.get("node")) for p in root.iter("profile")] == [
        ("/", "control_node"),
        ("/", "motor_node"),
        ("/", "sensor_node"),
    ]


def test_nodes_of_one_process_share_its_enclave():
    both = [
        replace(node(name, publisher("scan"), package="robot"), executable="driver") for name in ("/right", "/left")
    ]
    [enclave] = valid(policy_of(system(*both)).text, POLICY).iter("enclave")
    assert enclave.get("path") == "/left"
    assert [profile.get("node") for profile in enclave.iter("profile")] == ["left", "right"]


def test_what_is_not_known_is_denied_and_said_to_be():
    answer = policy_of(
        system(
            node("/driver", publisher(partial("camera_*", "it depends on data"))),
            replace(node("/bag"), blueprint=None, external=True, executable="bag"),
        )
    )
    assert "camera_" not in answer.text.partition("<policy")[2]
    assert "/bag" not in answer.text.partition("<policy")[2]
    assert sorted(answer.left_out)[0] == "/bag: its source is not in this workspace"
    assert sorted(answer.left_out)[1].endswith(": it depends on data")
    assert answer.text.count("<!-- left out, and so denied: ") == len(answer.left_out) == 2


def test_the_policy_of_hostile_names_is_valid():
    valid(policy_of(hostile()).text, POLICY)


def read(text: str) -> networkx.MultiDiGraph:
    return networkx.read_graphml(io.BytesIO(text.encode()), force_multigraph=True)


def test_graphml_is_what_networkx_reads():
    graph = read(graphml.render(lesson()))
    assert graph.nodes["node:/sensor_node"]["package"] == "my_first_package"
    assert graph.nodes["topic:/sensor_data"]["types"] == "my_robot_interfaces/msg/SensorReading"
    assert {(tail, head) for tail, head in graph.edges()} == {
        ("node:/sensor_node", "topic:/sensor_data"),
        ("topic:/sensor_data", "node:/control_node"),
        ("node:/control_node", "service:/query_sensor"),
        ("service:/query_sensor", "node:/sensor_node"),
        ("node:/control_node", "service:/set_motor"),
        ("service:/set_motor", "node:/motor_node"),
    }
    [edge] = graph.get_edge_data("node:/sensor_node", "topic:/sensor_data").values()
    assert (edge["kind"], edge["qos"]) == ("publisher", "reliable, volatile, keep last 10")


@pytest.mark.parametrize("number", range(len(NAMES)))
def test_graphml_of_names_that_try_to_be_more_than_names(number):
    packages = networkx.get_node_attributes(read(graphml.render(hostile())), "package")
    assert packages[f"node:/n{number}"] == visible(NAMES[number])
