"""Constructors of C++ that share their number of arguments: the classes of what is given say which one is meant."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph

HANDLE = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/string.hpp"
using String = std_msgs::msg::String;
class Handle {
public:
  explicit Handle(const std::shared_ptr<rclcpp::Node> & node) {
    node->create_publisher<String>("of_node", 1);
  }
  explicit Handle(const %s & other) { %s }
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  %s
  Handle handle(given);
  rclcpp::spin(given);
}
"""
NODE = 'auto given = std::make_shared<rclcpp::Node>("robot");'


@pytest.mark.parametrize(
    ("other", "does", "given", "name"),
    [
        ("rclcpp::NodeOptions", 'std::make_shared<rclcpp::Node>("own", other);', NODE, "/of_node"),
        ("std::string", "std::make_shared<rclcpp::Node>(other);", NODE, "/of_node"),
        (
            "rclcpp_lifecycle::LifecycleNode::SharedPtr",
            'other->create_publisher<String>("of_lifecycle", 1);',
            'auto given = std::make_shared<rclcpp_lifecycle::LifecycleNode>("robot");',
            "/of_lifecycle",
        ),
    ],
)
def test_which_constructor_a_node_is_given_to(other: str, does: str, given: str, name: str) -> None:
    nodes = graph({"src/robot.cpp": HANDLE % (other, does, given)})["nodes"]
    [robot] = [node for node in nodes if node["name"] == "/robot"]
    assert [end["name"] for end in robot["publishers"]] == [name]


def test_options_are_given_to_the_constructor_that_makes_a_node() -> None:
    does = 'auto own = std::make_shared<rclcpp::Node>("own", other); own->create_publisher<String>("of_options", 1);'
    source = HANDLE % ("rclcpp::NodeOptions", does, "rclcpp::NodeOptions given;")
    [own] = [node for node in graph({"src/robot.cpp": source})["nodes"] if node["name"] == "/own"]
    assert [end["name"] for end in own["publishers"]] == ["/of_options"]
