"""What one callback of a C++ node leaves in a member, and another makes something of."""

from __future__ import annotations

from typing import Any

import pytest
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


ASIDE = """
#include <thread>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
void listen(std::shared_ptr<rclcpp::Node> node, std::string topic) {
  static auto sub = node->create_subscription<std_msgs::msg::String>(topic, 10, [](const std_msgs::msg::String &) {});
}
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  std::thread beside(listen, node, "scan");
  rclcpp::spin(node);
}
"""


def test_a_function_that_a_thread_calls_with_a_name() -> None:
    [node] = graph({"src/robot.cpp": ASIDE})["nodes"]
    assert [end["name"] for end in node["subscribers"]] == ["/scan"]


def test_a_partial_of_one_function_or_another() -> None:
    text = ASIDE.replace("std::thread beside(listen", "std::thread beside(argc > 1 ? listen : other")
    text = text.replace("int main", "void other(std::shared_ptr<rclcpp::Node>, std::string) {}\nint main")
    [node] = graph({"src/robot.cpp": text})["nodes"]
    assert [end["name"] for end in node["subscribers"]] == ["/scan"]


HOOKED = """
#include <functional>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
using String = std_msgs::msg::String;
struct Hooks { std::function<void()> on_ready; };
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {}
  void start() {
    declare_parameter<int>("id", 3);
    id_ = get_parameter("id").as_int();
    declare_parameter<std::string>("group", "arm");
    group_ = get_parameter("group").as_string();
    hooks_.on_ready = std::bind(&Robot::open, this);
  }
private:
  void open() { pub_ = create_publisher<String>("pose/" + group_ + std::to_string(id_), 1); }
  Hooks hooks_;
  int id_{0};
  std::string group_{""};
  rclcpp::Publisher<String>::SharedPtr pub_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto robot = std::make_shared<Robot>();
  %s
  rclcpp::spin(robot);
}
"""


@pytest.mark.parametrize("start", ["robot->start();", ""])
def test_a_method_that_is_called_later_does_not_meet_what_a_member_starts_with(start: str) -> None:
    [node] = graph({"src/robot.cpp": HOOKED % start})["nodes"]
    names = {end["name"] for end in node["publishers"]}
    assert "/pose/arm3" in names
    assert not any("0" in name for name in names)
    assert not any(end["error"] for end in node["publishers"])
