"""PKG012: targets and packages that CMake commands name and that are not there."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import CMAKE, manifest

HEAD = "project(robot)\nfind_package(ament_cmake REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
TALKER = "add_executable(talker src/talker.cpp)\n"
GENERATES = 'set(files "msg/Speed.msg")\nrosidl_generate_interfaces(${PROJECT_NAME} ${files})\n'
SOURCE = "int main() {}\n"


@pytest.fixture
def names(findings):
    """What is found in a CMakeLists.txt, as messages, each with its help."""

    def run(text: str) -> list[tuple[str, str]]:
        text = f"{HEAD}{text}ament_package()\n"
        found = findings("PKG012", **{"package.xml": CMAKE, "src/talker.cpp": SOURCE, "CMakeLists.txt": text})
        return [(finding.message, finding.help) for finding in found]

    return run


@pytest.mark.parametrize(
    ("text", "message", "help"),
    [
        (
            TALKER + "ament_target_dependencies(takler rclcpp)\n",
            "ament_target_dependencies() is given 'takler', a target that there is not: the build stops; did you mean "
            "'talker'?",
            "write 'talker'",
        ),
        (
            TALKER + "install(TARGETS talker listener DESTINATION lib/${PROJECT_NAME})\n",
            "install() is given 'listener', a target that there is not: the build stops",
            "remove it, or write a target that there is: talker; the package has no source left for another one",
        ),
        (
            TALKER + "add_library(parts src/talker.cpp)\nament_target_dependencies(talker parts rclcpp)\n",
            "'parts' is a target, and ament_target_dependencies() takes one target and then packages: the build stops",
            "call ament_target_dependencies() for 'parts', too",
        ),
        (
            TALKER + "ament_target_dependencies(talker rclcpp nav_msgs)\n",
            "ament_target_dependencies() is given 'nav_msgs', which no find_package() has found: the build stops",
            "take it off, for no source here includes a header of it; or add find_package(nav_msgs REQUIRED)",
        ),
        (
            TALKER + "ament_target_dependencies(talker rclcpp arm_msgs)\n",
            "ament_target_dependencies() is given 'arm_msgs', which no find_package() has found: the build stops",
            "take it off, for no source here includes a header of it; or add find_package(arm_msgs REQUIRED)",
        ),
        (
            TALKER + "find_package(sparks REQUIRED)\nament_target_dependencies(talker sparks arm_msgs)\n",
            "ament_target_dependencies() is given 'arm_msgs', which no find_package() has found: the build stops",
            "take it off, for no source here includes a header of it; or add find_package(arm_msgs REQUIRED)",
        ),
        (
            TALKER + "target_link_libraries(talker ${PROJECT_NAME})\n",
            "target_link_libraries() is given 'robot', a target that there is not: the build stops",
            "remove it, or write a target that there is: talker; the package has no source left for another one",
        ),
        (
            TALKER + GENERATES + "ament_target_dependencies(talker rclcpp Speed)\n",
            "'Speed' is an interface of this package, and ament_target_dependencies() takes packages: the build stops",
            "take it off: a target gets the types of its own package with rosidl_get_typesupport_target()",
        ),
        (
            "find_package(rosidl_default_generators REQUIRED)\n"
            "rosidl_generate_interfaces(${PROJECT_NAME} msg/Speed.msg DEPENDENCIES geometry_msgs)\n",
            "rosidl_generate_interfaces() is given 'geometry_msgs', which no find_package() has found: the build stops",
            "add find_package(geometry_msgs REQUIRED)",
        ),
        (
            TALKER + "install(TARGETS talker DESTINATION lib/{PROJECT_NAME})\n",
            "CMake takes 'lib/{PROJECT_NAME}' as it is written: no variable is read",
            "write ${PROJECT_NAME} with a '$' and braces",
        ),
        (
            TALKER + "install(TARGETS talker DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n",
            "nothing sets the variable 'CATKIN_PACKAGE_BIN_DESTINATION', so that there is nothing in its place here",
            "catkin of ROS 1 sets it: write lib/${PROJECT_NAME}",
        ),
        (
            TALKER + "install(TARGETS talker DESTINATION lib/${PACKAGE_NAME})\n",
            "nothing sets the variable 'PACKAGE_NAME', so that there is nothing in its place here",
            "write '${PROJECT_NAME}'",
        ),
        (
            "ament_export_dependencies(rclcpp nav_msgsgeometry_msgs)\n",
            "ament_export_dependencies() is given 'nav_msgsgeometry_msgs', which is no package, but the names of two",
            "write 'nav_msgs' and 'geometry_msgs', with a space between them",
        ),
        (
            "if(BUILD_TESTING)\n  target_link_libraries(check rclcpp)\nendif()\n",
            "target_link_libraries() is given 'check', a target that there is not: the build stops",
            "add the add_executable() or add_library() that makes it",
        ),
    ],
)
def test_what_is_not_there(names, text, message, help):
    assert names(text) == [(message, help)]


@pytest.mark.parametrize(
    "files",
    [
        {"src/talker.cpp": '#include "nav_msgs/msg/odometry.hpp"\nint main() {}\n'},
        {"include/robot/talker.hpp": "#include <nav_msgs/msg/odometry.hpp>\n"},
        {"package.xml": CMAKE.replace("</package>", "<depend>nav_msgs</depend></package>")},
    ],
)
def test_a_package_that_the_sources_need(findings, files: dict[str, str]):
    text = f"{HEAD}{TALKER}ament_target_dependencies(talker rclcpp nav_msgs)\nament_package()\n"
    common = {"package.xml": CMAKE, "src/talker.cpp": SOURCE, "CMakeLists.txt": text}
    (found,) = findings("PKG012", **common | files)
    assert found.help == "add find_package(nav_msgs REQUIRED)"


def test_one_finding_for_all_that_was_copied(names):
    copied = "ament_target_dependencies(costmap rclcpp nav_msgs)\ninstall(TARGETS costmap mapping talker merger)\n"
    assert names(TALKER + copied) == [
        (
            "ament_target_dependencies() is given 'costmap', a target that there is not: the build stops; so it is "
            "with 'mapping', 'merger'",
            "remove them, or write a target that there is: talker; the package has no source left for another one",
        )
    ]


@pytest.mark.parametrize(
    "sources",
    [
        {"src/costmap_node.cpp": "void map() {}\n", "src/mapping/Mapping.cpp": "void map() {}\n"},
        {"src/start.cpp": "int main(int argc, char ** argv) {}\n"},
    ],
)
def test_a_target_that_the_sources_are_there_for(findings, sources):
    text = "ament_target_dependencies(costmap rclcpp nav_msgs)\ninstall(TARGETS mapping)\n"
    files = {"src/talker.cpp": SOURCE, "CMakeLists.txt": f"{HEAD}{TALKER}{text}ament_package()\n", **sources}
    found = findings("PKG012", **{"package.xml": CMAKE, **files})
    assert [finding.help for finding in found] == [
        "add the add_executable() or add_library() that makes it",
        "take it off, for no source here includes a header of it; or add find_package(nav_msgs REQUIRED)",
        "add the add_executable() or add_library() that makes it",
    ]


def test_one_finding_for_a_name(names):
    ((message, _),) = names(TALKER + "ament_target_dependencies(node rclcpp)\ninstall(TARGETS node)\n")
    assert message.endswith("the build stops; another command is given it, too")


@pytest.mark.parametrize(
    "text",
    [
        TALKER
        + "ament_target_dependencies(talker PUBLIC rclcpp rcutils)\ninstall(TARGETS talker EXPORT all LIBRARY)\n",
        "foreach(name a b)\n  add_executable(${name} src/talker.cpp)\nendforeach()\ninstall(TARGETS a b)\n",
        "set(NAME talker)\nadd_library(${NAME} src/talker.cpp)\ntarget_compile_features(talker PUBLIC cxx_std_17)\n",
        "add_executable(${UNKNOWN} src/talker.cpp)\ninstall(TARGETS talker)\n",
        "make_programs(talker)\ninstall(TARGETS talker)\n",
        "if(WITH_GUI)\n  install(TARGETS gui)\nendif()\n",
        "install(TARGETS talker)\nreturn()\n",
        "FetchContent_MakeAvailable(json)\ninstall(TARGETS json)\n",
        "install(TARGETS TARGETS talker)\n" + TALKER,
        TALKER + "find_package(my_tools REQUIRED)\nament_target_dependencies(talker nav_msgs)\n",
        "acme_auto_package()\ntarget_link_libraries(talker yaml-cpp)\n",
        TALKER + "robot_find_all()\nament_target_dependencies(talker nav_msgs)\n",
        TALKER + "ament_auto_find_build_dependencies()\nament_target_dependencies(talker nav_msgs)\n",
        TALKER + "find_package(PCL)\nament_target_dependencies(talker PCL Eigen3)\n",
        TALKER + "ament_target_dependencies(talker Eigen3)\n",
        TALKER + "find_package(arm_tools REQUIRED)\nament_target_dependencies(talker arm_msgs)\n",
        TALKER + "add_library(robot src/talker.cpp)\ntarget_link_libraries(talker robot yaml-cpp)\n",
        TALKER + GENERATES + "target_link_libraries(talker robot)\n",
        TALKER + GENERATES + "find_package(Speed REQUIRED)\nament_target_dependencies(talker Speed)\n",
        TALKER + "target_link_libraries(talker yaml-cpp)\ntarget_link_libraries(rclcpp::rclcpp INTERFACE x)\n",
    ],
)
def test_what_is_there_or_may_be(names, text):
    assert names(text) == []


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("project(robot_arm)\nfind_package(ament_cmake REQUIRED)\nament_package()\n", 1),
        ("set(NAME arm)\nproject(${NAME} CXX)\nfind_package(ament_cmake_auto REQUIRED)\nament_auto_package()\n", 2),
        ("project(robot)\nproject(arm)\ninclude(more.cmake)\nament_package()\n", 2),
    ],
)
def test_a_project_that_is_not_called_like_its_package(findings, text, line):
    (finding,) = findings("PKG012", **{"package.xml": CMAKE, "CMakeLists.txt": text})
    assert "and this is package 'robot': ament_package() stops the build" in finding.message
    assert (finding.place.line, finding.help) == (line, "write project(robot)")


FINDS = "find_package(ament_cmake REQUIRED)\n"


@pytest.mark.parametrize(
    "text",
    [
        f"project(robot)\n{FINDS}ament_package()\nproject(parts)\n",
        f"project(robot VERSION 1.0.0)\n{FINDS}ament_package()\n",
        "project(robot_arm)\n",
        f"project(${{NAME}})\n{FINDS}ament_package()\n",
        f"{FINDS}if(ALONE)\n  project(arm)\nendif()\nament_package()\n",
    ],
)
def test_a_project_of_the_right_name_or_one_that_is_not_known(findings, text):
    assert findings("PKG012", **{"package.xml": CMAKE, "CMakeLists.txt": text}) == []


@pytest.fixture
def beside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The lines told in a CMakeLists.txt of a package beside ``tools``, one of Python."""
    monkeypatch.chdir(tmp_path)

    def run(line: str, data_files: str = "") -> list[tuple[str, int]]:
        files = {
            "tools/package.xml": manifest("tools"),
            "tools/setup.py": f"from setuptools import setup\nsetup(name='tools', packages=['tools'], {data_files})\n",
            "robot/package.xml": CMAKE,
            "robot/CMakeLists.txt": f"{HEAD}{line}\nament_package()\n",
            "archlint.toml": 'select = ["PKG012"]\n',
        }
        for name, text in files.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
        return [(finding.message, finding.place.line) for finding in found]

    return run


