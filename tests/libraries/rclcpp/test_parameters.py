"""Parameters that nodes of C++ declare, and what is done with a node that declares nothing."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph_of


def declared(statements: str) -> list[tuple[str, Any]]:
    [node] = graph_of(statements)
    return [(parameter["name"], parameter["default"]) for parameter in node["parameters"]]


def test_a_map_declares_each_of_its_names():
    limits = 'std::map<std::string, int64_t> axes{{"yaw", 2}, {"x", 5}}; declare_parameters("axis", axes);'
    assert declared(limits) == [("axis.x", 5), ("axis.yaw", 2)]


def test_what_reads_parameters_adds_nothing_to_a_node():
    [node] = graph_of("auto reader = std::make_shared<rclcpp::AsyncParametersClient>(this);")
    assert node["complete"]


def test_what_is_not_known_may_add_something():
    [node] = graph_of("auto updater = std::make_shared<acme::Updater>(this);")
    assert not node["complete"]
