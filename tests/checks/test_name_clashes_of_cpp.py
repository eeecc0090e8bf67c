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
