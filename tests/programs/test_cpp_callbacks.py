"""What one callback of a C++ node leaves in a member, and another makes something of."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph

LATE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
using String = std_msgs::msg::String;
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { open(); });
    sub_ = create_subscription<String>("mode", 1, [this](const String & msg) { change(msg); });
  }
private:
  void open() { %s }
  void change(const String & msg) { if (msg.data == "arm") { topic_ = "arm"; } }
  std::string topic_ = "base";
  rclcpp::Publisher<String>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Subscription<String>::SharedPtr sub_;
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def published(statements: str) -> list[dict[str, Any]]:
    [node] = graph({"src/robot.cpp": LATE % statements})["nodes"]
    return node["publishers"]


def test_a_callback_that_creates_sees_what_a_later_one_leaves() -> None:
    names = {end["name"] for end in published("pub_ = create_publisher<String>(topic_, 1);")}
    assert names == {"/base", "/arm"}


def test_so_does_one_that_creates_in_a_method_of_its_node() -> None:
    text = LATE.replace(
        "  void open() {", "  void make() { pub_ = create_publisher<String>(topic_, 1); }\n  void open() {"
    )
    [node] = graph({"src/robot.cpp": text % "make();"})["nodes"]
    assert {end["name"] for end in node["publishers"]} == {"/base", "/arm"}