@pytest.mark.parametrize("name", ["ament_index_python", "tools"])
def test_a_package_of_python_has_nothing_for_cmake(beside, name):
    message = f"find_package() is given '{name}', a package of Python, which has no file for CMake: the build stops"
    assert beside(f"find_package({name} REQUIRED)") == [(message, 4)]


@pytest.mark.parametrize(
    ("line", "data_files"),
    [
        ("find_package(tools)", ""),
        ("if(WITH_TOOLS)\n  find_package(tools REQUIRED)\nendif()", ""),
        ("find_package(rclpy REQUIRED)", ""),
        ("find_package(tools REQUIRED)", "data_files=[('share/tools/cmake', ['toolsConfig.cmake'])]"),
    ],
)
def test_a_package_that_cmake_may_find(beside, line, data_files):
    assert beside(line, data_files) == []


INSTALLED = TALKER + "install(TARGETS talker DESTINATION lib/${{{}}})\n"


@pytest.mark.parametrize("name", ["PROJECT_N", "PROJECTNAME", "project_name", "PROJET_NAME"])
def test_a_variable_that_is_almost_the_name_of_the_project(names, name):
    assert names(INSTALLED.format(name)) == [
        (f"nothing sets the variable '{name}', so that there is nothing in its place here", "write '${PROJECT_NAME}'")
    ]


