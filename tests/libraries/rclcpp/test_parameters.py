"""Parameters that nodes of C++ declare, and what is done with a node that declares nothing."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph_of


def declared(statements: str) -> list[tuple[str, Any]]:
    [node] = graph_of(statements)
    return [(parameter["name"], parameter["default"]) for parameter in node["parameters"]]


def test_a_map_declares_each_of_its_names():
    limits = 'std::map<std::string, int64_t> axes{{"yaw", 2}, {"x", 5}}; declare_parameters("axis", axes);'
    assert declared(limits) == [("axis.x", 5), ("axis.yaw", 2)]


@pytest.mark.parametrize("empty", ["std::vector<std::string>()", "std::vector<std::string>{}"])
def test_an_empty_list_is_a_default(empty):
    assert declared(f'declare_parameter("topics", {empty});') == [("topics", [])]


def test_a_list_that_a_function_makes_is_no_known_default():
    assert declared('declare_parameter("topics", acme::topics());') == [("topics", None)]
    assert declared('declare_parameter("topics", std::vector<std::string>(2, name));') == [("topics", None)]


def test_what_reads_parameters_adds_nothing_to_a_node():
    [node] = graph_of("auto reader = std::make_shared<rclcpp::AsyncParametersClient>(this);")
    assert node["complete"]


def test_what_is_not_known_may_add_something():
    [node] = graph_of("auto updater = std::make_shared<acme::Updater>(this);")
    assert not node["complete"]
