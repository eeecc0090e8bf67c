"""Types of C++ that a ``typedef`` defines and names, as C does."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph

SOURCE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/string.hpp"
%s
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s }
  void make(int kind, const std::string & topic) {
    if (FIRST == kind) {
      create_publisher<std_msgs::msg::String>(topic, 1);
    } else if (SECOND == kind) {
      create_publisher<std_msgs::msg::Bool>(topic, 1);
    }
  }
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""
NUMBERS = "{ FIRST = 0, BETWEEN, SECOND = 3 }"


def published(before: str, statements: str, *, in_header: bool = False) -> list[tuple[str, str]]:
    """Names and types of what a node publishes."""
    files = {"src/robot.cpp": SOURCE % (before, statements)}
    if in_header:
        files = {"src/kinds.h": before, "src/robot.cpp": SOURCE % ('#include "kinds.h"', statements)}
    [node] = graph(files)["nodes"]
    return sorted((end["name"], end["type"]) for end in node["publishers"])


@pytest.mark.parametrize("in_header", [False, True])
@pytest.mark.parametrize(
    "before",
    [
        f"typedef enum {NUMBERS} Kind;",
        f"typedef enum Kind {NUMBERS} Kind;",
        f"typedef enum kind_e {NUMBERS} Kind;",
        f"enum {NUMBERS};",
    ],
)
def test_its_numbers_decide_what_is_made(before: str, in_header: bool) -> None:
    made = published(before, 'make(SECOND, "two"); make(FIRST, "one");', in_header=in_header)
    assert made == [("/one", "std_msgs/msg/String"), ("/two", "std_msgs/msg/Bool")]


def test_they_stand_in_the_type_too() -> None:
    made = published(f"typedef enum {NUMBERS} Kind;", 'make(Kind::SECOND, "two");')
    assert made == [("/two", "std_msgs/msg/Bool")]


@pytest.mark.parametrize("in_header", [False, True])
@pytest.mark.parametrize("name", ["", "topics_s ", "Topics "])
def test_a_structure(name: str, in_header: bool) -> None:
    before = f'#include <string>\nenum {NUMBERS};\ntypedef struct {name}{{ std::string out = "scan"; }} Topics;'
    made = published(before, "Topics topics; make(FIRST, topics.out);", in_header=in_header)
    assert made == [("/scan", "std_msgs/msg/String")]


def test_an_unknown_kind_is_either() -> None:
    before = f"typedef enum {NUMBERS} Kind;"
    made = published(before, 'make(static_cast<Kind>(std::rand()), "scan");')
    assert made == [("/scan", "std_msgs/msg/Bool"), ("/scan", "std_msgs/msg/String")]


@pytest.mark.parametrize("include", ["robot_msgs/msg/Speed.msg", "robot_msgs/msg/speed", "robot_msgs/msg/speed.hpp"])
def test_a_base_that_is_not_here_beside_an_include_of_any_file_of_a_message(include: str) -> None:
    source = SOURCE.replace("public rclcpp::Node", "public Missing, public rclcpp::Node")
    statement = 'create_publisher<std_msgs::msg::Bool>("on", 1);'
    [node] = graph({"src/robot.cpp": source % (f"#include <{include}>", statement)})["nodes"]
    assert [(end["name"], end["type"]) for end in node["publishers"]] == [("/on", "std_msgs/msg/Bool")]
