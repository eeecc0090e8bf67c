"""What the formats of other tools allow, in a few lines each; see the sources that the renderers name."""

from __future__ import annotations

import re
from collections.abc import Mapping
from xml.etree import ElementTree

Rule = tuple[frozenset[str], frozenset[str], frozenset[str]]
"""Attributes that an element must have, those that it may have, and the elements inside it."""


def rule(required: str = "", optional: str = "", inside: str = "") -> Rule:
    return frozenset(required.split()), frozenset(optional.split()), frozenset(inside.split())


POLICY: Mapping[str, Rule] = {
    "policy": rule("version", inside="enclaves"),
    "enclaves": rule(inside="enclave"),
    "enclave": rule("path", inside="profiles"),
    "profiles": rule(optional="type", inside="profile metadata"),
    "profile": rule("ns node", inside="topics services actions"),
    "topics": rule(optional="publish subscribe", inside="topic"),
    "services": rule(optional="reply request", inside="service"),
    "actions": rule(optional="call execute", inside="action"),
    **dict.fromkeys(("topic", "service", "action"), rule()),
}
"""policy.xsd of sros2, version 0.2.0."""
NODL: Mapping[str, Rule] = {
    "interface": rule("version", inside="node"),
    "node": rule("name executable", inside="action parameter topic service"),
    "parameter": rule("name type"),
    **dict.fromkeys(("topic", "service", "action"), rule("name type role")),
}
"""v1.xsd of nodl_python."""
NOT_EMPTY = frozenset({"enclaves", "enclave", "profiles", "topics", "services", "actions", "node"})
"""Elements of both that must have one inside."""
QUALIFIERS = ("publish", "subscribe", "reply", "request", "call", "execute")


def valid(text: str, rules: Mapping[str, Rule]) -> ElementTree.Element:
    """The document, which keeps to the rules."""
    root = ElementTree.fromstring(text.encode())
    assert root.tag == next(iter(rules))
    for element in root.iter():
        required, optional, inside = rules[element.tag]
        assert required <= set(element.keys()) <= required | optional, element.tag
        assert {child.tag for child in element} <= inside, element.tag
        assert element.tag not in NOT_EMPTY or len(element), element.tag
        assert all(element.get(name, "ALLOW") == "ALLOW" for name in QUALIFIERS)
    return root


NAME, TOPIC = re.compile(r"[a-zA-Z]\w*", re.ASCII), re.compile(r"[a-zA-Z0-9/_~]+")
TYPE = re.compile(r"[a-zA-Z]\w*/(msg|srv|action)/[A-Z][a-zA-Z0-9]*", re.ASCII)
LISTS = ("publishers", "subscribers", "services", "service_clients", "actions", "action_clients")
PARAMETER_TYPES = {"bool", "int", "double", "string", "bool_array", "int_array", "double_array", "string_array"}


def valid_interface(document: dict) -> dict:
    """A document of interface.yaml, which keeps to what jig's interface.schema.yaml allows."""
    assert document.keys() <= {"node", "parameters", *LISTS}
    assert document["node"].keys() <= {"name", "package"}
    assert all(NAME.fullmatch(text) for text in document["node"].values())
    for parameter in document.get("parameters", {}).values():
        assert parameter["type"] in PARAMETER_TYPES
        optional = {"default_value", "description", "read_only", "additional_constraints", "validation"}
        assert parameter.keys() <= {"type"} | optional
    for key in LISTS:
        for end in document.get(key, []):
            named, qos = ("topic", {"qos"}) if key in ("publishers", "subscribers") else ("name", set())
            assert end.keys() == {named, "type"} | qos
            assert TOPIC.fullmatch(end[named])
            assert TYPE.fullmatch(end["type"])
            if qos:
                assert end["qos"]["history"] == "ALL" or end["qos"]["history"] >= 1
                assert end["qos"]["reliability"] in ("RELIABLE", "BEST_EFFORT")
    return document
