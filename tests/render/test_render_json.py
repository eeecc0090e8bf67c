from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest

from archlint.model import Group
from archlint.render.json import document, render
from archlint.ros.qos import Qos
from archlint.syntax.parameter_files import NotKnown
from render.hostile import hostile
from render.lesson import lesson
from systems.builders import (
    action_client,
    action_server,
    blueprint,
    client,
    from_parameter,
    node,
    parameter,
    partial,
    place,
    publisher,
    service,
    subscriber,
    system,
    timer,
    unknown,
)


def first(document_: dict, kind: str) -> dict:
    return document_["nodes"][0][kind][0]


def test_the_lesson() -> None:
    told = json.loads(render(lesson()))
    assert told["version"] == 1
    assert [n["name"] for n in told["nodes"]] == ["/control_node", "/motor_node", "/sensor_node"]
    assert told["topics"] == [
        {
            "name": "/sensor_data",
            "types": ["my_robot_interfaces/msg/SensorReading"],
            "publishers": ["/sensor_node"],
            "subscribers": ["/control_node"],
            "undelivered": [],
        }
    ]
    assert told["services"] == [
        {
            "name": "/query_sensor",
            "types": ["my_robot_interfaces/srv/GetSensorData"],
            "servers": ["/sensor_node"],
            "clients": ["/control_node"],
        },
        {
            "name": "/set_motor",
            "types": ["my_robot_interfaces/srv/SetMotorSpeed"],
            "servers": ["/motor_node"],
            "clients": ["/control_node"],
        },
    ]
    assert told["actions"] == told["unresolved"] == []


def test_a_node_has_the_keys_of_the_contract() -> None:
    sensor = document(lesson())["nodes"][2]
    scalars = {
        "name": "/sensor_node",
        "class": "SensorNode",
        "package": "my_first_package",
        "executable": "sensor_node",
        "file": "src/my_first_package/my_first_package/sensor_node.py",
        "line": 6,
        "lifecycle": False,
        "executor": "single_threaded",
        "launched_by": None,
    }
    assert {key: sensor[key] for key in scalars} == scalars
    lists = ("subscribers", "clients", "action_servers", "action_clients")
    assert [sensor[name] for name in lists] == [[], [], [], []]


def test_an_endpoint_has_the_keys_of_the_contract() -> None:
    endpoint = first(document(system(node("/n", publisher("sensor_data", "p/msg/Reading")))), "publishers")
    expected = {
        "name": "/sensor_data",
        "type": "p/msg/Reading",
        "qos": {"history": "keep_last", "depth": 10, "reliability": "reliable", "durability": "volatile"},
        "file": "src/demo/demo/n.py",
        "line": 10,
        "column": 9,
        "end_line": 10,
        "end_column": 49,
        "written": "sensor_data",
        "resolution": "exact",
        "parameter": None,
        "conditional": False,
        "callback_group": "default",
    }
    assert {key: endpoint[key] for key in expected} == expected
    assert "callback" not in endpoint


def test_callbacks() -> None:
    told = document(
        system(
            node(
                "/n",
                subscriber("a", callback="on_scan"),
                service("b", callback="on_call"),
                action_server("c", callback="on_goal"),
                timer(0.5, callback="on_timer"),
            )
        )
    )
    lists = ("subscribers", "services", "action_servers", "timers")
    assert [first(told, name)["callback"] for name in lists] == [
        "N.on_scan",
        "N.on_call",
        "N.on_goal",
        "N.on_timer",
    ]


def test_timers_and_parameters() -> None:
    told = document(system(node("/n", timer(0.1), timer(None), parameter("rate", 1.0, "double"))))
    assert [(t["period_s"], t["file"], t["line"]) for t in told["nodes"][0]["timers"]] == [
        (0.1, "src/demo/demo/n.py", 10),
        (None, "src/demo/demo/n.py", 11),
    ]
    rate = first(told, "parameters")
    assert (rate["name"], rate["type"], rate["default"], rate["line"]) == ("rate", "double", 1.0, 12)


@pytest.mark.parametrize(
    ("default", "told"),
    [(True, True), ([1, 2], [1, 2]), ((b"\x01",), [[1]]), (math.inf, "inf"), ("a", "a"), (object(), None)],
)
def test_defaults_are_plain_json(default: object, told: object) -> None:
    shown = first(json.loads(render(system(node("/n", parameter("p", default))))), "parameters")
    assert shown["default"] == told


