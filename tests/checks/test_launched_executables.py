"""LCH001: executables that a launch file starts and that are not installed."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from robot_package import CMAKE, CMAKE_TESTS, SCRIPTS, SETUP, TALKER, manifest, node

TARGETS = "install(TARGETS ${n} DESTINATION lib/robot)\n"


@pytest.mark.parametrize(
    ("cmake", "found"),
    [
        ("project(robot)\nadd_subdirectory(gone)\n" + SCRIPTS, 0),
        ("project(robot)\nmake_node(driver)\n" + SCRIPTS, 0),  # an unknown command may build it
        ("project(robot)\nforeach(n ${NODES})\nadd_executable(${n})\nendforeach()\n" + SCRIPTS, 0),
        ("project(robot)\nforeach(n driver arm)\nadd_executable(${n})\n" + TARGETS + "endforeach()\n" + SCRIPTS, 0),
        ("project(robot)\nforeach(n driver arm)\nadd_executable(${n})\nendforeach()\n" + SCRIPTS, 1),
        ("project(robot)\nadd_subdirectory(src)\n" + SCRIPTS, 0),
        ("project(robot)\ninstall(DIRECTORY nodes/ DESTINATION lib/robot)\n" + SCRIPTS, 0),
        ("project(robot)\n" + SCRIPTS + CMAKE_TESTS, 1),
        ("project(driver)\n" + SCRIPTS, 1),  # a project is no executable
        ("project(robot)\ninstall(DIRECTORY scripts/ DESTINATION lib/robot)\n", 1),
        ("project(robot)\nament_python_install_package(robot SCRIPTS_DESTINATION lib/robot)\n" + SCRIPTS, 1),
    ],
)
def test_what_a_build_with_cmake_leaves_open(findings, cmake, found):
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": "", "setup.cfg": "[develop]\n"}
    files |= {
        "src/CMakeLists.txt": "set(n driver)\nadd_executable(driver driver.cpp)\n" + TARGETS,
        "nodes/driver": "",
        "scripts/drive.py": "",
    }
    assert len(findings("LCH001", node(exec="driver"), **files)) == found


def test_a_library_for_which_cmake_is_told_by_names_of_its_own_where_things_go(findings):
    """No program comes of ``include(GNUInstallDirs)``; it is a package of ROS that has one of that name."""
    cmake = """\
        project(robot)
        include(GNUInstallDirs)
        add_library(robot SHARED src/arm.cpp)
        install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
        install(TARGETS robot LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
        install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
        """
    files = {
        "CMakeLists.txt": cmake,
        "package.xml": CMAKE,
        "setup.py": "",
        "src/arm.cpp": "",
        "include/robot/arm.hpp": "",
    }
    (told,) = findings("LCH001", node(exec="spawner"), **files)
    assert told.message == "package 'robot' installs no executable 'spawner'; package 'controller_manager' of ROS does"
    assert told.help == "start it from package 'controller_manager'"


def test_a_destination_that_is_not_known(findings):
    """It may be the folder in which launch looks, unless it begins otherwise."""
    cmake = "project(robot)\ninstall(DIRECTORY nodes/ DESTINATION {})\n" + SCRIPTS
    for folder, found in {"${GONE}": 0, "lib/${GONE}": 0, "share/${GONE}": 1, "include/robot-${GONE}": 1}.items():
        files = {"CMakeLists.txt": cmake.format(folder), "package.xml": CMAKE, "setup.py": "", "nodes/driver": ""}
        assert len(findings("LCH001", node(exec="driver"), **files)) == found, folder


@pytest.mark.parametrize(
    ("files", "build"),
    [
        (
            {
                "CMakeLists.txt": "project(robot)\n# TODO: later\n# add_executable(driver src/driver.cpp)\n" + SCRIPTS,
                "package.xml": CMAKE,
                "setup.py": "",
            },
            "CMakeLists.txt",
        ),
        ({"setup.py": SETUP.replace("['talker =", "[\n# 'driver = robot.driver:main',\n'talker =")}, "setup.py"),
    ],
)
def test_a_program_that_is_commented_out_in_the_build_is_information(findings, files, build: str):
    """Whoever took it out knows that the launch file does not start it now."""
    (told,) = findings("LCH001", node(exec="driver"), **files)
    assert told.message == f"package 'robot' installs no executable 'driver': its lines in {build} are a comment"
    assert told.severity is Severity.INFO
    (told,) = findings("LCH001", node(exec="steerer"), **files)
    assert told.severity is Severity.ERROR


@pytest.mark.parametrize(
    ("module", "help"),
    [
        ("robot.driver", "remove the node, or take the marks of the comment away"),
        ("robot.engine", "remove the node: that line is of a module 'robot.engine', which does not exist"),
    ],
)
def test_a_program_in_a_comment_whose_module_is_gone(findings, module: str, help: str):
    setup = SETUP.replace("['talker =", f"[\n# 'driver = {module}:main',\n'talker =")
    (told,) = findings("LCH001", node(exec="driver"), **{"setup.py": setup, "robot/driver.py": "def main(): ..."})
    assert told.help == help


@pytest.mark.parametrize(
    ("package", "help"),
    [
        ("turtlesim", "give this package a name of its own, so that launch finds that of ROS"),
        ("my_turtles", "start it from package 'turtlesim'"),
    ],
)
def test_a_package_that_hides_the_one_of_ros_with_its_name(findings, package, help):
    own = {"package.xml": manifest(package), "setup.py": SETUP.replace("robot", package)}
    (finding,) = findings("LCH001", node(pkg=package, exec="turtlesim_node"), **own)
    assert finding.help == help


@pytest.mark.parametrize(
    ("file", "executable", "severity"),
    [
        ("example", "main_node", Severity.INFO),  # it shows how a launch file is written
        ("ejemplo", "main_node", Severity.INFO),
        ("example", "tlaker", Severity.ERROR),  # what was meant is known
        ("it", "main_node", Severity.ERROR),
    ],
)
def test_a_launch_file_that_is_an_example(findings, file: str, executable: str, severity: Severity):
    text = f"<launch>{node(exec=executable)}</launch>"
    (told,) = findings("LCH001", **{f"launch/{file}.launch.xml": text})
    assert told.severity is severity


def test_an_executable_of_another_workspace(findings):
    assert findings("LCH001", node(pkg="nav2_amcl", exec="amcl")) == []


@pytest.mark.parametrize(
    ("package", "executable", "hint"),
    [
        ("gazebo_ros", "spawn_entity", "; did you mean 'spawn_entity.py'?"),
        ("rclcpp_components", "camera_container", ""),
        ("robot_localization", "ekf_nodes", "; did you mean 'ekf_node'?"),
    ],
)
def test_an_executable_that_a_package_of_ros_does_not_have(findings, package, executable, hint):
    (finding,) = findings("LCH001", node(pkg=package, exec=executable))
    assert finding.message == f"package '{package}' installs no executable '{executable}'{hint}"


@pytest.mark.parametrize(("executable", "file"), [("gazebo", "gazebo.launch.py"), ("gzserver", "gzserver.launch.py")])
def test_what_a_package_of_ros_has_a_launch_file_for(findings, executable: str, file: str):
    (told,) = findings("LCH001", node(pkg="gazebo_ros", exec=executable))
    assert (told.message, told.help) == (
        f"package 'gazebo_ros' installs no executable '{executable}'",
        f"include its {file}",
    )


@pytest.mark.parametrize(
    ("package", "executable"),
    [
        ("rclcpp_components", "component_container_event_cbg"),
        ("slam_toolbox", "decentralized_multirobot_slam_toolbox_node"),
        ("controller_manager", "spawner.py"),
        ("rviz2", "/opt/venv/bin/python"),
        ("rviz2", "$(var viewer)"),
        ("topic_tools", "anything"),
    ],
)
def test_an_executable_that_a_package_of_ros_has_or_may_have(findings, package, executable):
    assert findings("LCH001", '<arg name="viewer"/>' + node(pkg=package, exec=executable)) == []


HUMBLE = {"Dockerfile": "FROM osrf/ros:humble-desktop\n"}


@pytest.mark.parametrize(
    "files",
    [
        HUMBLE,
        {".github/workflows/build.yml": "jobs:\n  build:\n    container: ros:jazzy\n"},
        {"README.md": "Built with ROS 2 Humble.\n"},
    ],
)
def test_a_program_that_is_gone_in_the_distribution_that_the_workspace_is_for(findings, files):
    (finding,) = findings("LCH001", node(pkg="controller_manager", exec="spawner.py"), **files)
    assert finding.message == (
        "package 'controller_manager' installs no executable 'spawner.py' since Humble, which this workspace is for; "
        "did you mean 'spawner'?"
    )
    assert finding.help == "start one that it has: ros2_control_node, spawner, unspawner, hardware_spawner"


@pytest.mark.parametrize(
    ("executable", "files"),
    [
        ("spawner.py", {"Dockerfile": "FROM ros:foxy\n"}),
        ("spawner.py", {"README.md": "Runs with Foxy and Humble.\n"}),
        ("spawner", HUMBLE),
    ],
)
def test_a_program_that_some_distribution_of_the_workspace_has(findings, executable, files):
    assert findings("LCH001", node(pkg="controller_manager", exec=executable), **files) == []


def test_a_launch_file_that_asks_for_the_distribution(findings):
    launch = """\
import os

from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    actions = []
    if os.environ['ROS_DISTRO'] == 'foxy':
        actions.append(Node(package='controller_manager', executable='spawner.py'))
    else:
        actions.append(Node(package='controller_manager', executable='spawner'))
    return LaunchDescription(actions)
"""
    files = {"launch/arm.launch.py": launch}
    assert findings("LCH001", **HUMBLE, **files) == []
    assert len(findings("LCH001", **HUMBLE, **{"launch/arm.launch.py": launch.replace("ROS_DISTRO", "HAND")})) == 1


def test_a_package_of_ros_that_is_external(findings):
    files = {"archlint.toml": 'select = ["LCH001"]\nexternal = ["gazebo_ros"]\n'}
    assert findings("LCH001", node(pkg="gazebo_ros", exec="spawn_entity"), **files) == []


def test_a_package_that_was_renamed(findings):
    (finding,) = findings("LCH001", node(pkg="robto", exec="talker"))
    assert finding.message == "there is no package 'robto'; did you mean 'robot', which installs 'talker'?"
    assert finding.help == "start it from package 'robot'"


def test_where_the_share_folder_of_a_renamed_package_is_looked_for(findings):
    """Another name at the node alone would not be enough: launch fails at that folder as well."""
    inner = '<param from="$(find-pkg-share robto)/config/talker.yaml"/>'
    (finding,) = findings("LCH001", node("\n" + inner, pkg="robto", exec="talker"))
    assert [(row.place.line, row.message) for row in finding.related] == [(2, "its share folder is looked for here")]


def test_the_other_places_of_a_renamed_package_are_told_once(findings):
    """LCH004 does not say again what LCH001 shows, and nobody is to declare a package that is not there."""
    inner = node("\n" + '<param from="$(find-pkg-share robto)/config/talker.yaml"/>', pkg="robto", exec="talker")
    here = {"config/talker.yaml": "", "README.md": "", "robto_ros/.gitkeep": ""}
    assert findings("LCH004", inner, **here) == []
    assert [told.message for told in findings("PKG001", inner, **here) if "robto" in told.message] == []
    (told,) = findings(
        "LCH004", inner.replace("exec='talker'", "exec='tower'").replace('exec="talker"', 'exec="tower"')
    )
    assert told.message.startswith("there is no package 'robto'")


OF_TWO_WORDS = {"setup.py": SETUP.replace("talker =", "arm_talker =")}


def test_an_executable_of_one_package_that_is_started_from_none(findings):
    (finding,) = findings("LCH001", node(pkg="old_machine", exec="arm_talker"), **OF_TWO_WORDS)
    assert finding.message == "there is no package 'old_machine'; did you mean 'robot', which installs 'arm_talker'?"


@pytest.mark.parametrize(
    "files",
    [
        {"Dockerfile": "RUN git clone https://example.org/old_machine.git\n"},
        {"README.md": "First get https://example.org/old_machine\n"},
        {"robot.repos": "repositories:\n  old_machine:\n    type: git\n"},
    ],
)
def test_a_package_that_the_workspace_takes_from_elsewhere(findings, files):
    assert findings("LCH001", node(pkg="old_machine", exec="arm_talker"), **OF_TWO_WORDS, **files) == []


def test_a_name_with_a_space_behind_it(findings):
    (finding,) = findings("LCH001", node(pkg="nav2_amcl ", exec="amcl"))
    assert finding.message == "there is no package 'nav2_amcl ': its name has a space too many"
    assert finding.help == "start it from package 'nav2_amcl'"


@pytest.mark.parametrize("package", ["usb_cam", "camera_of_somebody"])
def test_a_launch_file_of_a_package_from_elsewhere_is_to_be_included(findings, package):
    (finding,) = findings("LCH001", node(pkg=package, exec="camera.launch.py"))
    assert finding.message == (
        f"'camera.launch.py' is a launch file, and no program: package '{package}' installs no executable of that name"
    )
    assert finding.help == 'include it instead: <include file="…"/>'


def test_a_name_that_only_stands_for_that_of_a_package(findings):
    (finding,) = findings("LCH001", node(pkg="your_package", exec="listener"))
    assert finding.message == ("there is no package 'your_package': the name only stands for that of a package")


CONTAINER = (
    '<node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">'
    '<composable_node pkg="{package}" plugin="arm::Arm" name="arm"/></node_container>'
)


@pytest.mark.parametrize(
    "files",
    [
        {"src/arm.cpp": "#include <rclcpp/rclcpp.hpp>\nRCLCPP_COMPONENTS_REGISTER_NODE(arm::Arm)\n"},
        {"CMakeLists.txt": 'rclcpp_components_register_nodes(arm_component "arm::Arm")\n', "package.xml": CMAKE},
    ],
)
def test_a_component_of_a_package_that_was_renamed(findings, files):
    (finding,) = findings("LCH001", CONTAINER.format(package="arm_driver"), **files)
    assert finding.message == "there is no package 'arm_driver'; did you mean 'robot', which registers 'arm::Arm'?"
    assert findings("LCH001", CONTAINER.format(package="robot"), **files) == []


def test_a_component_of_a_package_from_elsewhere(findings):
    assert findings("LCH001", CONTAINER.format(package="arm_driver")) == []


@pytest.mark.parametrize(("cmake", "found"), [("project(robot)\n", 1), ("install(PROGRAMS bin/talker TYPE BIN)\n", 0)])
def test_an_entry_of_a_setup_py_that_cmake_does_not_read(findings, cmake, found):
    files = {"CMakeLists.txt": cmake + SCRIPTS, "package.xml": CMAKE, "scripts/drive.py": ""}
    messages = [finding.message for finding in findings("LCH001", node(), **files)]
    assert messages == found * [
        "package 'robot' installs no executable 'talker': CMake builds it, and its setup.py is not read"
    ]


def test_an_entry_of_a_setup_py_beside_no_cmake_file_waits_for_the_build_type(findings):
    (told,) = findings("PKG011", node(), **{"package.xml": CMAKE})
    assert told.help == "write <build_type>ament_python</build_type>"
    assert findings("LCH001", node(), **{"package.xml": CMAKE}) == []
    assert len(findings("LCH001", node(), **{"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\n"})) == 1


ENTRIES = SETUP.replace("'talker =", "'arm_node = robot.arm_node:main', 'talker =")
BUILT_WITH_CMAKE = {
    "CMakeLists.txt": "project(robot)\n" + SCRIPTS,
    "package.xml": CMAKE,
    "setup.py": ENTRIES,
    "scripts/drive.py": "",
    "robot/arm_node.py": TALKER,
}


def test_the_entries_of_a_setup_py_that_cmake_does_not_read_are_one_finding(findings):
    started = f"{node()}\n{node(exec='arm_node')}\n{node(name='second')}"
    (told,) = findings("LCH001", started, **BUILT_WITH_CMAKE)
    assert told.message == (
        "package 'robot' installs none of these 2 executables: arm_node, talker: "
        "CMake builds it, and its setup.py is not read"
    )
    assert told.help.startswith("install the scripts in CMakeLists.txt, install(PROGRAMS")
    assert [(row.place.file, row.place.line) for row in told.related if "started" in row.message] == [
        ("launch/it.launch.xml", 2),
        ("launch/it.launch.xml", 3),
    ]


def test_a_script_that_cmake_installs_is_to_be_started_instead_of_an_entry_that_it_does_not_read(findings):
    cmake = "project(robot)\ninstall(PROGRAMS robot/arm_node.py DESTINATION lib/robot)\n"
    files = {"CMakeLists.txt": cmake + SCRIPTS, "setup.py": ENTRIES.replace("'arm_node =", "'gripper =")}
    (told,) = findings("LCH001", node(exec="gripper"), **BUILT_WITH_CMAKE | files)
    assert told.message.endswith("its setup.py is not read; robot/arm_node.py is installed as 'arm_node.py'")
    assert told.help == "start 'arm_node.py'"


def test_an_entry_that_cmake_does_not_read_is_not_offered(findings):
    (told,) = findings("LCH001", node(exec="gripper"), **BUILT_WITH_CMAKE)
    assert told.help == "add it to CMakeLists.txt, or start one that the package installs: drive.py"
    (told,) = findings("LCH001", node(exec="arm_node.py"), **BUILT_WITH_CMAKE)
    assert told.help == "install robot/arm_node.py in CMakeLists.txt"
    cmake = {"CMakeLists.txt": "project(robot)\ninstall(DIRECTORY launch DESTINATION share/robot)\n"}
    (told,) = findings("LCH001", node(exec="gripper"), **BUILT_WITH_CMAKE | cmake)
    assert told.help == "add it to CMakeLists.txt"


def test_a_script_of_the_name_without_node_is_the_one_to_start(findings):
    (told,) = findings("LCH001", node(exec="drive_node"), **BUILT_WITH_CMAKE)
    assert told.message == (
        "package 'robot' installs no executable 'drive_node'; scripts/drive.py is installed as 'drive.py'"
    )


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("class Tracker:\n    pass\n", "; robot/tracking.py is not installed and starts nothing"),
        ("try:\n    import rclpy\nexcept ImportError:\n    rclpy = None\n", "; robot/tracking.py is not installed and"),
        ("import rclpy\nrclpy.init()\n", "; robot/tracking.py exists but is not installed"),
        ("def run():\n    pass\ntracker = run()\n", "; robot/tracking.py exists but is not installed"),
        ("from robot.talker import main\n", "; robot/tracking.py exists but is not installed"),
        ("if __name__ == '__main__':\n    print()\n", "; robot/tracking.py exists but is not installed"),
    ],
)
def test_a_module_that_starts_nothing_needs_more_than_to_be_installed(findings, text: str, hint: str):
    (told,) = findings("LCH001", node(exec="tracking_node"), **{"robot/tracking.py": text})
    assert hint in told.message
    assert told.help.startswith("give it a main(), and install it in setup.py") == ("exists" not in hint)


@pytest.mark.parametrize(
    ("package", "executable"),
    [
        ("robto", "listener"),  # which no package here installs
        ("lighthouse", "talker"),  # called otherwise
        ("robot", "talker"),
    ],
)
def test_a_package_from_elsewhere(findings, package, executable):
    assert findings("LCH001", node(pkg=package, exec=executable)) == []


def test_a_package_that_a_manifest_declares_is_somewhere(findings):
    declared = manifest(more="<exec_depend>robto</exec_depend>")
    assert findings("LCH001", node(pkg="robto", exec="talker"), **{"package.xml": declared}) == []


def test_an_unknown_executable_is_named_with_the_near_one(findings):
    (found,) = findings("LCH001", node(exec="taker"))
    assert found.message == "package 'robot' installs no executable 'taker'; did you mean 'talker'?"
    assert found.help == "add it to setup.py, or start one that the package installs: talker"


def test_a_long_list_says_that_it_goes_on(findings):
    names = [f"talk{number}" for number in range(10)]
    entries = ", ".join(f"'{name} = robot.talker:main'" for name in names)
    (found,) = findings(
        "LCH001", node(exec="zebra"), **{"setup.py": SETUP.replace("'talker = robot.talker:main'", entries)}
    )
    assert found.help.endswith(f"that the package installs: {', '.join(names[:8])} and 2 more")


def test_another_name_of_the_same_file_is_the_one_to_start(findings):
    setup = SETUP.replace("'talker =", "'speak =")
    (found,) = findings("LCH001", node(exec="talker.py"), **{"setup.py": setup})
    assert found.message.endswith("no executable 'talker.py'; robot.talker is installed as 'speak'")
    assert found.help == "start 'speak'"
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE, "setup.py": ""}
    (found,) = findings("LCH001", node(exec="drive"), **files)
    assert found.message.endswith("; scripts/drive.py is installed as 'drive.py'")


def test_an_executable_of_another_package_of_the_workspace(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    launch = f"<launch>{node(exec='grip')}</launch>"
    texts = {"archlint.toml": 'select = ["LCH001"]', "robot/launch/it.launch.xml": launch}
    for name, executable in (("robot", "talker"), ("arm", "grip")):
        texts[f"{name}/package.xml"] = manifest(name)
        texts[f"{name}/setup.py"] = SETUP.replace("talker = robot.talker", f"{executable} = {name}.{executable}")
        texts[f"{name}/{name}/{executable}.py"] = TALKER
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    (found,) = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert found.message == "package 'robot' installs no executable 'grip'; package 'arm' installs it"
    assert found.help == "start it from package 'arm'"


def test_an_executable_whose_file_is_there(findings):
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE, "setup.py": ""}
    (found,) = findings("LCH001", node(exec="steer.py"), **files, **{"scripts/steer.py": TALKER})
    assert found.help == "install scripts/steer.py in CMakeLists.txt"


@pytest.mark.parametrize(
    ("scripts", "hint", "help"),
    [
        (
            ["track.py", "crack.py"],
            "; scripts/track.py exists but is not installed",
            "install it in CMakeLists.txt under",
        ),
        (["crack.py"], "; did you mean 'crack_node'?", "add it to"),
    ],
)
def test_a_file_of_that_name_is_nearer_than_another_node(findings, scripts, hint, help):
    cmake = "project(robot)\ninstall(PROGRAMS scripts/crack.py DESTINATION lib/robot RENAME crack_node)\n"
    files = {
        "CMakeLists.txt": cmake,
        "package.xml": CMAKE,
        "setup.py": "",
        **{f"scripts/{one}": TALKER for one in scripts},
    }
    (found,) = findings("LCH001", node(exec="track_node"), **files)
    assert found.message.endswith(f"'track_node'{hint}") and found.help.startswith(help)


@pytest.mark.parametrize(
    ("text", "hint", "help"),
    [
        ("", "; robot/tracking.py is empty", "remove the node, or write its program there"),
        (TALKER, "; robot/tracking.py exists but is not installed", "install it in setup.py under the name 'tracking'"),
    ],
)
def test_an_empty_file_is_no_program(findings, text: str, hint: str, help: str):
    (found,) = findings("LCH001", node(exec="tracking"), **{"robot/tracking.py": text})
    assert found.message.endswith(hint) and found.help.startswith(help)


def test_a_program_in_a_folder_below_is_not_found_by_launch(findings):
    cmake = "project(robot)\ninstall(DIRECTORY scripts DESTINATION lib/robot)\n"
    files = {"CMakeLists.txt": cmake, "package.xml": CMAKE, "setup.py": ""}
    files["scripts/drive.py"] = TALKER + "\nmain()\n"
    (found,) = findings("LCH001", node(exec="drive.py"), **files)
    assert found.message.endswith("'drive.py': it is installed as lib/robot/scripts")
    assert found.help == "install the content of the folder, with a trailing slash: install(DIRECTORY …/ …)"
    files["CMakeLists.txt"] = cmake.replace("scripts", "scripts/")
    assert findings("LCH001", node(exec="drive.py"), **files) == []


def test_a_script_that_cmake_installs_in_another_folder(findings):
    """Under its own name or another, in ``bin`` or in ``share``: launch looks in one folder."""
    cmake = "project(robot)\ninstall({} DESTINATION {})\n" + SCRIPTS
    files = {"package.xml": CMAKE, "setup.py": "", "scripts/steer.py": TALKER + "\nmain()\n", "scripts/drive.py": ""}
    for what, folder, where in (
        ("PROGRAMS scripts/steer.py", "bin", "bin"),
        ("PROGRAMS scripts/steer.py", "share/robot", "share/robot"),
        ("DIRECTORY scripts/", "${CMAKE_INSTALL_BINDIR}", "bin"),
    ):
        build = {"CMakeLists.txt": cmake.format(what, folder)}
        for executable in ("steer.py", "steer"):
            (told,) = findings("LCH001", node(exec=executable), **files, **build)
            assert told.message == (
                f"package 'robot' installs no executable '{executable}': "
                f"'steer.py' is installed in {where}, and launch looks in lib/robot"
            )
            assert (
                told.help == "install it by install(PROGRAMS … DESTINATION lib/${PROJECT_NAME}), and start 'steer.py'"
            )
    assert findings("LCH001", node(exec="drive.py"), **files, **build) == []


def test_a_script_among_the_data_of_a_setup_py(findings):
    setup = SETUP.replace("data_files=[", "data_files=[('bin', ['scripts/steer.py']), ")
    files = {"setup.py": setup, "scripts/steer.py": TALKER + "\nmain()\n"}
    (told,) = findings("LCH001", node(exec="steer.py"), **files)
    assert told.message.endswith(": 'steer.py' is installed in bin, and launch looks in lib/robot")
    assert told.help == "put it into the data_files of 'lib/robot' in setup.py, and start 'steer.py'"
    files["setup.py"] = setup.replace("'bin'", "'lib/robot'")
    assert findings("LCH001", node(exec="steer.py"), **files) == []


@pytest.mark.parametrize(
    ("install", "hint", "help"),
    [
        (
            "install(TARGETS driver DESTINATION bin)",
            "its 'driver' is installed in bin, where launch does not look",
            "install 'driver' with DESTINATION lib/${PROJECT_NAME}, and start that",
        ),
        (
            "",
            "it builds 'driver', and installs that nowhere",
            "add install(TARGETS driver DESTINATION lib/${PROJECT_NAME}) to CMakeLists.txt, and start 'driver'",
        ),
        ("install(TARGETS driver DESTINATION lib/robot)", None, None),
    ],
)
def test_the_one_program_of_a_package_is_out_of_sight(findings, install: str, hint: str | None, help: str | None):
    """It is no program to start instead, unless launch finds it."""
    cmake = f"project(robot)\nadd_executable(driver src/driver.cpp)\n{install}\nament_package()\n"
    files = {"package.xml": CMAKE, "setup.py": "", "CMakeLists.txt": cmake, "src/driver.cpp": ""}
    (told,) = findings("LCH001", node(exec="tower"), **files)
    plain = "package 'robot' installs no executable 'tower'"
    assert told.message == (f"{plain}; {hint}" if hint else plain)
    assert told.help == (help or "add it to CMakeLists.txt, or start one that the package installs: driver")


OLD_KEYWORD = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package='robot', node_executable='{}')])
"""


@pytest.mark.parametrize(
    ("executable", "dockerfile", "lines"),
    [("driver", "FROM ros:eloquent\n", [5]), ("talker", "FROM ros:eloquent\n", []), ("driver", "FROM ros:jazzy\n", [])],
)
def test_the_keyword_of_older_releases_names_an_executable_too(findings, executable, dockerfile, lines):
    """Where launch takes it no more, LCH005 is the finding of that line."""
    files = {"launch/old.launch.py": OLD_KEYWORD.format(executable), "Dockerfile": dockerfile}
    assert [told.place.line for told in findings("LCH001", **files)] == lines
    assert len(findings("LCH005", **files)) == ("jazzy" in dockerfile)


def test_an_executable_that_several_actions_start_is_one_finding(findings):
    twice = f"{node(exec='camera', name='left')}\n{node(exec='camera', name='right')}\n{node(exec='lidar')}"
    camera, lidar = findings("LCH001", twice, **{"launch/more.launch.xml": f"<launch>{node(exec='camera')}</launch>"})
    assert [(row.place.file, row.place.line) for row in camera.related] == [
        ("launch/it.launch.xml", 2),
        ("launch/more.launch.xml", 1),
    ]
    assert lidar.related == ()


def test_an_absolute_path_is_started_as_it_is(findings):
    assert findings("LCH001", node(exec="/opt/venv/bin/python", args="-m robot.talker")) == []
    assert len(findings("LCH001", node(exec="venv/bin/python", args="-m robot.talker"))) == 1


LAUNCH_FILE = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([])
"""


@pytest.mark.parametrize("file", ["launch/view.launch.py", "launch/view_robot.py"])
def test_a_launch_file_that_is_started_as_a_program_is_to_be_included(findings, file):
    name = file.rpartition("/")[2]
    (told,) = findings("LCH001", node(exec=name), **{file: LAUNCH_FILE})
    assert told.message == f"package 'robot' installs no executable '{name}': {file} is a launch file, and no program"
    assert told.help == 'include it instead: <include file="…"/>'
    in_python = LAUNCH_FILE.replace("[]", f"[Node(package='robot', executable='{name}')]")
    (told,) = findings("LCH001", **{file: LAUNCH_FILE, "launch/all.launch.py": in_python})
    assert told.help == "include it instead: IncludeLaunchDescription(…)"


def test_a_program_of_the_name_that_is_no_launch_file_is_to_be_installed(findings):
    (told,) = findings("LCH001", node(exec="view_robot.py"), **{"scripts/view_robot.py": TALKER})
    assert told.help == "install scripts/view_robot.py in setup.py"


def test_the_scripts_of_a_package_that_are_not_installed_are_one_finding(findings):
    """One edit of its setup.py mends all of them."""
    started = "\n".join(node(exec=name) for name in ("tracking", "planning", "driving"))
    files = {"robot/tracking.py": TALKER, "robot/planning.py": TALKER}
    one, other = findings("LCH001", started, **files)
    assert one.message == (
        "package 'robot' installs none of these 2 executables: planning, tracking; "
        "their files exist but are not installed"
    )
    assert [(row.place.line, row.message) for row in one.related] == [(2, "'planning' is started here")]
    assert other.message == "package 'robot' installs no executable 'driving'"


UNADDED = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    description = LaunchDescription()
    first = Node(package='robot', executable='talker')
    second = Node(package={package}, executable={executable})
    description.add_action(first)
    return description
"""


@pytest.mark.parametrize(
    ("package", "executable", "message"),
    [
        ("'robot'", "'tlaker'", "package 'robot' installs no executable 'tlaker'; did you mean 'talker'?"),
        ("'robots'", "'talker'", "there is no package 'robots'; did you mean 'robot', which installs 'talker'?"),
        ("'robot'", "'talker'", None),
        ("'robot'", "'talk' + 'er'", None),
        ("'tf2_ros'", "'static_transform_publisher'", None),
    ],
)
def test_a_node_action_that_nothing_adds(findings, package, executable, message):
    code = UNADDED.format(package=package, executable=executable)
    told = findings("LCH001", **{"launch/py.launch.py": code})
    assert [(finding.message, finding.severity) for finding in told] == ([(message, Severity.INFO)] if message else [])


DEFINES = """\
#!/usr/bin/env python3
from rclpy.node import Node
RATE = 5


class Hand(Node):
    def __init__(self):
        super().__init__('hand')
"""


@pytest.mark.parametrize(
    ("script", "found"),
    [
        (DEFINES, 1),
        (DEFINES + "\n\ndef main():\n    Hand()\n", 1),  # which nothing calls
        (DEFINES + "\n\ndef main():\n    Hand()\n\n\nmain()\n", 0),
        (DEFINES + "\n\nif __name__ == '__main__':\n    Hand()\n", 0),
        (DEFINES + "\n\nhand = Hand()\n", 0),
        (DEFINES.replace("(Node)", ""), 0),
    ],
)
def test_a_script_that_makes_no_node_of_its_class(findings, script, found):
    files = {"CMakeLists.txt": "project(robot)\n" + SCRIPTS, "package.xml": CMAKE, "setup.py": ""}
    told = findings("LCH001", node(exec="drive.py"), **files, **{"scripts/drive.py": script})
    assert [finding.message for finding in told] == [
        "'drive.py' of package 'robot' ends at once: scripts/drive.py defines Hand, and makes none"
    ] * found


# ------------------------------------------------------------------------------------------- the arguments of ROS

PARSES = """\
import argparse
import sys

import rclpy
from rclpy.node import Node
from rclpy.utilities import {imports}


def main(args=None):
    parser = argparse.ArgumentParser()
    parser.add_argument('--speed', type=float, default=0.1)
    {parse}
    rclpy.init(args=args)
    rclpy.spin(Node('talker'))
"""


def _parses(parse: str, imports: str = "get_default_context") -> dict[str, str]:
    return {"robot/talker.py": PARSES.format(parse=parse, imports=imports)}


def test_a_parser_that_is_given_the_arguments_of_ros(findings):
    (told,) = findings("LCH001", node(), **_parses("given = parser.parse_args()"))
    assert told.message == (
        "'talker' of package 'robot' ends here when a launch file starts it: argparse does not know the --ros-args "
        "that launch adds"
    )
    assert (told.place.file.endswith("talker.py"), told.place.line) == (True, 12)
    assert [row.message for row in told.related] == ["a launch file starts it here"]


@pytest.mark.parametrize(
    "parse",
    [
        "given = parser.parse_args(args)",
        "given = parser.parse_args(sys.argv[1:])",
        "parser.add_argument('names', nargs='*')\n    given = parser.parse_args()",
        "group = parser.add_argument_group('x')\n    group.add_argument('--way')\n    given = parser.parse_args()",
    ],
)
def test_other_forms_of_such_a_parser(findings, parse: str):
    assert len(findings("LCH001", node(), **_parses(parse))) == 1


@pytest.mark.parametrize(
    ("parse", "imports"),
    [
        ("given, _ = parser.parse_known_args()", "get_default_context"),
        ("given = parser.parse_args(remove_ros_args(sys.argv)[1:])", "remove_ros_args"),
        ("sys.argv = remove_ros_args(sys.argv)\n    given = parser.parse_args()", "remove_ros_args"),
        ("del sys.argv[1:]\n    given = parser.parse_args()", "get_default_context"),
        ("sys.argv[1:] = []\n    given = parser.parse_args()", "get_default_context"),
        ("sys.argv.clear()\n    given = parser.parse_args()", "get_default_context"),
        ("parser.add_argument('--ros-args', nargs='*')\n    given = parser.parse_args()", "get_default_context"),
        (
            "parser.add_argument('rest', nargs=argparse.REMAINDER)\n    given = parser.parse_args()",
            "get_default_context",
        ),
        ("parser.add_argument('rest', nargs='...')\n    given = parser.parse_args()", "get_default_context"),
        ("if sys.stdin.isatty():\n        given = parser.parse_args()", "get_default_context"),
        (
            "try:\n        given = parser.parse_args()\n    except SystemExit:\n        given = None",
            "get_default_context",
        ),
        ("given = parser.parse_args(sys.argv[1:2])", "get_default_context"),
        ("given = parser.parse_args([])", "get_default_context"),
    ],
)
def test_a_parser_that_can_live_with_them(findings, parse: str, imports: str):
    assert findings("LCH001", node(), **_parses(parse, imports)) == []


def test_a_process_that_is_given_no_arguments_of_ros(findings):
    launch = "<executable cmd='ros2 run robot talker'/>"
    assert findings("LCH001", launch, **_parses("given = parser.parse_args()")) == []


@pytest.mark.parametrize(
    ("count", "attributes", "found"),
    [
        ("if len(sys.argv) != 2:\n        sys.exit(1)", "args='7'", 1),
        ("if len(sys.argv) > 2:\n        sys.exit(1)", "args='7'", 1),
        ("if len(sys.argv) == 2:\n        pass\n    else:\n        return", "args='7'", 1),
        ("if len(sys.argv) != 2:\n        return", "name='other'", 1),
        ("if len(sys.argv) != 2:\n        sys.exit(1)", "", 0),  # --ros-args is the second
        ("if len(sys.argv) < 2:\n        sys.exit(1)", "args='7'", 0),
        ("if len(sys.argv) != 2:\n        print('what?')", "args='7'", 0),
        ("if len(remove_ros_args(sys.argv)) != 2:\n        sys.exit(1)", "args='7'", 0),
        ("if len(sys.argv) != 6:\n        sys.exit(1)", "args='7'", 0),
        ("if args:\n        if len(sys.argv) != 2:\n            sys.exit(1)", "args='7'", 0),
    ],
)
def test_a_program_that_counts_its_words(findings, count: str, attributes: str, found: int):
    launch = f"<node pkg='robot' exec='talker' {attributes}/>"
    imports = "remove_ros_args" if "remove" in count else "get_default_context"
    rows = findings("LCH001", launch, **_parses(count, imports))
    assert len(rows) == found
    assert all("this counts the --ros-args" in row.message for row in rows)


@pytest.mark.parametrize(
    ("executable", "installed", "told"),
    [
        ("talker", "talker.py", True),  # CMake does not run the setup.py, whose entry point has that name
        ("talker.py", "talker.py", False),
        ("talker", "talker.py RENAME talker", False),
    ],
)
def test_a_script_of_cmake_and_an_entry_point_of_another_name(findings, executable, installed, told):
    script, _, renamed = installed.partition(" ")
    install = f"install(PROGRAMS robot/{script} DESTINATION lib/robot {renamed})\n"
    files = {"package.xml": CMAKE, "CMakeLists.txt": "project(robot)\n" + install, "setup.py": SETUP}
    found = findings("LCH001", node(exec=executable), **files, **{f"robot/{script}": TALKER})
    missing = [one.message for one in found if one.message.startswith("package 'robot' installs no executable")]
    assert missing == told * [
        "package 'robot' installs no executable 'talker'; robot/talker.py is installed as 'talker.py'"
    ]
