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


def test_the_parameters_of_another_node_are_asked_for_by_its_services():
    [node] = graph_of('auto reader = std::make_shared<rclcpp::AsyncParametersClient>(this, "arm");')
    assert {client["name"] for client in node["clients"]} >= {"/arm/get_parameters", "/arm/set_parameters"}
    assert len(node["clients"]) == 6


@pytest.mark.parametrize(
    ("declaration", "expected"),
    [
        ('declare_parameter("speed", rclcpp::PARAMETER_DOUBLE);', ("double", None)),
        ('declare_parameter("speed", rclcpp::ParameterType::PARAMETER_INTEGER);', ("integer", None)),
        ('declare_parameter("speed", std::vector<double>{1.0, 2.0});', ("double_array", [1.0, 2.0])),
        ('declare_parameter("speed", std::vector<int64_t>({1, 2}));', ("integer_array", [1, 2])),
        ('declare_parameter("speed", std::vector<double>({1, 2}));', ("double_array", [1.0, 2.0])),
        ('declare_parameter("speed", double(2));', ("double", 2.0)),
        ('declare_parameter("speed", static_cast<double>(2));', ("double", 2.0)),
        ('declare_parameter("speed", static_cast<int>(2.5));', ("integer", 2)),
        ('declare_parameter("speed", static_cast<bool>(1));', ("bool", True)),
        ('declare_parameter("speed", std::vector<double>(first, last));', (None, None)),
        ('declare_parameter("speed", acme::SPEED);', (None, None)),
    ],
)
def test_the_type_of_a_parameter(declaration, expected):
    [node] = graph_of(declaration)
    assert [(row["type"], row["default"]) for row in node["parameters"]] == [expected]


def test_a_parameter_that_is_read_with_an_alternative_has_what_was_declared():
    statements = """
      declare_parameter("declared", "here");
      create_publisher<std_msgs::msg::String>(get_parameter_or<std::string>("declared", "elsewhere"), 10);
      create_publisher<std_msgs::msg::String>(get_parameter_or<std::string>("nowhere", "alternative"), 10);
    """
    [node] = graph_of(statements)
    assert {end["name"] for end in node["publishers"]} == {"/here", "/alternative"}


def test_what_is_done_when_a_parameter_changes():
    statements = """
      handler_ = std::make_shared<rclcpp::ParameterEventHandler>(this);
      auto create = [this](const auto &) { create_publisher<std_msgs::msg::String>("later", 10); };
      handle_ = handler_->add_parameter_callback("gain", create, "arm");
    """
    [node] = graph_of(statements)
    assert [end["name"] for end in node["publishers"]] == ["/later"]
    assert [end["name"] for end in node["subscribers"]] == ["/parameter_events"]
    assert node["complete"]


def test_what_is_not_known_may_add_something():
    [node] = graph_of("auto updater = std::make_shared<acme::Updater>(this);")
    assert not node["complete"]


def test_a_parameter_that_is_read_with_its_name_is_asked_for_its_value():
    body = """
        declare_parameter("topic", "chatter");
        rclcpp::Parameter topic;
        if (get_parameter("topic", topic)) create_publisher<std_msgs::msg::String>(topic.as_string(), 1);
    """
    [node] = graph_of(body)
    assert [end["name"] for end in node["publishers"]] == ["/chatter"]