@pytest.mark.parametrize(
    "text",
    [
        INSTALLED.format("PROJECT_NAME"),
        "set(project_name robot)\n" + INSTALLED.format("project_name"),
        "foreach(project_name robot arm)\n" + INSTALLED.format("project_name") + "endforeach()\n",
        "include(names.cmake)\n" + INSTALLED.format("project_name"),
        "if(project_name)\n" + INSTALLED.format("project_name") + "endif()\n",
        INSTALLED.format("PROJECT_BINARY_DIR"),
        INSTALLED.format("ARM_NAME"),
        "set(PACKAGE_NAME robot)\n" + INSTALLED.format("PACKAGE_NAME"),
        "find_package(catkin)\n" + INSTALLED.format("CATKIN_PACKAGE_BIN_DESTINATION"),
        TALKER + "install(TARGETS talker DESTINATION lib)\nmessage(STATUS ${PACKAGE_NAME})\n",
        TALKER + GENERATES.replace("files})", "files} DEPENDENCIES builtin_interfaces)"),
    ],
)
def test_a_variable_that_may_be_set(names, text):
    assert names(text) == []


LINTS = "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\n  {}()\nendif()\nament_package()\n"


@pytest.mark.parametrize(
    ("text", "wrong", "meant"),
    [
        (
            LINTS.format("ament_lint_auto_find_test_files"),
            "ament_lint_auto_find_test_files",
            "ament_lint_auto_find_test_dependencies",
        ),
        (
            TALKER + "ament_target_dependancies(talker rclcpp)\n",
            "ament_target_dependancies",
            "ament_target_dependencies",
        ),
        ("ament_packge()\n", "ament_packge", "ament_package"),
        (
            'rosidl_generate_interface(robot "msg/Speed.msg")\n',
            "rosidl_generate_interface",
            "rosidl_generate_interfaces",
        ),
    ],
)
def test_a_command_that_is_almost_one_of_ament(names, text, wrong, meant):
    assert names(text)[0] == (
        f"there is no command {wrong}(): the build stops; did you mean {meant}()?",
        f"write {meant}",
    )


