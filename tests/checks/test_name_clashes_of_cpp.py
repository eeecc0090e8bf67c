"""NME004: C++ nodes that ``name=`` of a launch action reaches, and those that it does not."""

from __future__ import annotations

import pytest

from robot_package import manifest, node

CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(robot)
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
SOURCE = """\
#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  %s
  auto reader = std::make_shared<rclcpp::Node>("reader");
  auto driver = std::make_shared<rclcpp::Node>("driver");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(reader);
  executor.add_node(driver);
  executor.spin();
  return 0;
}
"""


@pytest.mark.parametrize(
    ("init", "renamed"),
    [
        ("rclcpp::init(argc, argv);", True),
        ("rclcpp::init(argc, argv, rclcpp::InitOptions());", True),
        ("rclcpp::init(0, nullptr);", False),
        ("rclcpp::init(0, NULL);", False),
        ("int none = 0; char ** words = nullptr; rclcpp::init(none, words);", False),
    ],
)
def test_a_program_that_keeps_the_command_line_to_itself(findings, init: str, renamed: bool):
    """Without ``argc`` and ``argv`` no remapping of launch arrives, so that both nodes keep their names."""
    files = {
        "src/talker.cpp": SOURCE % init,
        "CMakeLists.txt": CMAKE,
        "package.xml": manifest(build_type="ament_cmake"),
        "setup.py": "",
    }
    assert bool(findings("NME004", node(name="it"), **files)) is renamed


BLOCK = """\
#include "rclcpp/rclcpp.hpp"

class Mapper : public rclcpp::Node
{
public:
  Mapper() : Node("mapper") {}
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  int stack_size = 4096;
  rclcpp::Node::SharedPtr kept;
  {
    %s
  }
  auto node = std::make_shared<Mapper>();
  rclcpp::spin(node);
  return 0;
}
"""
READS = 'reader->declare_parameter("stack_size", 1); reader->get_parameter("stack_size", stack_size);'


@pytest.mark.parametrize(
    ("block", "clash"),
    [
        (f'auto reader = std::make_shared<rclcpp::Node>("mapper"); {READS}', False),
        (f'rclcpp::Node::SharedPtr reader = rclcpp::Node::make_shared("mapper"); {READS}', False),
        (f'auto reader = std::make_shared<rclcpp::Node>("mapper"); {READS} kept = reader;', True),
        (f'auto reader = new rclcpp::Node("mapper"); {READS}', True),
        (f'kept = std::make_shared<rclcpp::Node>("mapper"); {READS.replace("reader", "kept")}', True),
    ],
)
def test_a_node_is_gone_at_the_end_of_the_block_that_holds_it(findings, block: str, clash: bool):
    """A shared pointer of an inner block frees its node at the brace, before the next one is made."""
    files = {
        "src/talker.cpp": BLOCK % block,
        "CMakeLists.txt": CMAKE,
        "package.xml": manifest(build_type="ament_cmake"),
        "setup.py": "",
    }
    assert bool(findings("NME004", node(name="it"), **files)) is clash
    assert bool(findings("NME004", node(), **files)) is clash