def test_a_default_that_is_not_known() -> None:
    assert first(document(system(node("/n", parameter("p", 3, known=False)))), "parameters")["default"] is None


def test_how_a_name_is_known() -> None:
    told = document(
        system(
            node(
                "/n",
                publisher(from_parameter("topic", "a")),
                publisher(partial("*/b")),
                publisher(unknown("it is read from a file at run time")),
            )
        )
    )
    shown = [(p["name"], p["resolution"], p["parameter"]) for p in told["nodes"][0]["publishers"]]
    assert shown == [("/*/b", "partial", None), ("/a", "parameter", "topic"), (None, "unknown", None)]
    assert [t["name"] for t in told["topics"]] == ["/a"]
    [entry] = told["unresolved"]
    assert (entry["kind"], entry["file"], entry["line"]) == ("publisher", "src/demo/demo/n.py", 12)
    assert entry["reason"] == "it is read from a file at run time"


def test_a_helper_that_many_nodes_use_is_unresolved_once() -> None:
    nodes = [node("/a", publisher(unknown())), node("/b", publisher(unknown()))]
    for one in nodes:
        one.endpoints[0].creation.place = place("helper.py", 3)
    assert len(document(system(*nodes))["unresolved"]) == 1


def test_what_could_not_be_followed_is_unresolved() -> None:
    made = node("/n", gaps=[(place("n.py", 7), "the class comes from outside the workspace")], complete=False)
    told = document(system(made))
    assert not told["nodes"][0]["complete"]
    assert told["unresolved"] == [
        {
            "kind": "call",
            "file": "n.py",
            "line": 7,
            "column": 9,
            "reason": "the class comes from outside the workspace",
        }
    ]


def test_a_node_without_a_name_is_null_in_connections() -> None:
    from archlint.systems.instances import instantiate

    helper = instantiate(blueprint(unknown(), publisher("/x"), file="helper.py", class_name="Helper"), None)
    told = document(system(helper, node("/n", publisher("/x"))))
    assert told["nodes"][0]["name"] is None
    assert told["nodes"][0]["class"] == "Helper"
    assert told["topics"][0]["publishers"] == ["/n", None]


def test_qos_that_is_not_all_known_and_qos_that_is_set() -> None:
    told = document(
        system(
            node(
                "/n",
                publisher("a", qos=None),
                publisher("b", qos=Qos(reliability=None, deadline=0.5, liveliness="automatic")),
            )
        )
    )
    a, b = told["nodes"][0]["publishers"]
    assert a["qos"] is None
    assert b["qos"] == {
        "history": "keep_last",
        "depth": 10,
        "reliability": None,
        "durability": "volatile",
        "deadline_s": 0.5,
        "liveliness": "automatic",
    }


def test_callback_groups_and_conditions() -> None:
    made = system(node("/n", client("a", conditional=True, group=Group("reentrant", "g"))))
    shown = first(document(made), "clients")
    assert (shown["conditional"], shown["callback_group"]) == (True, "reentrant")


def test_actions() -> None:
    told = document(system(node("/a", action_server("dock", "p/action/Dock")), node("/b", action_client("dock", None))))
    assert told["actions"] == [{"name": "/dock", "types": ["p/action/Dock"], "servers": ["/a"], "clients": ["/b"]}]


def test_any_name_survives() -> None:
    told = json.loads(render(hostile()))
    assert '"];evil[label="' in [p["written"] for n in told["nodes"] for p in n["publishers"]]
    assert render(hostile()).isascii()


def test_the_same_system_is_the_same_text() -> None:
    assert render(lesson()) == render(lesson())


def test_a_value_from_the_launch_that_is_not_known_says_why():
    scanner = node("/scanner", parameter("topic", "scan"), parameter("rate", 1.0, "double"))
    started = replace(scanner, overrides={"topic": "front/scan", "rate": NotKnown("the environment variable RATE")})

    rows = {row["name"]: row for row in json.loads(render(system(started)))["nodes"][0]["parameters"]}

    assert (rows["topic"]["override"], rows["topic"]["override_reason"]) == ("front/scan", None)
    assert (rows["rate"]["override"], rows["rate"]["override_reason"]) == (None, "the environment variable RATE")
