"""PKG004: shared libraries that CMake builds and does not install."""

from __future__ import annotations

import pytest

from robot_package import CMAKE

BUILD = """\
project(robot)
find_package(ament_cmake REQUIRED)
add_library(core SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
{}
ament_package()
"""
LINKED = "target_link_libraries(talker core)\n"
INSTALLED = LINKED + "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"


@pytest.fixture
def told(findings):
    """What is found where a library and a program are built so, as messages."""

    def run(lines: str) -> list[str]:
        files = {"package.xml": CMAKE, "src/core.cpp": "int core() {}\n", "src/talker.cpp": "int main() {}\n"}
        return [row.message for row in findings("PKG004", **files, **{"CMakeLists.txt": BUILD.format(lines)})]

    return run


@pytest.mark.parametrize(
    ("lines", "needed"),
    [
        (INSTALLED, "talker"),
        (INSTALLED.replace("talker core", "talker PRIVATE m core"), "talker"),
        ('rclcpp_components_register_node(core PLUGIN "robot::Core" EXECUTABLE core_node)\n', "core_node"),
        ('rclcpp_components_register_nodes(core "robot::Core")\n', "its components"),
    ],
)
def test_a_library_that_an_installed_program_needs(told, lines, needed):
    assert told(lines) == [f"the shared library 'core' is not installed, and '{needed}' needs it: that does not start"]


COMPONENT = 'rclcpp_components_register_node(core PLUGIN "robot::Core" EXECUTABLE core_node)\n'


@pytest.mark.parametrize(
    ("lines", "count"),
    [
        (COMPONENT, 1),
        ("list(APPEND ${PROJECT_NAME}_LIBRARIES core)\n" + COMPONENT, 0),
        ("install(TARGETS core DESTINATION lib)\n" + COMPONENT, 0),
        ("ament_auto_add_library(more SHARED src/more.cpp)\n" + COMPONENT, 1),
        (COMPONENT.replace("core PLUGIN", "more PLUGIN") + "ament_auto_add_library(more SHARED src/core.cpp)\n", 0),
    ],
)
def test_what_ament_auto_package_installs(findings, lines: str, count: int):
    build = BUILD.replace("ament_package", "ament_auto_package").format("find_package(ament_cmake_auto)\n" + lines)
    files = {"src/core.cpp": "int core() {}\n", "src/talker.cpp": "int main() {}\n", "src/more.cpp": "int more() {}\n"}
    assert len(findings("PKG004", **{"package.xml": CMAKE, "CMakeLists.txt": build}, **files)) == count


@pytest.mark.parametrize(
    "lines",
    [
        INSTALLED + "install(TARGETS core DESTINATION lib)\n",
        INSTALLED.replace("TARGETS talker", "TARGETS talker core"),
        LINKED,
        INSTALLED.replace("talker core", "talker m"),
        INSTALLED + "install(TARGETS ${libraries} DESTINATION lib)\n",
        INSTALLED + "install(FILES $<TARGET_FILE:core> DESTINATION lib)\n",
        INSTALLED + "install_all(core)\n",
        "set(CMAKE_INSTALL_RPATH ${CMAKE_BINARY_DIR})\n" + INSTALLED,
        "add_library(Acme::Acme SHARED IMPORTED)\n" + INSTALLED.replace("talker core", "talker Acme::Acme"),
        INSTALLED + "if(SHIPPED)\n  install(TARGETS core DESTINATION lib)\nendif()\n",
    ],
)
def test_a_library_that_is_installed_or_not_needed(told, lines):
    assert told(lines) == []


@pytest.mark.parametrize("kind", ["STATIC", "INTERFACE", ""])
def test_a_library_that_is_part_of_the_program(findings, kind):
    text = BUILD.format(INSTALLED).replace("core SHARED", f"core {kind}")
    files = {"package.xml": CMAKE, "src/core.cpp": "int core() {}\n", "src/talker.cpp": "int main() {}\n"}
    assert findings("PKG004", **files, **{"CMakeLists.txt": text}) == []
