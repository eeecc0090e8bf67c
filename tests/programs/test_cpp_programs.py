"""Executables and components of C++: what starts them, and what launch files make of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from tests.cpp_nodes import NODE, graph
from tests.robot_package import manifest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, check

TALKER = """
#ifndef ROBOT__TALKER_HPP_
#define ROBOT__TALKER_HPP_
#include "rclcpp/rclcpp.hpp"
namespace robot {
class Talker : public rclcpp::Node {
public:
  explicit Talker(const rclcpp::NodeOptions & options);
private:
  void on_timer();
  rclcpp::TimerBase::SharedPtr timer_;
};
}
#endif
"""
SOURCE = """
#include "robot/talker.hpp"
#include "std_msgs/msg/string.hpp"
#include "rclcpp_components/register_node_macro.hpp"
namespace robot {
Talker::Talker(const rclcpp::NodeOptions & options) : Node("talker", options) {
  create_publisher<std_msgs::msg::String>(declare_parameter<std::string>("topic", "chatter"), 10);
  timer_ = create_wall_timer(500ms, std::bind(&Talker::on_timer, this));
}
void Talker::on_timer() { create_client<std_srvs::srv::Trigger>("late"); }
}
RCLCPP_COMPONENTS_REGISTER_NODE(robot::Talker)
"""
MAIN = """
#include "robot/talker.hpp"
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<robot::Talker>(rclcpp::NodeOptions()));
}
"""
CMAKE = """
project(robot)
add_library(talker_component SHARED src/talker.cpp)
{more}
install(TARGETS talker_component)
install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})
"""
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode

def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        name='container', namespace='', package='rclcpp_components', executable='component_container',
        composable_node_descriptions=[ComposableNode(
            package='robot', plugin='robot::Talker', name='speaker', namespace='left',
            parameters=[{'topic': 'news'}], remappings=[('late', '/early')])])])
"""
FILES = {"include/robot/talker.hpp": TALKER, "src/talker.cpp": SOURCE, "launch/robot.launch.py": LAUNCH}


def ends(node: dict[str, Any]) -> list[str]:
    return [end["name"] for kind in ("publishers", "clients") for end in node[kind]]


def test_an_executable_is_linked_with_what_its_headers_declare() -> None:
    cmake = CMAKE.format(more="add_executable(talk src/main.cpp)\ntarget_link_libraries(talk talker_component)")
    nodes = graph({**FILES, "src/main.cpp": MAIN, "CMakeLists.txt": cmake})["nodes"]
    [node] = [node for node in nodes if "talk" in node["executables"]]
    assert (node["name"], ends(node), node["timers"][0]["period_s"]) == ("/talker", ["/chatter", "/late"], 0.5)
    assert node["publishers"][0]["file"] == "robot/src/talker.cpp"


def test_an_executable_that_a_component_is_given() -> None:
    register = 'rclcpp_components_register_node(talker_component PLUGIN "robot::Talker" EXECUTABLE talk)'
    nodes = graph({**FILES, "CMakeLists.txt": CMAKE.format(more=register)})["nodes"]
    assert [(node["class"], "talk" in node["executables"], ends(node)) for node in nodes] == [
        ("Talker", True, ["/chatter", "/late"])
    ]


def test_a_component_runs_under_the_name_and_with_the_parameters_of_the_launch_file() -> None:
    files = {**FILES, "CMakeLists.txt": CMAKE.format(more="")}
    nodes = graph(files, "--launch", "robot/launch/robot.launch.py")["nodes"]
    [node] = [node for node in nodes if node["class"] == "Talker"]
    assert (node["name"], ends(node)) == ("/left/speaker", ["/left/news", "/early"])


READS = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
namespace tools {
template<typename T>
void read(rclcpp::Node::SharedPtr node, const std::string & name, T fallback, T & value) {
  node->declare_parameter(name, rclcpp::ParameterValue(fallback));
  node->get_parameter(name, value);
}
template<typename MessageT>
auto publisher(rclcpp::Node & node, const std::string & topic) { return node.create_publisher<MessageT>(topic, 1); }
}
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { timer_ = create_wall_timer(1s, std::bind(&Robot::start, this)); }
  void start() {
    tools::read(shared_from_this(), "on", on_, on_);
    tools::read(shared_from_this(), "topic", topic_, topic_);
    if (on_) { tools::publisher<std_msgs::msg::String>(*this, topic_); }
  }
