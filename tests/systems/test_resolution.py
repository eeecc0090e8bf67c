"""The name and namespace of a node, as its constructor and its rules give them."""

from __future__ import annotations

import pytest

from archlint.model import EntityKind, Text
from archlint.ros.remapping import RemapRule
from archlint.systems.resolution import NodeName, endpoint_name, node_init
from systems.builders import exact, unknown


def rules(*texts: str) -> list[RemapRule]:
    return [RemapRule.parse(text) for text in texts]


@pytest.mark.parametrize(
    ("name", "namespace", "texts", "expected"),
    [
        ("n", "", [], ("n", "/")),
        ("n", "a", [], ("n", "/a")),
        ("n", "/a", ["__node:=m"], ("m", "/a")),
        ("n", "/a", ["__ns:=/b"], ("n", "/b")),
        ("n", "/a", ["n:__node:=m", "m:__ns:=/b"], ("m", "/b")),
        ("n", "/a", ["n:__node:=m", "n:__ns:=/b"], ("m", "/a")),
        ("n", "/a", ["other:__node:=m"], ("n", "/a")),
        ("n", "/a", ["__node:=first", "__node:=second"], ("first", "/a")),
    ],
)
def test_node_init(name: str, namespace: str, texts: list[str], expected: tuple[str, str]) -> None:
    own = node_init(exact(name), exact(namespace), rules(*texts))
    assert (own.name.text, own.namespace.text) == expected


def test_a_rule_gives_a_name_to_a_node_whose_own_is_unknown() -> None:
    own = node_init(unknown(), unknown(), [], rules("__node:=m", "__ns:=/a"))
    assert own.full == "/a/m"


def test_a_parameter_that_is_empty_by_default_gives_no_name() -> None:
    own = NodeName(exact("robot"), exact("/"))
    empty = endpoint_name(Text("", "parameter", "topic"), EntityKind.PUBLISHER, own, [])
    assert (empty.name, empty.parameter, empty.error) == (None, "topic", "topic name must not be empty string")
    assert empty.reason == "the parameter 'topic' has to be set: it is empty"
    whole = endpoint_name(Text("/odom", "parameter", "prefix"), EntityKind.PUBLISHER, own, [])
    assert (whole.name, whole.error) == ("/odom", None)