@pytest.mark.parametrize(
    "text",
    [
        LINTS.format("ament_lint_auto_find_test_dependencies"),
        "macro(ament_packages)\n  ament_package()\nendmacro()\nament_packages()\n",
        "if(COMMAND ament_packages)\n  ament_packages()\nendif()\nament_package()\n",
        "if(WITH_GUI)\n  ament_packages()\nendif()\nament_package()\n",
        "rclcpp_components_register_nodes(talker)\nament_package()\n",
        "ament_add_benchmark(talker)\nament_package()\n",
    ],
)
def test_a_command_that_there_is_or_may_be(names, text):
    assert [row for row in names(text) if "command" in row[0]] == []


INSTALLS = TALKER + "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"


def test_a_package_that_nothing_registers(findings):
    text = HEAD + INSTALLS
    (found,) = findings("PKG012", **{"package.xml": CMAKE, "src/talker.cpp": SOURCE, "CMakeLists.txt": text})
    assert found.message == "nothing calls ament_package(): ros2 run and launch do not find the package 'robot'"
    assert (found.place.line, found.help) == (5, "write ament_package() at the end of this file")


@pytest.mark.parametrize(
    "text",
    [
        HEAD + INSTALLS + "ament_package()\n",
        HEAD + INSTALLS + "if(WITH_ROS)\n  ament_package()\nendif()\n",
        HEAD + INSTALLS + "robot_package(talker)\n",
        HEAD.replace("ament_cmake ", "ament_cmake_auto ") + INSTALLS + "ament_auto_package()\n",
        HEAD.replace("find_package(ament_cmake REQUIRED)\n", "") + INSTALLS,
        HEAD + INSTALLS + "install(FILES robot DESTINATION share/ament_index/resource_index/packages)\n",
        HEAD + INSTALLS + "include(elsewhere/ends.cmake)\n",
    ],
)
def test_a_package_that_something_registers_or_may(findings, text):
    files = {"package.xml": CMAKE, "src/talker.cpp": SOURCE, "CMakeLists.txt": text}
    assert [found for found in findings("PKG012", **files) if "ament_package" in found.message] == []


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("find_package(robot REQUIRED)\n" + GENERATES, 1),
        ("find_package(std_msgs REQUIRED)\n" + GENERATES, 0),
        ("find_package(robot)\n" + GENERATES, 0),
        ("set(CMAKE_MODULE_PATH ${CMAKE_SOURCE_DIR}/cmake)\nfind_package(robot REQUIRED)\n" + GENERATES, 0),
        ("find_package(robot REQUIRED)\n", 0),  # a library of the system may be called so
    ],
)
def test_a_package_that_looks_for_itself(names, text, told):
    message = "find_package() is given 'robot', this package itself, which is not installed yet: a clean build stops"
    assert [row[0] for row in names(text)] == [message] * told


