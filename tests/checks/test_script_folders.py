"""PKG013: programs that are installed where ros2 run and launch do not look."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import CMAKE, SETUP, TALKER, manifest

RIGHT = "[develop]\nscript_dir=$base/lib/robot\n[install]\ninstall_scripts=$base/lib/robot\n"
TOOL = "def main():\n    print('a tool')\n"


@pytest.mark.parametrize(
    ("text", "file", "where"),
    [
        ("", "setup.py", "is installed in bin"),
        ("[metadata]\nname = robot\n", "setup.py", "is installed in bin"),
        ("[develop]\nscript_dir=$base/lib/robot\n", "setup.py", "is installed in bin"),
        (RIGHT.replace("lib/robot", "lib/old"), "setup.cfg", "is installed in lib/old"),
    ],
)
def test_programs_that_nobody_finds(findings, text, file, where):
    (told,) = findings("PKG013", **{"setup.cfg": text})
    assert where in told.message and "they want lib/robot" in told.message
    assert told.place.file == file


MARKED = SETUP.replace("data_files=[", "data_files=[('share/ament_index/resource_index/packages', ['resource/old']), ")


def test_a_package_that_is_indexed_under_two_names_is_found_under_both(findings):
    old = {"setup.cfg": RIGHT.replace("lib/robot", "lib/old"), "resource/old": ""}
    assert findings("PKG013", **old, **{"setup.py": MARKED}) == []
    assert len(findings("PKG013", **old)) == 1


@pytest.mark.parametrize(
    "files",
    [
        {"setup.cfg": RIGHT},
        {"setup.cfg": RIGHT.replace("install_scripts", "install-scripts")},
        {"setup.cfg": RIGHT.replace("=$base", " = $base") + "[tool:pytest]\naddopts = -q\n"},
        {"setup.cfg": RIGHT.replace("$base/lib/robot", "$base/libexec")},
        {"setup.cfg": "no section\n"},
        {"setup.cfg": "", "robot/talker.py": TOOL, "launch/it.launch.xml": "<launch/>"},
        {"setup.cfg": "", "setup.py": SETUP + "OPTIONS = {'install': {'install_scripts': '$base/lib/robot'}}\n"},
        {"setup.cfg": "", "package.xml": manifest(build_type="ament_cmake")},
    ],
)
def test_programs_that_are_found_or_may_be(findings, files):
    assert findings("PKG013", **files) == []


def test_a_tool_that_a_launch_file_starts_is_a_program(findings):
    launch = '<node pkg="robot" exec="talker"/>'
    (told,) = findings("PKG013", launch, **{"setup.cfg": "", "robot/talker.py": TOOL})
    assert told.message.startswith("'talker' is installed in bin")
    assert TALKER != TOOL


NO_PROGRAMS = SETUP.replace("'talker = robot.talker:main'", "")
OF_ANOTHER = RIGHT.replace("lib/robot", "lib/old")


def test_a_package_without_programs_that_names_the_folder_of_another(findings):
    """Nothing is installed there yet; the next one to add a program will not find it."""
    (told,) = findings("PKG013", **{"setup.py": NO_PROGRAMS, "setup.cfg": OF_ANOTHER})
    assert (told.place.file, told.place.line, told.severity) == ("setup.cfg", 4, Severity.INFO)
    assert told.message.startswith("programs of the package would be installed in lib/old")


@pytest.mark.parametrize(
    "files",
    [
        {"setup.py": NO_PROGRAMS, "setup.cfg": RIGHT},
        {"setup.py": NO_PROGRAMS, "setup.cfg": ""},
        {"setup.py": "from tools import scripts\n" + NO_PROGRAMS.replace("[]", "scripts()"), "setup.cfg": OF_ANOTHER},
        {"setup.cfg": OF_ANOTHER, "robot/talker.py": TOOL},
    ],
)
def test_packages_without_programs_for_ros(findings, files):
    assert findings("PKG013", **files) == []


# ------------------------------------------------------------------------------------------------ what CMake builds

NODE = """#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<rclcpp::Node>("driver"));
}
"""
STARTED = '<node pkg="robot" exec="driver"/>'
DOCUMENT = {"README.md": "Start it:\n\n    ros2 run robot driver\n"}


def built(lines: str, **files: str) -> dict[str, str]:
    """A package of CMake with the program ``driver``."""
    start = "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nadd_executable(driver src/driver.cpp)\n"
    cmake = f"{start}{lines}\ninstall(DIRECTORY launch DESTINATION share/robot)\nament_package()\n"
    return {"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake, "src/driver.cpp": NODE} | files


@pytest.mark.parametrize(
    ("line", "where"),
    [
        ("install(TARGETS driver)", "bin"),
        ("install(TARGETS driver DESTINATION bin)", "bin"),
        ("install(TARGETS driver DESTINATION ${CMAKE_INSTALL_BINDIR})", "bin"),
        ("install(TARGETS driver DESTINATION lib/rbot)", "lib/rbot"),
        ("install(TARGETS driver ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)", "bin"),
        ("install(TARGETS driver RUNTIME DESTINATION lib/robot DESTINATION bin)", "bin"),
        ("install(TARGETS driver LIBRARY DESTINATION lib/robot)", "bin"),  # that is for libraries alone
    ],
)
def test_a_target_that_is_installed_elsewhere(findings, line, where):
    (told,) = findings("PKG013", STARTED, **built(line))
    assert (
        told.message == f"'driver' is installed in {where}, where ros2 run and launch do not look: they want lib/robot"
    )
    assert (told.place.file, told.place.line, told.place.column) == ("CMakeLists.txt", 4, 17)
    assert [(row.place.line, row.message) for row in told.related] == [(3, "it is built here")]
    assert findings("LCH001", STARTED, **built(line)) == []
    assert len(findings("PKG013", **built(line), **DOCUMENT)) == 1


def test_a_node_among_the_libraries_is_found_by_nobody(findings):
    (told,) = findings("PKG013", **built("install(TARGETS driver EXPORT all DESTINATION lib)"))
    assert told.message.startswith("'driver' is installed in lib, where")
    tool = {"src/driver.cpp": "int main() { return 0; }\n"}
    assert findings("PKG013", **built("install(TARGETS driver DESTINATION lib)", **tool)) == []


def test_a_target_that_is_not_installed(findings):
    (told,) = findings("PKG013", **built(""), **DOCUMENT)
    assert told.message == "'driver' is built and not installed: ros2 run does not find it"
    assert (told.place.line, told.help) == (3, "add install(TARGETS driver DESTINATION lib/${PROJECT_NAME})")
    assert findings("PKG013", STARTED, **built(""), **DOCUMENT) == []
    (launched,) = findings("LCH001", STARTED, **built(""))
    assert launched.message == "package 'robot' builds the executable 'driver' and does not install it"


def test_the_programs_of_one_folder_are_one_finding(findings):
    lines = "add_executable(other src/driver.cpp)\ninstall(TARGETS driver other DESTINATION lib)"
    (told,) = findings("PKG013", **built(lines))
    assert told.message.endswith("they want lib/robot; another program is out of sight, too")


@pytest.mark.parametrize(
    "lines",
    [
        "install(TARGETS driver DESTINATION lib/${PROJECT_NAME})",
        "install(TARGETS driver DESTINATION lib/robot/)",
        "install(TARGETS driver RUNTIME DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/robot LIBRARY DESTINATION lib)",
        "install(TARGETS driver DESTINATION ${CMAKE_INSTALL_LIBDIR}/${PROJECT_NAME})",
        "install(TARGETS driver LIBRARY DESTINATION lib RUNTIME DESTINATION bin DESTINATION lib/robot)",
        "install(TARGETS driver DESTINATION ${WHERE})",
        "install(TARGETS driver DESTINATION bin)\ninstall(TARGETS driver DESTINATION lib/robot)",
        "set(ALL driver)\ninstall(TARGETS ${ALL} DESTINATION lib/robot)",
        "install(TARGETS ${UNKNOWN} DESTINATION lib/robot)",
        "install(PROGRAMS $<TARGET_FILE:driver> DESTINATION lib/robot)",
        "acme_install_nodes(driver)",
        "ament_auto_package()",
        "set_target_properties(driver PROPERTIES RUNTIME_OUTPUT_DIRECTORY out)",
        "if(WITH_DRIVER)\ninstall(TARGETS driver DESTINATION lib/robot)\nendif()",
    ],
)
def test_a_target_that_is_found_or_may_be(findings, lines):
    assert findings("PKG013", STARTED, **built(lines), **DOCUMENT) == []
    assert findings("LCH001", STARTED, **built(lines), **DOCUMENT) == []


def test_a_program_that_only_some_builds_make(findings):
    lines = "if(DEMOS)\nadd_executable(demo src/driver.cpp)\nendif()\ninstall(TARGETS driver DESTINATION lib/robot)"
    assert findings("LCH001", '<node pkg="robot" exec="demo"/>', **built(lines)) == []


def test_a_component_installs_its_program_itself(findings):
    lines = (
        'add_library(part SHARED src/part.cpp)\nrclcpp_components_register_node(part PLUGIN "a::B" EXECUTABLE alone)'
    )
    assert findings("LCH001", '<node pkg="robot" exec="alone"/>', **built(lines, **{"src/part.cpp": ""})) == []
