"""PKG015: commands that CMake and ament refuse as they are written."""

from __future__ import annotations

import pytest

from robot_package import CMAKE

HEAD = "project(robot)\nfind_package(ament_cmake REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
TALKER = "add_executable(talker src/talker.cpp)\n"
GIVEN = TALKER + "ament_target_dependencies(talker rclcpp)\n"
FINDS = "find_package(rosidl_default_generators REQUIRED)\n"
TYPES = FINDS + 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")\n'


@pytest.fixture
def refused(findings):
    """What is found in a CMakeLists.txt: the line, counted from its fourth, and the message."""

    def run(text: str, **files: str) -> list[tuple[int, str]]:
        written = {
            "package.xml": CMAKE,
            "src/talker.cpp": "int main() {}\n",
            "msg/Speed.msg": "float64 value\n",
            "CMakeLists.txt": f"{HEAD}{text}ament_package()\n",
        }
        return [(row.place.line - 3, row.message) for row in findings("PKG015", **written, **files)]

    return run


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        (
            GIVEN + "target_link_libraries(talker PRIVATE m)\n",
            3,
            "'talker' is linked with PUBLIC, PRIVATE or INTERFACE in one command and without it in another: the build "
            "stops",
        ),
        (
            TALKER + "target_link_libraries(talker PUBLIC rclcpp::rclcpp)\ntarget_link_libraries(talker m)\n",
            3,
            "'talker' is linked with PUBLIC, PRIVATE or INTERFACE in one command and without it in another: the build "
            "stops",
        ),
        (TALKER + TALKER, 2, "add_executable() makes a target 'talker', and there is one: the build stops"),
        (
            TYPES + "add_executable(${PROJECT_NAME} src/talker.cpp)\n",
            3,
            "'robot' is the name of two targets: of a program or library, and of the package's interfaces: the build "
            "stops",
        ),
        ("install(DIRECTORY launch)\n", 1, "install() has no DESTINATION: the build stops"),
        ("install(FILES a.yaml\n  DESTINATON share/robot)\n", 2, "install() has no DESTINATION: the build stops"),
        (
            FINDS + 'rosidl_generate_interfaces("msg/Speed.msg")\n',
            2,
            "rosidl_generate_interfaces() is given the file 'msg/Speed.msg' first, where the name of its target "
            "belongs: the build stops",
        ),
        (
            FINDS + "rosidl_generate_interfaces(${PROJECT_NAME} msg/Speed.msg DEPENDS std_msgs)\n",
            2,
            "rosidl_generate_interfaces() takes no 'DEPENDS', so that it is looked for as a file: the build stops",
        ),
        (
            "ament_python_install_package(${PROJECT_NAME})\n",
            1,
            "ament_python_install_package() installs 'robot', which has no __init__.py: the build stops",
        ),
        (
            'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")\n',
            1,
            "rosidl_generate_interfaces() is a command of 'rosidl_default_generators', which no find_package() finds: "
            "the build stops from iron on",
        ),
        (
            "if(BUILD_TESTING)\n  ament_add_gtest(test_talker src/talker.cpp)\nendif()\n",
            2,
            "ament_add_gtest() is a command of 'ament_cmake_gtest', which no find_package() finds: the build stops",
        ),
    ],
)
def test_what_cmake_stops_at(refused, text, line, message):
    assert refused(text) == [(line, message)]


def test_the_python_package_of_the_interfaces(refused):
    found = refused(TYPES + "ament_python_install_package(robot)\n", **{"robot/__init__.py": ""})
    assert [line for line, _ in found] == [3]
    assert "rosidl_generate_interfaces() installs one of its own" in found[0][1]


def test_a_misspelt_destination_is_pointed_at(findings):
    text = f"{HEAD}install(FILES package.xml DESTINATON share/robot)\nament_package()\n"
    [found] = findings("PKG015", **{"package.xml": CMAKE, "CMakeLists.txt": text})
    assert text.splitlines()[3][found.place.column - 1 : found.place.end_column - 1] == "DESTINATON"


@pytest.mark.parametrize(
    "text",
    [
        # one signature, or none that is known
        TALKER + "ament_target_dependencies(talker PUBLIC rclcpp)\ntarget_link_libraries(talker PUBLIC m)\n",
        GIVEN + "target_link_libraries(talker m)\n",
        GIVEN + "target_link_libraries(talker PUBLIC ${libraries})\n",
        TALKER + "ament_target_dependencies(talker SYSTEM PUBLIC rclcpp)\ntarget_link_libraries(talker PUBLIC m)\n",
        GIVEN + "add_library(b src/talker.cpp)\ntarget_link_libraries(b PUBLIC m)\n",
        GIVEN + "if(FAST)\n  target_link_libraries(talker PUBLIC m)\nendif()\n",
        TALKER + "target_link_libraries(talker)\ntarget_link_libraries(talker PUBLIC m)\n",
        # one target of each name
        "if(FAST)\n  add_executable(talker src/talker.cpp)\nelse()\n  add_executable(talker src/talker.cpp)\nendif()\n",
        "foreach(name a b)\n  add_executable(${name} src/talker.cpp)\nendforeach()\n",
        TYPES + TALKER,
        # a destination, or what may be one
        "install(DIRECTORY launch TYPE DATA)\n",
        "set(to DESTINATION share/robot)\ninstall(DIRECTORY launch ${to})\n",
        "install(DIRECTORY launch ${UNKNOWN})\n",
        TALKER + "install(TARGETS talker)\n",
        # options that there are
        FINDS + 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg" DEPENDENCIES std_msgs SKIP_INSTALL)\n',
        # commands that a package brings which is found
        "find_package(ament_lint_auto REQUIRED)\nament_lint_auto_find_test_dependencies()\nament_add_gtest(t a.cpp)\n",
        "find_package(acme REQUIRED)\nament_add_gtest(t src/talker.cpp)\n",
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_add_executable(a a.cpp)\n",
        "if(WITH_TYPES)\n  rosidl_generate_interfaces(${PROJECT_NAME} msg/Speed.msg)\nendif()\n",
    ],
)
def test_what_cmake_takes(refused, text):
    assert refused(text) == []


def test_a_package_of_python_that_is_there_or_is_made(refused):
    here = {"robot/__init__.py": ""}
    assert refused("ament_python_install_package(robot)\n", **here) == []
    assert refused("ament_python_install_package(robot PACKAGE_DIR src/robot)\n", **{"src/robot/__init__.py": ""}) == []
    made = "configure_file(init.py.in robot/__init__.py)\nament_python_install_package(robot)\n"
    assert refused(made) == []


def test_rclcpp_brings_the_generators_of_interfaces_in_humble(refused):
    text = 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")\n'
    assert refused(text, Dockerfile="FROM ros:humble\n") == []
    [(_, message)] = refused(text, Dockerfile="FROM ros:jazzy\n")
    assert message.endswith("which no find_package() finds: the build stops")


def test_a_build_without_rclcpp_has_no_generators_in_humble(findings):
    text = 'project(robot)\nfind_package(ament_cmake REQUIRED)\nrosidl_generate_interfaces(robot "msg/Speed.msg")\n'
    files = {"package.xml": CMAKE, "msg/Speed.msg": "float64 value\n", "Dockerfile": "FROM ros:humble\n"}
    assert len(findings("PKG015", **files, **{"CMakeLists.txt": f"{text}ament_package()\n"})) == 1
