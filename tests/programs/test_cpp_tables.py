"""Tables of C++ that say what a node creates: structures, pairs, maps, and the functions that go through them."""

from __future__ import annotations

from typing import Any

import pytest
from tests.cpp_nodes import graph

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
struct Row {
  std::string topic = "unnamed";
  int depth{7};
};
static const Row rows[] = {{"a", 1}, {"b", 2}};
static const std::map<std::string, Row> by_name = {{"x", {"c", 3}}, {"y", {.depth = 4}}};
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s }
  void publish(const std::string & topic, int depth) {
    publishers_.push_back(create_publisher<std_msgs::msg::String>(topic, depth));
  }
  std::vector<std::string> names_{"left", "right"};
  std::vector<rclcpp::Publisher<std_msgs::msg::String>::SharedPtr> publishers_;
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def published(statements: str) -> list[tuple[Any, Any]]:
    """The names and depths of what a node publishes."""
    [node] = graph({"src/robot.cpp": PROGRAM % statements})["nodes"]
    return sorted((end["name"], end["qos"]["depth"]) for end in node["publishers"])


@pytest.mark.parametrize(
    "statements",
    [
        "for (const auto & row : rows) { publish(row.topic, row.depth); }",
        "for (const auto & [topic, depth] : rows) { publish(topic, depth); }",
        'std::vector<Row> more{{"a", 1}, {.topic = "b", .depth = 2}};'
        "for (const Row & row : more) { publish(row.topic, row.depth); }",
        'const std::array<Row, 2> more = {{{"a", 1}, {"b", 2}}}; for (auto row : more) publish(row.topic, row.depth);',
        'Row first{"a", 1}; Row second = {"b", 2}; Row copy{first};'
        "publish(copy.topic, copy.depth); publish(second.topic, second.depth);",
        'std::vector<std::pair<std::string, int>> more = {{"a", 1}, {"b", 2}};'
        "for (const auto & row : more) publish(row.first, row.second);",
        'auto [topic, depth] = std::make_pair("a", 1); publish(topic, depth); publish("b", 2);',
        "publish(rows[0].topic, rows[0].depth); publish(rows[1].topic, rows[1].depth);",
        "publish(rows.front().topic, 1); publish(rows.back().topic, 2);",
        'std::tuple<std::string, int> row{"a", 1}; publish(std::get<0>(row), std::get<1>(row)); publish("b", 2);',
    ],
)
def test_rows_of_a_table(statements: str) -> None:
    assert published(statements) == [("/a", 1), ("/b", 2)]


def test_a_field_that_a_row_leaves_out_has_its_first_value() -> None:
    assert published("Row row{.depth = 2}; publish(row.topic, row.depth);") == [("/unnamed", 2)]
    assert published('Row row{"a"}; publish(row.topic, row.depth);') == [("/a", 7)]


def test_structures_in_a_map() -> None:
    assert published("for (const auto & [key, row] : by_name) publish(row.topic, row.depth);") == [
        ("/c", 3),
        ("/unnamed", 4),
    ]
    assert published('publish(by_name.at("x").topic, 1);') == [("/c", 1)]
    assert published('publish(by_name.find("x")->second.topic, 1);') == [("/c", 1)]


@pytest.mark.parametrize(
    "call",
    [
        "std::for_each(names_.begin(), names_.end(), [this](const std::string & name) { publish(name, 1); });",
        "std::ranges::for_each(names_, [this](const auto & name) { publish(name, 1); });",
        "std::transform(names_.cbegin(), names_.cend(), std::back_inserter(publishers_),"
        " [this](const auto & name) { return create_publisher<std_msgs::msg::String>(name, 1); });",
    ],
)
def test_a_function_that_is_called_for_each_item(call: str) -> None:
    assert published(call) == [("/left", 1), ("/right", 1)]


@pytest.mark.parametrize(
    "change",
    [
        "std::replace(topic.begin(), topic.end(), '/', '_');",
        "std::transform(topic.begin(), topic.end(), topic.begin(), ::tolower);",
        'boost::replace_all(topic, "/", "_");',
        "std::getline(std::cin, topic);",
    ],
)
def test_a_text_that_a_function_changes_is_not_known_any_more(change: str) -> None:
    before = 'std::string topic = "Arm/State"; '
    assert published(before + "publish(topic, 1);") == [("/Arm/State", 1)]
    assert published(before + change + " publish(topic, 1);") == [(None, 1)]
