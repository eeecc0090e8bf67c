"""PKG013 and LCH001: sources and scripts of a package of CMake that its build does nothing with."""

from __future__ import annotations

import pytest

from robot_package import CMAKE, TALKER_OF_CPP

MAIN = "#include <rclcpp/rclcpp.hpp>\n\nint main(int argc, char ** argv)\n{\n  rclcpp::init(argc, argv);\n}\n"
INSTALL = "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package()"
BUILT = TALKER_OF_CPP.replace("ament_package()", INSTALL)
SCRIPT = "#!/usr/bin/env python3\nimport rclpy\n\nif __name__ == '__main__':\n    rclpy.init()\n"


def files(command: str, **more: str) -> dict[str, str]:
    """A package with two sources of which one is compiled, a script that nothing installs, and a document."""
    own = {"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": BUILT, "src/talker.cpp": MAIN}
    own |= {"src/listener.cpp": MAIN, "scripts/drive.py": SCRIPT}
    return own | {"README.md": f"    ros2 run {command}\n"} | more


def test_a_source_that_no_target_compiles(findings):
    (told,) = findings("PKG013", **files("robot listener"))
    assert told.message == "ros2 run does not find 'listener': nothing compiles src/listener.cpp"
    assert told.help == "add a target: add_executable(listener src/listener.cpp), and install it"
    assert (told.place.file, told.place.line) == ("CMakeLists.txt", 7)
    assert [row.place.file for row in told.related] == ["README.md"]


@pytest.mark.parametrize(
    ("command", "help"),
    [
        ("robot drive.py", "add install(PROGRAMS scripts/drive.py DESTINATION lib/${PROJECT_NAME})"),
        ("robot drive", "add install(PROGRAMS scripts/drive.py DESTINATION lib/${PROJECT_NAME} RENAME drive)"),
    ],
)
def test_a_script_that_nothing_installs(findings, command, help):
    (told,) = findings("PKG013", **files(command))
    assert (told.message.partition(": ")[2], told.help) == ("nothing installs scripts/drive.py", help)


def test_several_are_one_finding(findings):
    (told,) = findings("PKG013", **files("robot listener\n    ros2 run robot drive.py"))
    assert told.message.endswith("; another file is left out, too")


@pytest.mark.parametrize(
    ("command", "more"),
    [
        ("robot talker", {}),
        ("robot speaker", {}),
        ("other listener", {}),
        ("robot listener", {"src/listener.cpp": MAIN.replace("int main", "int run")}),
        ("robot listener", {"src/listener.cpp": MAIN, "src/all.cpp": '#include "listener.cpp"\n'}),
        ("robot listener", {"CMakeLists.txt": BUILT.replace("src/talker.cpp", "src/talker.cpp src/listener.cpp")}),
        ("robot listener", {"CMakeLists.txt": BUILT.replace("add_exe", "file(GLOB ALL src/*.cpp)\nadd_exe", 1)}),
        ("robot listener", {"CMakeLists.txt": BUILT.replace("ament_package()", "add_all_nodes(src)\nament_package()")}),
        ("robot drive.py", {"scripts/drive.py": "SPEED = 1.0\n"}),
        ("robot drive.py", {"CMakeLists.txt": BUILT + "install(DIRECTORY scripts/ DESTINATION lib/robot)\n"}),
        ("robot drive.py", {"other/drive.py": SCRIPT}),
    ],
)
def test_what_is_built_or_may_be(findings, command, more):
    assert findings("PKG013", **files(command, **more)) == []


def test_a_launch_file_that_starts_such_a_source(findings):
    launch = "<node pkg='robot' exec='listener'/>"
    (told,) = findings("LCH001", launch, **files("robot listener"))
    assert told.message == (
        "package 'robot' installs no executable 'listener'; src/listener.cpp exists, and no target compiles it"
    )
    assert told.help == "add a target for it to CMakeLists.txt, and install it"
    assert findings("PKG013", launch, **files("robot listener")) == []
