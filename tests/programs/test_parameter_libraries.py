"""Parameters that ``generate_parameter_library`` declares: of C++ and of Python, in every place where they count."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph

BUILD = """
project(robot)
find_package(generate_parameter_library REQUIRED)
generate_parameter_library(robot_parameters src/parameters.yaml)
add_executable(robot src/robot.cpp)
install(TARGETS robot DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})
"""
DEFINITION = """
robot:
  topic:
    type: string
    default_value: "odom"
    description: "Where the robot is."
    read_only: true
  rate: {type: double, default_value: 10}
  offsets: {type: double_array, default_value: []}
  frame: {type: string}
  unused: {type: none}
  gains:
    p: {type: int, default_value: 1, validation: {gt<>: [0]}}
    limits:
      high: {type: double_array_fixed_2, default_value: [1.0, 2.0]}
"""
SOURCE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "robot/robot_parameters.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    listener_ = std::make_shared<robot::ParamListener>(%s);
    params_ = listener_->get_params();
    publisher_ = create_publisher<std_msgs::msg::String>(params_.topic, 10);
  }
private:
  std::shared_ptr<robot::ParamListener> listener_;
  robot::Params params_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def robot(given: str = "this", definition: str = DEFINITION, **files: str) -> dict[str, Any]:
    """The node whose listener is given this."""
    texts = {"CMakeLists.txt": BUILD, "src/parameters.yaml": definition, "src/robot.cpp": SOURCE % given}
    [only] = graph(texts | files)["nodes"]
    return dict(only)


def declared(of_node: dict[str, Any]) -> dict[str, tuple[str, object]]:
    return {row["name"]: (row["type"], row["default"]) for row in of_node["parameters"]}


def test_a_listener_declares_the_parameters_of_its_file() -> None:
    of_node = robot()
    assert declared(of_node) == {
        "topic": ("string", "odom"),
        "rate": ("double", 10.0),
        "offsets": ("double_array", []),
        "frame": ("string", None),
        "gains.p": ("integer", 1),
        "gains.limits.high": ("double_array", [1.0, 2.0]),
    }
    assert of_node["complete"]
    topic = next(row for row in of_node["parameters"] if row["name"] == "topic")
    assert (topic["file"], topic["line"]) == ("robot/src/parameters.yaml", 3)


def test_the_value_of_a_parameter_names_a_topic() -> None:
    [publisher] = robot()["publishers"]
    assert (publisher["name"], publisher["type"]) == ("/odom", "std_msgs/msg/String")


@pytest.mark.parametrize(
    ("given", "prefix"),
    [
        ("get_node_parameters_interface()", ""),
        ("get_node_parameters_interface(), get_logger()", ""),
        ('this->get_node_parameters_interface(), this->get_logger(), "arm"', "arm."),
        ('this, "arm."', "arm."),
        ('get_node_parameters_interface(), rclcpp::get_logger("robot")', ""),
    ],
)
def test_what_a_listener_is_made_with(given: str, prefix: str) -> None:
    of_node = robot(given)
    assert f"{prefix}gains.p" in declared(of_node)
    assert len(of_node["parameters"]) == 6


def test_a_map_has_an_entry_for_each_text_of_its_parameter() -> None:
    definition = """
    robot:
      topic: {type: string, default_value: odom}
      joints: {type: string_array, default_value: [left, right]}
      gains:
        axes: {type: string_array, default_value: [x]}
        __map_joints:
          __map_axes:
            d: {type: double, default_value: 0.5}
    """
    assert [name for name in declared(robot(definition=definition)) if name.endswith(".d")] == [
        "gains.left.x.d",
        "gains.right.x.d",
    ]


def test_of_a_map_without_entries_the_names_are_not_known() -> None:
    definition = """
    robot:
      topic: {type: string, default_value: odom}
      joints: {type: string_array}
      __map_joints:
        d: {type: double, default_value: 0.5}
    """
    [row] = [row for row in robot(definition=definition)["parameters"] if row["type"] == "double"]
    assert row["name"] == "*.d"


@pytest.mark.parametrize(
    "definition",
    [
        "robot:\n  topic: {default_value: odom}\n",  # no type
        "robot:\n  topic: {type: text}\n",
        "robot: {}\n",
        "robot:\n  topic: {type: string}\nother:\n  topic: {type: string}\n",
        "robot: [\n",
        "",
    ],
)
def test_what_the_generator_refuses_leaves_the_node_open(definition: str) -> None:
    of_node = robot(definition=definition)
    assert of_node["parameters"] == []
    assert not of_node["complete"]


def test_a_header_that_comes_from_elsewhere_leaves_the_node_open() -> None:
    of_node = robot(**{"CMakeLists.txt": BUILD.replace("generate_parameter_library(", "acme_parameters(")})
    assert of_node["parameters"] == []
    assert not of_node["complete"]


def test_a_node_that_declares_one_itself_keeps_it() -> None:
    source = SOURCE.replace("listener_ =", 'declare_parameter("rate", 5.0);\n    listener_ =') % "this"
    rows = [row for row in robot(**{"src/robot.cpp": source})["parameters"] if row["name"] == "rate"]
    assert [row["default"] for row in rows] == [5.0]
