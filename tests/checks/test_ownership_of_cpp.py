"""OWN001: publishers of C++ nodes, which the sources of their package may do nothing with."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.robot_package import manifest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

SOURCE = """
#include "{name}.hpp"
#include "std_msgs/msg/float64.hpp"
{class_}::{class_}() : Node("{name}") {{
  goal_pub_ = this->create_publisher<std_msgs::msg::Float64>("goal", 1);
  timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {{ {tick} }});
}}
int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<{class_}>()); }}
"""
HEADER = """
#pragma once
#include "rclcpp/rclcpp.hpp"
class {class_} : public rclcpp::Node {{
public:
  {class_}();
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr goal_pub_;  // goal_pub_ is for the goal
  rclcpp::TimerBase::SharedPtr timer_;
}};
"""
CMAKE = """
project({name})
add_executable({name} src/{name}.cpp)
install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})
install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})
"""
LAUNCH = '<launch><node pkg="one" exec="one"/><node pkg="two" exec="two"/></launch>'
PUBLISH = "goal_pub_->publish(std_msgs::msg::Float64());"


@pytest.mark.parametrize(
    ("tick", "told"),
    [
        (PUBLISH, 1),
        ("send(goal_pub_);", 1),
        ("", 0),  # it only makes the publisher
        (f"// {PUBLISH}\n", 0),
    ],
    ids=["both publish", "something else may", "only made", "commented out"],
)
def test_a_publisher_that_nothing_uses_says_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tick: str, told: int
):
    for name, ticks in (("one", PUBLISH), ("two", tick)):
        words = {"name": name, "class_": name.title(), "tick": ticks}
        files = {
            "package.xml": manifest(name, build_type="ament_cmake"),
            "CMakeLists.txt": CMAKE.format(**words),
            f"src/{name}.hpp": HEADER.format(**words),
            f"src/{name}.cpp": SOURCE.format(**words),
            "launch/both.launch.xml": LAUNCH,
        }
        for path, text in files.items():
            file = tmp_path / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text('select = ["OWN001"]')
    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
    assert len(report.findings) == told


BOTH = """
#pragma once
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"
class Solver : public rclcpp::Node {{
public:
  Solver() : Node("solver") {{
    goal_pub_ = create_publisher<std_msgs::msg::Float64>("goal", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), std::bind(&Solver::solve, this));
  }}
  void solve();
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr goal_pub_;
}};
class Walker : public rclcpp::Node {{
public:
  Walker() : Node("walker") {{
    goal_pub_ = create_publisher<std_msgs::msg::Float64>("goal", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {{ {tick} }});
  }}
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr goal_pub_;
  rclcpp::TimerBase::SharedPtr timer_;
}};
"""
MAIN = """
#include "walk.hpp"
void Solver::solve()
{
  goal_pub_->publish(std_msgs::msg::Float64());
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto walker = std::make_shared<Walker>();
  auto solver = std::make_shared<Solver>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(walker);
  executor.add_node(solver);
  executor.spin();
}
"""


@pytest.mark.parametrize(("tick", "told"), [("", 0), (PUBLISH, 1)])
def test_another_class_has_a_publisher_of_that_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tick: str, told: int
):
    files = {
        "package.xml": manifest("walk", build_type="ament_cmake"),
        "CMakeLists.txt": CMAKE.format(name="walk"),
        "src/walk.hpp": BOTH.format(tick=tick),
        "src/walk.cpp": MAIN,
    }
    for path, text in files.items():
        file = tmp_path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text('select = ["OWN001"]')
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


COMPONENT = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/float64.hpp"
class Counter : public rclcpp::Node {
public:
  explicit Counter(const rclcpp::NodeOptions & options) : Node("counter", options) {
    pub_ = create_publisher<std_msgs::msg::Float64>("count", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { pub_->publish(std_msgs::msg::Float64()); });
  }
private:
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
};
RCLCPP_COMPONENTS_REGISTER_NODE(Counter)
"""
LIBRARY = """
project(parts)
add_library(counter SHARED src/counter.cpp)
rclcpp_components_register_nodes(counter "Counter")
install(TARGETS counter LIBRARY DESTINATION lib)
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""
LOADED = '<composable_node pkg="parts" plugin="Counter" name="{}">{}</composable_node>'


@pytest.mark.parametrize(
    ("given", "told"),
    [("", 0), ('<param name="step" value="2.0"/>', 1), ('<remap from="other" to="that"/>', 1)],
    ids=["alike in all", "with a parameter", "with a remapping"],
)
def test_a_component_that_is_loaded_twice_says_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, given: str, told: int
):
    """Nothing tells the two apart but their names: whoever loads both shows that this can be done."""
    loaded = LOADED.format("first", "") + LOADED.format("second", given)
    container = f'<node_container pkg="rclcpp_components" exec="component_container" name="box">{loaded}'
    files = {
        "package.xml": manifest("parts", build_type="ament_cmake"),
        "CMakeLists.txt": LIBRARY,
        "src/counter.cpp": COMPONENT,
        "launch/both.launch.xml": f"<launch>{container}</node_container></launch>",
        "archlint.toml": 'select = ["OWN001"]',
    }
    for path, text in files.items():
        file = tmp_path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    monkeypatch.chdir(tmp_path)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


TURNS = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/int32_multi_array.hpp"
#include "std_msgs/msg/float32_multi_array.hpp"
#include "std_msgs/msg/float64.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav2_msgs/action/follow_path.hpp"
#include "std_srvs/srv/set_bool.hpp"
using FollowPath = nav2_msgs::action::FollowPath;
using Handle = rclcpp_action::ServerGoalHandle<FollowPath>;
class Driver : public rclcpp::Node {{
public:
  Driver();
private:
  void on_select(const std_msgs::msg::Int32::SharedPtr message);
  void on_speed(const std_msgs::msg::Float64::SharedPtr message);
  void on_levels(const std_msgs::msg::Int32MultiArray::SharedPtr message) {{ levels_ = message; }}
  void on_angles(const std_msgs::msg::Float32MultiArray::SharedPtr message) {{ angles_ = message; }}
  void on_enable(
    const std::shared_ptr<std_srvs::srv::SetBool::Request> request,
    std::shared_ptr<std_srvs::srv::SetBool::Response>) {{ enabled_ = request->data; }}
  rclcpp_action::GoalResponse on_goal(const rclcpp_action::GoalUUID &, std::shared_ptr<const FollowPath::Goal>)
  {{
    return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
  }}
  rclcpp_action::CancelResponse on_cancel(const std::shared_ptr<Handle>)
  {{
    return rclcpp_action::CancelResponse::ACCEPT;
  }}
  void on_accepted(const std::shared_ptr<Handle> handle) {{ goal_ = handle; }}
  void loop();
  void drive();
  void turn();
  void test() {{ commands_->publish(geometry_msgs::msg::Twist()); drive(); }}
  int selected_ = 0;
  bool turning_ = false;
  std_msgs::msg::Int32MultiArray::SharedPtr levels_ = nullptr;
  std_msgs::msg::Float32MultiArray::SharedPtr angles_ = nullptr;
  rclcpp::Subscription<std_msgs::msg::Int32MultiArray>::SharedPtr levels_in_;
  rclcpp::Subscription<std_msgs::msg::Float32MultiArray>::SharedPtr angles_in_;
  bool enabled_ = false;
  double speed_ = 0.0;
  std::shared_ptr<Handle> goal_;
  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr select_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr limit_;
  rclcpp::Service<std_srvs::srv::SetBool>::SharedPtr enable_;
  rclcpp_action::Server<FollowPath>::SharedPtr server_;
  rclcpp::TimerBase::SharedPtr timer_;
}};
Driver::Driver() : Node("{name}")
{{
  using std::placeholders::_1;
  using std::placeholders::_2;
  commands_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
  select_ = create_subscription<std_msgs::msg::Int32>("{select}", 10, std::bind(&Driver::on_select, this, _1));
  limit_ = create_subscription<std_msgs::msg::Float64>("speed", 10, std::bind(&Driver::on_speed, this, _1));
  levels_in_ = create_subscription<std_msgs::msg::Int32MultiArray>(
    "levels", 10, std::bind(&Driver::on_levels, this, _1));
  angles_in_ = create_subscription<std_msgs::msg::Float32MultiArray>(
    "angles", 10, std::bind(&Driver::on_angles, this, _1));
  enable_ = create_service<std_srvs::srv::SetBool>("~/enable", std::bind(&Driver::on_enable, this, _1, _2));
  server_ = rclcpp_action::create_server<FollowPath>(
    this, "{name}/follow", std::bind(&Driver::on_goal, this, _1, _2), std::bind(&Driver::on_cancel, this, _1),
    std::bind(&Driver::on_accepted, this, _1));
  timer_ = create_wall_timer(std::chrono::milliseconds(100), std::bind(&Driver::loop, this));
}}
void Driver::on_select(const std_msgs::msg::Int32::SharedPtr message) {{ selected_ = message->data; }}
void Driver::on_speed(const std_msgs::msg::Float64::SharedPtr message) {{ speed_ = message->data; }}
void Driver::loop() {{ {loop} }}
void Driver::turn()
{{
  geometry_msgs::msg::Twist command;
  command.angular.z = 0.5;
  commands_->publish(command);
  turning_ = false;
}}
void Driver::drive()
{{
  geometry_msgs::msg::Twist command;
  command.linear.x = 0.5;
  commands_->publish(command);
}}
int main(int argc, char ** argv) {{ rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Driver>()); }}
"""


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [
        ("drive();", "drive();", 1),
        ("if (selected_ != 0) { return; } drive();", "if (selected_ == 1) { drive(); }", 0),
        ("if (selected_ != 0) { return; } drive();", "drive();", 1),
        ("if (speed_ < 0.1) { return; } drive();", "if (speed_ < 0.1) { return; } drive();", 1),
        ("if (!enabled_) return; drive();", "if (!this->enabled_) return; drive();", 0),
        ("if (!goal_) return; drive();", "if (goal_ == nullptr) return; drive();", 0),
        ("if (!goal_) return; drive();", "drive();", 1),
        ("if (!goal_) return; if (turning_) { turn(); return; } turning_ = true; drive();", "if (goal_) drive();", 0),
        ("turn(); if (!goal_) return; drive();", "if (goal_) drive();", 1),
        (
            "if (!levels_ || levels_->data[0] != 0) return; drive();",
            "if (levels_ && !levels_->data.empty()) { if (levels_->data[0] == 0) return; drive(); }",
            0,
        ),
        ("if (!angles_) return; drive();", "if (!angles_) return; drive();", 1),
        ("commands_->publish(geometry_msgs::msg::Twist()); if (!goal_) return; drive();", "if (goal_) drive();", 0),
    ],
)
def test_nodes_that_ask_whose_turn_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, first: str, second: str, told: int
):
    for name, loop in (("one", first), ("two", second)):
        files = {
            "package.xml": manifest(name, build_type="ament_cmake"),
            "CMakeLists.txt": CMAKE.format(name=name),
            f"src/{name}.cpp": TURNS.format(name=name, loop=loop, select="select"),
            "launch/both.launch.xml": LAUNCH,
        }
        for path, text in files.items():
            file = tmp_path / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "archlint.toml").write_text('select = ["OWN001"]')
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told