private:
  bool on_ = false;
  std::string topic_ = "chatter";
};
int main(int argc, char ** argv) { rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_what_a_function_writes_into_a_reference_its_caller_has() -> None:
    [node] = graph({"src/robot.cpp": READS})["nodes"]
    [end] = node["publishers"]
    assert (end["name"], end["type"], end["parameter"]) == ("/chatter", "std_msgs/msg/String", "topic")


OVERLOADED = """
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
class Camera : public rclcpp::Node {
public:
  explicit Camera(const rclcpp::NodeOptions & options) : Node("camera", "/left", options) { start(); }
  Camera(const std::string & name, const std::string & ns, const rclcpp::NodeOptions & options)
  : Node(name, ns, options) { start(); }
  void start() { create_publisher<sensor_msgs::msg::Image>("~/image", 10); }
};
RCLCPP_COMPONENTS_REGISTER_NODE(Camera)
"""


def test_a_component_is_made_by_the_constructor_that_takes_the_options_alone() -> None:
    [node] = graph({"src/camera.cpp": OVERLOADED})["nodes"]
    assert (node["name"], ends(node)) == ("/left/camera", ["/left/camera/image"])


def test_a_component_is_not_made_by_the_constructors_that_copy_or_move_it() -> None:
    copied = "  explicit Talker(const Talker &) = default;\n  explicit Talker(Talker &&) = default;\n"
    header = TALKER.replace("private:", copied + "private:")
    sources = {"include/robot/talker.hpp": header, "src/talker.cpp": SOURCE}
    cmake = CMAKE.format(more="add_executable(talker src/main.cpp)\ntarget_link_libraries(talker talker_component)")
    made = graph({**sources, "src/main.cpp": MAIN, "CMakeLists.txt": cmake})["nodes"]
    assert {node["name"] for node in made} == {"/talker"}


UTILITIES = """
#include "rclcpp_lifecycle/lifecycle_node.hpp"
namespace nav2_util {
class LifecycleNode : public rclcpp_lifecycle::LifecycleNode {
public:
  LifecycleNode(const std::string & name, const std::string & ns, const rclcpp::NodeOptions & options)
  : rclcpp_lifecycle::LifecycleNode(name, ns, options) { declare_parameter("bond", 0.1); }
};
}
"""
SERVER = """
#include "nav2_util/lifecycle_node.hpp"
class Server : public nav2_util::LifecycleNode {
public:
  Server() : nav2_util::LifecycleNode("server", "", rclcpp::NodeOptions()) { }
};
int main() { rclcpp::spin(std::make_shared<Server>()->get_node_base_interface()); }
"""


def server_with(files: dict[str, str]) -> dict[str, Any]:
    [node] = graph({"src/server.cpp": SERVER, **files})["nodes"]
    return node


def test_a_library_that_the_workspace_builds_is_read():
    node = server_with(
        {
            "../nav2_util/package.xml": manifest("nav2_util", build_type="ament_cmake"),
            "../nav2_util/include/nav2_util/lifecycle_node.hpp": UTILITIES,
        }
    )
    assert (node["name"], node["lifecycle"]) == ("/server", True)
    assert [parameter["name"] for parameter in node["parameters"]] == ["bond"]


def test_a_class_of_that_name_in_another_package_is_not_the_library_s():
    node = server_with({"include/nav2_util/lifecycle_node.hpp": UTILITIES})
    assert node["class"] == "LifecycleNode", "what derives from the library's is not known to be this"


IN_TWO_FILES = {
    "src/camera.hpp": """
#pragma once
#include "rclcpp/rclcpp.hpp"
class Camera : public rclcpp::Node {
public:
  Camera();
  template <typename T> void param(std::string name, T initial, T & value, std::string text = std::string());
  std::string param(std::string name, std::vector<float> & value);
  int gpu_ = -1;
  std::vector<float> region_;
};
template <typename T> void Camera::param(std::string name, T initial, T & value, std::string text) {
  declare_parameter(name, rclcpp::ParameterValue(initial));
  get_parameter(name, value);
}
""",
    "src/camera.cpp": """
#include "camera.hpp"
Camera::Camera() : Node("camera") { param("gpu", -1, gpu_); param("region", region_); }
std::string Camera::param(std::string name, std::vector<float> & value) {
  declare_parameter(name, rclcpp::ParameterValue("[]"));
  return "";
}
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Camera>()); }
""",
}


def test_methods_that_share_a_name_in_a_header_and_a_source() -> None:
    [node] = graph(IN_TWO_FILES)["nodes"]
    types = {row["name"]: row["type"] for row in node["parameters"]}
    assert types["region"] == "string" and types["gpu"] != "string"


ALIKE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
namespace left {
class Arm : public rclcpp::Node {
public:
  explicit Arm(const rclcpp::NodeOptions & options) : Node("left", options) { }
};
}
namespace right {
class Arm : public rclcpp::Node {
public:
  explicit Arm(const rclcpp::NodeOptions & options) : Node("right", options) { }
};
}
RCLCPP_COMPONENTS_REGISTER_NODE(left::Arm)
RCLCPP_COMPONENTS_REGISTER_NODE(right::Arm)
"""
CONTAINER = """
<launch><node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">
<composable_node pkg="robot" plugin="{}"/></node_container></launch>
"""


def loaded(plugin: str, files: dict[str, str]) -> dict[str, Any]:
    [node] = [
        node
        for node in graph(
            {"launch/it.launch.xml": CONTAINER.format(plugin), "CMakeLists.txt": CMAKE.format(more=""), **files},
            "--launch",
            "robot/launch/it.launch.xml",
        )["nodes"]
        if node["package"] == "robot"
    ]
    return node


def test_of_two_components_that_are_called_alike_in_one_file_neither_starts_the_other():
    node = loaded("left::Arm", {"src/arms.cpp": ALIKE})
    assert (node["name"], node["class"]) == (None, None)
    alone = ALIKE.replace("RCLCPP_COMPONENTS_REGISTER_NODE(right::Arm)", "")
    assert loaded("left::Arm", {"src/arms.cpp": alone})["class"] is None, "there is another class of that name"
    left, right = alone.split("namespace right")
    other = f"{left}namespace right{right.replace('Arm', 'Leg').replace('left::Leg', 'left::Arm')}"
    assert loaded("left::Arm", {"src/arms.cpp": other})["name"] == "/left"


def test_of_a_component_that_two_files_register_nobody_knows_what_it_starts():
    arm = ALIKE.partition("namespace right")[0] + "RCLCPP_COMPONENTS_REGISTER_NODE(left::Arm)\n"
    assert loaded("left::Arm", {"src/arms.cpp": arm})["name"] == "/left"
    node = loaded("left::Arm", {"src/arms.cpp": arm, "src/older.cpp": arm.replace('"left"', '"older"')})
    assert (node["name"], node["class"]) == (None, None)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        ("A<" * 30_000, "too many '<' to analyse (more than 20,000)"),
        ("// " + "x" * 1_000_000, "the file is too large to analyse: 1000 kB, the limit is 1000 kB"),
    ],
)
def test_a_source_that_is_not_read_is_reported(tmp_path: Path, more: str, message: str):
    (tmp_path / "src").mkdir()
    (tmp_path / "package.xml").write_text(manifest(build_type="ament_cmake"))
    (tmp_path / "src/node.cpp").write_text(NODE % "" + more)
    (tmp_path / "src/generated.cpp").write_text("int x[] = {1, 2};\n" + "// " + "x" * 1_000_000)  # no word of rclcpp
    findings = check(Request((str(tmp_path),), Settings(), cached=False, jobs=1)).findings
    assert [(finding.code, finding.message) for finding in findings] == [("LNT002", message)]


@pytest.mark.parametrize("collected", ["aux_source_directory(src SOURCES)", "file(GLOB SOURCES src/*.cpp)"])
def test_the_sources_of_a_folder(collected: str) -> None:
    main = (
        'int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(rclcpp::Node::make_shared("a")); }'
    )
    cmake = f"""
    cmake_minimum_required(VERSION 3.8)
    project(robot)
    find_package(rclcpp REQUIRED)
    {collected}
    add_executable(started ${{SOURCES}})
    install(TARGETS started DESTINATION lib/${{PROJECT_NAME}})
    """
    [node] = graph({"src/main.cpp": f'#include "rclcpp/rclcpp.hpp"\n{main}\n', "CMakeLists.txt": cmake})["nodes"]
    assert (node["name"], node["executables"]) == ("/a", ["started"])
