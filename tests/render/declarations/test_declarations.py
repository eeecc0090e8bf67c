"""The interfaces of nodes in the formats of other tools."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import pytest
import yaml

from archlint.model import ParameterDescription
from archlint.render.declarations import FORMATS, render
from archlint.render.declarations.interface import declarations_of
from archlint.render.declarations.rendered import Rendered
from archlint.ros.qos import Qos
from archlint.systems.nodes import Node
from render.declarations.formats import NODL, valid, valid_interface
from render.hostile import NAMES, hostile
from render.lesson import lesson
from systems.builders import action_server, node, parameter, partial, publisher, service, subscriber, system, unknown


def rendered(format: Any, *nodes: Node) -> Rendered:
    return render(format, declarations_of([system(*nodes)]))


def interface_of(*entities: Any, **options: Any) -> dict[str, Any]:
    """What ``interface.yaml`` says of a node with some entities."""
    text = rendered("interface-yaml", node("/ns/driver", *entities, package="robot", **options)).text
    return valid_interface(yaml.safe_load(text))


def driver(*entities: Any) -> Node:
    return node("/driver", *entities, package="robot", executables=("driver",))


def test_an_interface_keeps_names_as_the_code_gives_them():
    declared = interface_of(publisher("scan"), publisher("~/state"), service("/reset"))
    assert declared["node"] == {"name": "driver", "package": "robot"}
    assert [end["topic"] for end in declared["publishers"]] == ["scan", "~/state"]
    assert declared["services"] == [{"name": "/reset", "type": "std_srvs/srv/Trigger"}]


def test_a_profile_in_full():
    qos = Qos("keep_all", None, "best_effort", "transient_local", 0.5, 2.0, "manual_by_topic", 1.5)
    [end] = interface_of(subscriber("scan", qos=qos))["subscribers"]
    assert end["qos"] == {
        "history": "ALL",
        "reliability": "BEST_EFFORT",
        "durability": "TRANSIENT_LOCAL",
        "deadline_ms": 500,
        "lifespan_ms": 2000,
        "lease_duration_ms": 1500,
        "liveliness": "MANUAL_BY_TOPIC",
    }


@pytest.mark.parametrize(
    "qos", [None, Qos(reliability=None), Qos(depth=0), Qos("system_default"), Qos(durability="best_available")]
)
def test_a_profile_that_the_format_cannot_say_is_left_out_with_a_word(qos):
    answer = rendered("interface-yaml", driver(publisher("scan", qos=qos), publisher("safe")))
    assert [end["topic"] for end in valid_interface(yaml.safe_load(answer.text))["publishers"]] == ["safe"]
    [words] = answer.left_out
    assert words.startswith("driver: the publisher scan at ")
    assert f"# left out: {words.removeprefix('driver: ')}\n" in answer.text


def test_a_parameter_with_its_descriptor():
    described = ParameterDescription("How often", "a multiple of 0.5", True, 0.5, 10.0, 0.5)
    declared = interface_of(
        parameter("rate", 2.0, "double", description=described),
        parameter("names", ["a", "b"], "string_array"),
        parameter("port", None, "string", known=False, without_default=True),
    )["parameters"]
    assert declared == {
        "rate": {
            "type": "double",
            "default_value": 2.0,
            "description": "How often",
            "additional_constraints": "a multiple of 0.5",
            "read_only": True,
            "validation": {"bounds<>": [0.5, 10.0]},
        },
        "names": {"type": "string_array", "default_value": ["a", "b"]},
        "port": {"type": "string"},
    }


@pytest.mark.parametrize("format", FORMATS)
def test_what_is_not_known_is_never_declared(format):
    answer = rendered(
        format,
        driver(
            publisher("scan"),
            publisher(unknown("it is read from a file")),
            subscriber(partial("camera_*", "it depends on data")),
            service("reset", None),
        ),
    )
    assert "scan" in answer.text
    assert "camera_" not in answer.text
    assert [words.rpartition(": ")[2] for words in answer.left_out] == [
        "it is read from a file",
        "it depends on data",
        "no reason is recorded",
    ]


def test_nodl_is_valid_and_says_both_roles_at_once():
    answer = rendered("nodl", driver(publisher("echo"), subscriber("echo"), action_server("go"), parameter("p", 1.0)))
    [element] = valid(answer.text, NODL)
    assert element.attrib == {"name": "driver", "executable": "driver"}
    assert [(child.tag, child.get("name"), child.get("role")) for child in element] == [
        ("parameter", "p", None),
        ("action", "go", "server"),
        ("topic", "echo", "both"),
    ]


def test_nodl_leaves_out_a_node_that_nothing_starts():
    answer = rendered("nodl", driver(publisher("scan")), node("/loose", publisher("scan"), executables=()))
    assert [child.get("name") for child in valid(answer.text, NODL)] == ["driver"]
    assert answer.left_out == ("the node loose: no executable starts it",)


def test_json_has_all_of_a_node():
    document = json.loads(rendered("json", driver(publisher("scan"), parameter("p", 1.0, "double"))).text)
    [told] = document["nodes"]
    assert (document["version"], told["name"], told["package"], told["executables"]) == (
        1,
        "driver",
        "robot",
        ["driver"],
    )
    assert [(end["name"], end["qos"]["depth"]) for end in told["publishers"]] == [("scan", 10)]
    assert [(p["name"], p["default"], p["has_default"], p["range"]) for p in told["parameters"]] == [
        ("p", 1.0, True, None)
    ]


def test_a_document_for_each_node():
    documents = yaml.safe_load_all(render("interface-yaml", declarations_of([lesson()])).text)
    assert [valid_interface(document)["node"]["name"] for document in documents] == [
        "control_node",
        "motor_node",
        "sensor_node",
    ]


def test_test_code_is_not_declared():
    assert "probe" not in rendered("json", node("/probe", publisher("scan"), test=True)).text


def test_nothing_to_declare():
    assert list(yaml.safe_load_all(rendered("interface-yaml").text)) in ([], [None])


@pytest.mark.parametrize("name", NAMES)
def test_names_that_try_to_be_more_than_names(name):
    entities = [publisher(unknown(name)), parameter(name, name), service("reset")]
    answer = rendered("nodl", driver(*entities))
    assert [child.tag for child in valid(answer.text, NODL)[0]] == ["parameter", "service"]
    text = rendered("interface-yaml", driver(*entities)).text
    assert [end["name"] for end in yaml.safe_load(text)["services"]] == ["reset"]


def as_texts(answers: Sequence[Rendered]) -> list[str]:
    return [answer.text for answer in answers]


def test_the_same_system_gives_the_same_bytes():
    once, again = ([render(format, declarations_of([hostile(), lesson()])) for format in FORMATS] for _ in range(2))
    assert as_texts(once) == as_texts(again)
