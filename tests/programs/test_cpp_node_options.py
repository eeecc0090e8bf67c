"""What ``rclcpp::NodeOptions`` of the source decide about a node."""

from __future__ import annotations

from typing import Any

from tests.cpp_nodes import graph

PROGRAM = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Talker : public rclcpp::Node {
public:
  explicit Talker(const rclcpp::NodeOptions & options) : Node("talker", options) {
    auto topic = declare_parameter<std::string>("topic", "chatter");
    publisher_ = create_publisher<std_msgs::msg::String>(topic, 10);
  }
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  %s
  rclcpp::spin(std::make_shared<Talker>(options));
}
"""


def talker(options: str) -> dict[str, Any]:
    (node,) = graph({"src/robot.cpp": PROGRAM % options})["nodes"]
    assert isinstance(node, dict)
    return node


def topics(options: str) -> list[str]:
    return [publisher["name"] for publisher in talker(options)["publishers"]]


def test_without_options_nothing_changes() -> None:
    assert topics("rclcpp::NodeOptions options;") == ["/chatter"]


def test_arguments_rename_as_a_command_line_does() -> None:
    """Source: ``rclcpp/node_options.cpp``: they become the node's own arguments, which win over the process's."""
    options = """
      rclcpp::NodeOptions options;
      options.arguments({"--ros-args", "-r", "chatter:=news", "-r", "__node:=herald", "-r", "__ns:=/town"});
    """
    assert talker(options)["name"] == "/town/herald"
    assert topics(options) == ["/town/news"]


def test_arguments_of_a_list_that_grows() -> None:
    options = """
      std::vector<std::string> arguments = {"--ros-args"};
      arguments.push_back("-r");
      arguments.push_back("chatter:=news");
      auto options = rclcpp::NodeOptions().arguments(arguments).use_intra_process_comms(true);
    """
    assert topics(options) == ["/news"]


def test_parameter_overrides_win_over_the_default() -> None:
    assert topics('auto options = rclcpp::NodeOptions().parameter_overrides({{"topic", "news"}});') == ["/news"]
    listed = 'auto options = rclcpp::NodeOptions().parameter_overrides({rclcpp::Parameter("topic", "news")});'
    assert topics(listed) == ["/news"]


def test_parameter_overrides_can_be_added_one_by_one() -> None:
    options = """
      rclcpp::NodeOptions options;
      options.append_parameter_override("rate", 5);
      options.append_parameter_override("topic", "news");
    """
    assert topics(options) == ["/news"]


def test_a_copy_of_options_is_an_object_of_its_own() -> None:
    options = """
      rclcpp::NodeOptions plain;
      rclcpp::NodeOptions changed(plain);
      changed.arguments({"--ros-args", "-r", "chatter:=news"});
      rclcpp::NodeOptions options(%s);
    """
    assert topics(options % "changed") == ["/news"]
    assert topics(options % "plain") == ["/chatter"]


def test_arguments_of_the_process_can_be_ignored() -> None:
    launch = """
        from launch import LaunchDescription
        from launch_ros.actions import Node

        def generate_launch_description():
            return LaunchDescription([Node(package='robot', executable='robot', name='herald')])
    """
    built = """
        cmake_minimum_required(VERSION 3.8)
        project(robot)
        add_executable(robot src/robot.cpp)
        install(TARGETS robot DESTINATION lib/robot)
    """

    def name(options: str) -> str:
        files = {"src/robot.cpp": PROGRAM % options, "launch/x.launch.py": launch, "CMakeLists.txt": built}
        (node,) = graph(files, "--launch", "robot/launch/x.launch.py")["nodes"]
        return str(node["name"])

    assert name("rclcpp::NodeOptions options;") == "/herald"
    assert name("auto options = rclcpp::NodeOptions().use_global_arguments(false);") == "/talker"