def test_a_package_that_is_declared_by_another_name(findings):
    declared = CMAKE.replace("<export>", "<depend>geometry_msgs</depend>\n<export>")
    text = f"{HEAD}find_package(geometry_mgs REQUIRED)\nament_package()\n"
    (found,) = findings("PKG012", **{"package.xml": declared, "CMakeLists.txt": text})
    assert found.message.endswith("the build stops; did you mean 'geometry_msgs'?")
    assert findings("PKG012", **{"package.xml": CMAKE, "CMakeLists.txt": text}) == []
    both = text.replace("ament_package", "find_package(geometry_msgs REQUIRED)\nament_package")
    assert findings("PKG012", **{"package.xml": declared, "CMakeLists.txt": both}) == []


BARE = "project(robot)\ninstall(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package()\n"


def test_a_build_that_finds_no_package(findings):
    (found,) = findings("PKG012", **{"package.xml": CMAKE, "CMakeLists.txt": BARE})
    assert found.message.startswith("nothing brings the command ament_package(): the build stops")
    assert (found.place.line, found.help) == (3, "add find_package(ament_cmake REQUIRED) below project()")


@pytest.mark.parametrize(
    "line",
    [
        FINDS,
        "find_package(ament_cmake_auto REQUIRED)\n",
        "include(cmake/packages.cmake)\n",
        "macro(ament_package)\nendmacro()\n",
        "acme_setup()\n",
        "if(WITH_ROS)\n  find_package(ament_cmake REQUIRED)\nendif()\n",
    ],
)
def test_what_may_bring_the_commands_of_ament(findings, line):
    build = BARE.replace("install(", f"{line}install(")
    assert findings("PKG012", **{"package.xml": CMAKE, "CMakeLists.txt": build}) == []


def test_a_package_that_another_build_takes_in(findings):
    outer = f"project(all)\n{FINDS}add_subdirectory(robot)\nament_package()\n"
    files = {"package.xml": CMAKE.replace("<name>robot<", "<name>all<"), "CMakeLists.txt": outer}
    assert findings("PKG012", **files, **{"robot/package.xml": CMAKE, "robot/CMakeLists.txt": BARE}) == []
