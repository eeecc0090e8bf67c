"""PKG014: CMake targets that lack the packages whose headers their sources include."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import manifest, write_files

HEAD = "project(robot)\nfind_package(ament_cmake REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
FINDS = "find_package(nav_msgs REQUIRED)\n"
TRACKER = "add_executable(tracker src/tracker.cpp)\n"
GENERATES = 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/TopSpeed.msg")\n'
NEEDS = "<depend>rclcpp</depend><depend>nav_msgs</depend>"
OWN = "#include <robot/msg/top_speed.hpp>\n"
ODOMETRY = '#include <rclcpp/rclcpp.hpp>\n#include "nav_msgs/msg/odometry.hpp"\n'
ADDS = (
    'function(add_part name)\n{0} "" "" "LINKS"{1})\nadd_executable(${{name}} src/${{name}}.cpp)\n'
    "target_link_libraries(${{name}} ${{PART_LINKS}})\nendfunction()\n"
)
"""A function that is given what a target is linked with."""


@pytest.fixture
def lacking(findings):
    """What is found of a CMakeLists.txt and the source of a tracker: line, message, help."""

    def run(text: str, source: str = ODOMETRY, **files: str) -> list[tuple[int, str, str]]:
        package = {
            "package.xml": manifest(build_type="ament_cmake", more=NEEDS),
            "CMakeLists.txt": HEAD + text,
            "src/tracker.cpp": source + "int main() {}\n",
            "msg/TopSpeed.msg": "float64 value\n",
        }
        found = findings("PKG014", **package | files)
        return [(finding.place.line, finding.message, finding.help) for finding in found]

    return run


def test_a_package_that_is_found_and_not_given(lacking):
    assert lacking(FINDS + TRACKER + "ament_target_dependencies(tracker rclcpp)\n") == [
        (
            6,
            "target 'tracker' includes headers of package nav_msgs, and nothing gives it their folder: the build stops "
            "at <nav_msgs/msg/odometry.hpp>",
            "write ament_target_dependencies(tracker nav_msgs)",
        )
    ]


def test_a_package_that_is_not_found_either(lacking):
    ((line, _, help),) = lacking(TRACKER + "target_link_libraries(tracker rclcpp::rclcpp yaml-cpp)\n")
    assert (line, help) == (
        5,
        "add find_package(nav_msgs REQUIRED), and write ament_target_dependencies(tracker nav_msgs)",
    )


def test_a_package_that_is_linked_by_its_name_alone_brings_no_headers(lacking):
    ((_, message, _),) = lacking(TRACKER + "target_link_libraries(tracker rclcpp nav_msgs yaml-cpp)\n")
    assert "these 2 packages: nav_msgs, rclcpp" in message


def test_a_variable_of_a_package_that_is_found(lacking):
    tracker = TRACKER + "target_link_libraries(tracker ${rclcpp_LIBRARIES} ${OpenCV_LIBS} ${SCAN_LIBRARY})\n"
    ((line, _, _),) = lacking("find_library(SCAN_LIBRARY scan)\n" + tracker)
    assert line == 6


@pytest.mark.parametrize(("begin", "end"), [("PARSE_ARGV 1 PART", ""), ("PART", " ${ARGN}")])
def test_what_a_function_is_given_under_a_keyword(lacking, begin, end):
    adds = ADDS.format(f"cmake_parse_arguments({begin}", end)
    ((_, message, _),) = lacking(FINDS + adds + "add_part(tracker LINKS rclcpp::rclcpp)\n")
    assert "package nav_msgs" in message


def test_targets_that_lack_the_same_are_one_finding(lacking):
    ((_, message, _),) = lacking(FINDS + TRACKER + "add_library(parts src/tracker.cpp)\n")
    assert message.endswith("another target lacks the same")


def test_headers_of_the_own_interfaces(lacking):
    ((line, message, help),) = lacking(GENERATES + TRACKER + "ament_target_dependencies(tracker rclcpp)\n", OWN)
    assert (line, "the interfaces of its own package" in message) == (6, True)
    assert help.endswith('target_link_libraries(tracker "${types}")')


def test_headers_of_another_package_of_the_workspace(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_files(
        tmp_path,
        {
            "arm/package.xml": manifest("arm", build_type="ament_cmake"),
            "arm/CMakeLists.txt": "project(arm)\nament_package()\n",
            "arm/include/arm/joints.hpp": "",
            "robot/package.xml": manifest(build_type="ament_cmake", more=NEEDS + "<depend>arm</depend>"),
            "robot/CMakeLists.txt": HEAD + TRACKER + "ament_target_dependencies(tracker rclcpp)\n",
            "robot/src/tracker.cpp": "#include <arm/joints.hpp>\nint main() {}\n",
            "archlint.toml": 'select = ["PKG014"]\n',
        },
    )
    (finding,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert "includes headers of package arm" in finding.message


@pytest.mark.parametrize(
    "text",
    [
        TRACKER + "ament_target_dependencies(tracker PUBLIC rclcpp nav_msgs)\n",
        TRACKER + "target_link_libraries(tracker PRIVATE rclcpp::rclcpp nav_msgs::nav_msgs__rosidl_typesupport_cpp)\n",
        TRACKER + "target_link_libraries(tracker ${nav_msgs_TARGETS})\n",
        TRACKER + "target_include_directories(tracker PUBLIC include ${nav_msgs_INCLUDE_DIRS})\n",
        "include_directories(${nav_msgs_INCLUDE_DIRS})\n" + TRACKER,
        "include_directories(/opt/ros/humble/include)\n" + TRACKER,
        TRACKER + "ament_target_dependencies(tracker ${DEPENDENCIES})\n",
        TRACKER + "ament_target_dependencies(tracker rclcpp nav2_msgs)\n",
        "find_package(somebody_elses REQUIRED)\n" + TRACKER + "target_link_libraries(tracker somebody_elses)\n",
        "find_package(tracking REQUIRED)\n" + TRACKER + "add_tracking(tracker)\n",
        "add_library(parts src/parts.cpp)\ntarget_link_libraries(parts ${nav_msgs_TARGETS})\n"
        + TRACKER
        + "target_link_libraries(tracker parts)\n",
        TRACKER + "ament_target_dependencies(traker nav_msgs)\n",
        "if(WITH_TRACKER)\n" + TRACKER + "endif()\n",
        "foreach(name ${NAMES})\nadd_executable(${name} src/tracker.cpp)\nendforeach()\n",
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_add_executable(tracker src/tracker.cpp)\n",
        TRACKER + "set_target_properties(tracker PROPERTIES INCLUDE_DIRECTORIES /usr/include/odometry)\n",
        TRACKER + "target_link_libraries(tracker ${SHARED_LIBRARIES})\n",
        TRACKER + "target_link_libraries(tracker ${TRACKING_TARGETS})\n",
        'set(CMAKE_CXX_FLAGS "-O2 -I/opt/odometry")\n' + TRACKER,
        "set_property(DIRECTORY APPEND PROPERTY INCLUDE_DIRECTORIES /opt/odometry)\n" + TRACKER,
        ADDS.format("cmake_parse_arguments(PARSE_ARGV 1 PART", "")
        + "add_part(tracker LINKS rclcpp::rclcpp ${nav_msgs_TARGETS})\n",
        ADDS.format("cmake_parse_arguments(PART", " ${ARGN}")
        + "add_part(tracker LINKS nav_msgs::nav_msgs__rosidl_typesupport_cpp rclcpp::rclcpp)\n",
        ADDS.format("read_arguments(PART", "") + "add_part(tracker LINKS ${nav_msgs_TARGETS})\n",
    ],
)
def test_what_gives_it_or_may(lacking, text):
    assert lacking(FINDS + text, "#include <nav_msgs/msg/odometry.hpp>\n") == []


@pytest.mark.parametrize(
    "text",
    [
        GENERATES + TRACKER + "rosidl_target_interfaces(tracker ${PROJECT_NAME} rosidl_typesupport_cpp)\n",
        GENERATES
        + "rosidl_get_typesupport_target(types ${PROJECT_NAME} rosidl_typesupport_cpp)\n"
        + TRACKER
        + 'target_link_libraries(tracker rclcpp::rclcpp "${types}")\n',
        GENERATES + TRACKER + "target_link_libraries(tracker ${PROJECT_NAME}__rosidl_typesupport_cpp)\n",
        GENERATES + TRACKER + "include_directories(${CMAKE_CURRENT_BINARY_DIR}/rosidl_generator_cpp)\n",
        GENERATES.replace("TopSpeed", "Other") + TRACKER,
    ],
)
def test_own_interfaces_that_are_there(lacking, text):
    assert lacking(text, OWN) == []


@pytest.mark.parametrize("name", ["foxy", "galactic"])
def test_where_all_packages_have_one_folder(lacking, name):
    assert lacking(FINDS + TRACKER, **{"README.md": f"Tested with ROS 2 {name}.\n"}) == []


@pytest.mark.parametrize(
    "source",
    [
        "#ifdef WITH_ODOMETRY\n#include <nav_msgs/msg/odometry.hpp>\n#endif\n",
        "// #include <nav_msgs/msg/odometry.hpp>\n",
        "#include <nav_tools/odometry.hpp>\n",
    ],
)
def test_what_is_not_sure_to_be_included(lacking, source):
    assert lacking(FINDS + TRACKER, source) == []
