"""PKG008: names in a package.xml that rosdep cannot find."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity

Judge = Callable[..., list[Finding]]


NAMED = {"README.md": "What is not here: our_messages, geometry, csv, tensorflow.\n"}


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    """What PKG008 says of a package with some dependencies and files."""
    monkeypatch.chdir(tmp_path)

    def run(*tags: str, build: str = "ament_python", config: str = "", **files: str) -> list[Finding]:
        lines = "".join(f"  {tag}\n" for tag in tags)
        kind = f"<export><build_type>{build}</build_type></export>"
        manifest = f'<package format="3">\n  <name>robot</name>\n{lines}  {kind}\n</package>\n'
        own = {"package.xml": manifest, "archlint.toml": f'select = ["PKG008"]\n{config}'}
        for name, text in {"robot/node.py": "import rclpy\n", **own, **files}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.mark.parametrize(
    ("tag", "meant"),
    [
        ("<depend>Eigen3</depend>", "eigen"),
        ("<depend>yaml_cpp</depend>", "yaml-cpp"),
        ("<test_depend>ament_cmake_lint_copyright</test_depend>", "ament_cmake_copyright"),
        ("<depend>launch-pytest</depend>", "launch_pytest"),
        ("<exec_depend>nav_msg</exec_depend>", "nav_msgs"),
        ("<exec_depend>rviz</exec_depend>", "rviz2"),
        ("<exec_depend>python3-rclpy</exec_depend>", "rclpy"),
    ],
)
def test_what_was_meant(judge: Judge, tag: str, meant: str):
    (one,) = judge(tag)
    assert one.message.endswith(f"'{meant}' was probably meant")
    assert (one.place.file, one.place.line) == ("package.xml", 3)


@pytest.mark.parametrize(
    "tag",
    [
        "<depend>rclpy</depend>",
        "<depend>eigen</depend>",
        "<exec_depend>python3-numpy</exec_depend>",
        "<depend>our_messages</depend>",  # perhaps of another repository
        "<depend>robot</depend>",
        "<depend>geometry</depend>",  # perhaps of another repository, whatever geometry2 is
        '<depend condition="$ROS_VERSION == 1">nav_msg</depend>',
        "<!-- <depend>nav_msg</depend> -->",
    ],
)
def test_what_is_known_or_may_be(judge: Judge, tag: str):
    assert judge(tag, **NAMED) == []


@pytest.mark.parametrize(
    ("tag", "help"),
    [
        ("<depend>roscpp</depend>", "write 'rclcpp' instead"),
        ("<depend>ros_control</depend>", "write 'ros2_control' instead"),
        ("<depend>gazebo_ros_control</depend>", "write 'gazebo_ros2_control' instead"),
        ("<exec_depend>dwa_local_planner</exec_depend>", "remove the line"),
        ("<build_depend>message_generation</build_depend>", "write 'rosidl_default_generators' instead"),
        ("<depend>dynamic_reconfigure</depend>", "remove the line"),
        ("<exec_depend>python-numpy</exec_depend>", "write 'python3-numpy' instead"),
        ("<exec_depend>opencv-python</exec_depend>", "write 'python3-opencv' instead"),
        ("<exec_depend>python3-tkinter</exec_depend>", "write 'python3-tk' instead"),
        ("<exec_depend>python3-pillow</exec_depend>", "write 'python3-pil' instead"),
        ("<exec_depend>python3-cv2</exec_depend>", "write 'python3-opencv' instead"),
        ("<exec_depend>python3-hid</exec_depend>", "write 'python3-hidapi' instead"),  # as Debian calls it
        ("<depend>libeigen3-dev</depend>", "write 'eigen' instead"),
        ("<depend>libyaml-cpp-dev</depend>", "write 'yaml-cpp' instead"),
        ("<depend>opencv4</depend>", "write 'python3-opencv' instead"),
        ("<depend>eigen3</depend>", "write 'eigen' instead"),
        ("<depend>nlohmann_json</depend>", "write 'nlohmann-json-dev' instead"),
        ("<test_depend>pytest</test_depend>", "write 'python3-pytest' instead"),
        ("<depend>rclpy_action</depend>", "write 'rclpy' instead"),
        ("<exec_depend>pyserial</exec_depend>", "write 'python3-serial' instead"),
        ("<exec_depend>RPi.GPIO</exec_depend>", "write 'python-rpi.gpio-pip' instead"),
        ("<depend>glog</depend>", "write 'libgoogle-glog-dev' instead"),
        ("<depend>sensor_msgs.msg</depend>", "write 'sensor_msgs' instead"),
        ("<exec_depend>ros-jazzy-nav2-msgs</exec_depend>", "write 'nav2_msgs' instead"),
        ("<exec_depend>ros_jazzy_twist_mux</exec_depend>", "write 'twist_mux' instead"),
    ],
)
def test_what_is_known_to_be_no_package_for_ros_2(judge: Judge, tag: str, help: str):
    (one,) = judge(tag)
    assert one.help == help


def test_a_key_of_python_2_where_rosdep_still_has_packages_of_it(judge: Judge):
    tag = "<exec_depend>python-numpy</exec_depend>"
    (one,) = judge(tag)
    assert one.message.endswith("which Ubuntu has no packages of since 22.04: rosdep stops here")
    (old,) = judge(tag, **{"README.md": "For ROS 2 Foxy on Ubuntu 20.04."})
    assert old.message == "'python-numpy' is for Python 2, with which nothing of ROS 2 runs"
    assert old.help == "write 'python3-numpy' instead"


def test_a_name_of_debian_that_rosdep_has_no_rule_for(judge: Judge):
    (one,) = judge("<exec_depend>python3-gripperlib</exec_depend>")
    assert one.message == "'python3-gripperlib' is no key of rosdep, which stops here"


@pytest.mark.parametrize(
    "tag",
    [
        "<exec_depend>python-gripper-pip</exec_depend>",
        '<depend condition="$ROS_VERSION == 1">roscpp</depend>',
        '<exec_depend condition="$ROS_PYTHON_VERSION == 2">python-numpy</exec_depend>',
    ],
)
def test_a_rule_of_the_team_and_dependencies_for_others(judge: Judge, tag: str):
    assert judge(tag, **{"docker/rosdep.yaml": "python-gripper-pip:\n  ubuntu:\n    pip: [gripper]\n"}) == []


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        ("$RUN_MODE == pc", 0),
        ("$ROS_VERSION == 2 and $RUN_MODE == pc", 0),
        ("$ROS_VERSION == 2 or $RUN_MODE == pc", 1),
        ("$ROS_VERSION == 2", 1),
        ("$ROS_DISTRO == humble", 1),
    ],
)
def test_a_dependency_that_only_some_machines_ask_for(judge: Judge, condition: str, told: int):
    assert len(judge(f'<depend condition="{condition}">nav_msg</depend>')) == told
    assert len(judge(f'<exec_depend condition="{condition}">our_gui</exec_depend>')) == told


@pytest.mark.parametrize(
    ("file", "text", "told"),
    [
        ("setup.sh", "cat > rules.yaml <<END\nOpenCV:\n  ubuntu: [python3-opencv]\nEND\n", 0),
        ("rules/own.yml", "OpenCV: {ubuntu: [libopencv-dev]}\n", 0),
        ("config/vision.yaml", "OpenCV:\n  threads: 4\n", 1),
        ("setup.sh", "echo OpenCV: installed on ubuntu\n", 1),
    ],
)
def test_a_rule_of_the_team_for_a_name_that_is_nearly_one_of_rosdep(judge: Judge, file: str, text: str, told: int):
    assert len(judge("<depend>OpenCV</depend>", **{file: text})) == told


def test_a_module_that_comes_with_python(judge: Judge):
    (one,) = judge("<exec_depend>csv</exec_depend>", **{"robot/node.py": "import csv\nimport rclpy\n"})
    assert one.help == "remove the line"
    assert judge("<exec_depend>csv</exec_depend>", **{"robot/node.py": "import rclpy\n"}, **NAMED) == []  # a package


@pytest.mark.parametrize("path", ["setup.py", "launch/robot.launch.py"])
def test_a_module_of_python_that_only_setup_or_a_launch_file_imports(judge: Judge, path: str):
    launch = "def generate_launch_description():\n    return LaunchDescription([])\n"
    end = f"from launch import LaunchDescription\n\n\n{launch}"
    (one,) = judge("<depend>os</depend>", **{path: f"import os.path\n{end}"}, **NAMED)
    assert one.message.startswith("'os' is a module of Python itself")
    assert judge("<depend>csv</depend>", **{path: f"csv = 'a package'\n{end}"}, **NAMED) == []
    assert judge("<depend>tensorflow</depend>", **{path: f"import tensorflow\n{end}"}, **NAMED) == []


NODE = "#include <rclcpp/rclcpp.hpp>\n\nint main() { rclcpp::init(0, nullptr); }\n"


@pytest.mark.parametrize(
    ("tag", "files", "meant"),
    [
        ("<exec_depend>rclcpy</exec_depend>", {}, "rclpy"),
        ("<depend>rclcpy</depend>", {}, "rclpy"),
        ("<exec_depend>rclcpy</exec_depend>", {"src/a.cpp": NODE}, "rclpy"),  # C++ needs its one for the build, too
        ("<depend>rclcpy</depend>", {"src/a.cpp": NODE}, "rclcpp"),
        ("<depend>rclcpy</depend>", {"robot/node.py": "import numpy\n"}, "rclcpp"),
        ("<depend>rclccpp</depend>", {}, "rclcpp"),
    ],
)
def test_the_library_that_the_code_of_the_package_uses(judge: Judge, tag: str, files: dict[str, str], meant: str):
    (one,) = judge(tag, **files)
    assert one.help == f"write '{meant}' instead"


def test_opencv_is_what_the_code_of_the_package_uses(judge: Judge):
    (of_python,) = judge("<depend>opencv</depend>", **{"robot/node.py": "import cv2\nimport rclpy\n"})
    (of_no_use,) = judge("<depend>OpenCV</depend>", **{"robot/node.py": "import rclpy\n"})
    assert of_no_use.help == "write 'python3-opencv' instead"  # nothing but Python is built
    (of_cpp,) = judge("<depend>opencv</depend>", build="ament_cmake", **{"robot/node.py": "import rclpy\n"})
    assert (of_python.help, of_cpp.help) == ("write 'python3-opencv' instead", "write 'libopencv-dev' instead")
    both = {"robot/node.py": "import cv2\nimport rclpy\n", "CMakeLists.txt": "find_package(OpenCV REQUIRED)\n"}
    (of_cmake,) = judge("<depend>opencv</depend>", build="ament_cmake", **both)
    assert of_cmake.help == "write 'libopencv-dev' instead"


def test_a_module_of_python_by_its_own_name(judge: Judge):
    (one,) = judge("<exec_depend>serial</exec_depend>", **{"robot/node.py": "import rclpy\nimport serial\n"})
    assert one.help == "write 'python3-serial' instead"


@pytest.mark.parametrize(
    ("name", "module", "key"),
    [
        ("python-can", "can", "python3-can"),
        ("simple-pid", "simple_pid", "python3-simple-pid-pip"),
        ("pyaudio", "pyaudio", "python3-pyaudio"),
    ],
)
def test_a_package_of_pip_whose_module_the_code_imports(judge: Judge, name: str, module: str, key: str):
    files = {"robot/node.py": f"import rclpy\nimport {module}\n"}
    (one,) = judge(f"<exec_depend>{name}</exec_depend>", **files)
    assert one.help == f"write '{key}' instead"


def test_a_package_of_pip_for_which_rosdep_has_no_key(judge: Judge):
    tag = "<exec_depend>tensorflow</exec_depend>"
    (one,) = judge(tag, **{"robot/node.py": "import rclpy\nimport tensorflow as tf\n"})
    assert one.message == "'tensorflow' is no key of rosdep, which stops here"
    assert judge(tag, **NAMED) == []  # perhaps somebody's package with this name


def test_what_may_be_a_package_with_the_name_of_a_module(judge: Judge):
    assert judge("<depend>serial</depend>") == []  # no code of the package has the name
    cmake = "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(serial REQUIRED)\nament_package()\n"
    files = {"CMakeLists.txt": cmake, "robot/node.py": "import rclpy\n# as the package serial does\n"}
    assert judge("<depend>serial</depend>", build="ament_cmake", **files) == []


def test_a_package_that_the_configuration_names(judge: Judge):
    assert judge("<depend>nav_msg</depend>", config='external = ["nav_msg"]') == []


def test_a_build_type_is_no_package(judge: Judge):
    line = "<buildtool_depend>ament_python</buildtool_depend>"
    (by_setup,) = judge(line)
    assert by_setup.help == "remove the line: the build type in <export> is enough"


@pytest.mark.parametrize(
    ("command", "help"),
    [
        ("ament_python_install_package(robot)", "write 'ament_cmake_python' instead"),
        ("find_package(ament_cmake_python REQUIRED)", "write 'ament_cmake' instead, and add 'ament_cmake_python'"),
        ("install(DIRECTORY launch DESTINATION share/robot)", "write 'ament_cmake' instead, with which CMakeLists.txt"),
    ],
)
def test_a_build_type_as_a_dependency_of_a_package_of_cmake(judge: Judge, command: str, help: str):
    line = "<buildtool_depend>ament_python</buildtool_depend>"
    cmake = {"CMakeLists.txt": f"project(robot)\nfind_package(ament_cmake REQUIRED)\n{command}\nament_package()\n"}
    (told,) = judge(line, build="ament_cmake", **cmake)
    assert (told.help or "").startswith(help)


def test_a_build_type_of_a_package_of_cmake_that_declares_its_own(judge: Judge):
    lines = [f"<buildtool_depend>{name}</buildtool_depend>" for name in ("ament_cmake", "ament_python")]
    cmake = {"CMakeLists.txt": "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"}
    (told,) = judge(*lines, build="ament_cmake", **cmake)
    assert told.help == "remove the line: CMakeLists.txt installs no Python package"


def test_a_build_type_beside_the_package_that_was_meant(judge: Judge):
    lines = [f"<buildtool_depend>{name}</buildtool_depend>" for name in ("ament_cmake_python", "ament_python")]
    cmake = {"CMakeLists.txt": "project(robot)\nament_python_install_package(robot)\nament_package()\n"}
    (told,) = judge(*lines, build="ament_cmake", **cmake)
    assert told.help == "remove the line: 'ament_cmake_python' is declared already"


@pytest.mark.parametrize(
    ("declared", "tag", "help"),
    [
        (
            "<depend>rclpy</depend>",
            "<exec_depend>rclpy_action</exec_depend>",
            "remove the line: 'rclpy' is declared already",
        ),
        ("<depend>nav_msgs</depend>", "<depend>nav_msg</depend>", "remove the line: 'nav_msgs' is declared already"),
        (
            "<exec_depend>nav_msgs</exec_depend>",
            "<exec_depend>nav_msg</exec_depend>",
            "remove the line: 'nav_msgs' is declared already",
        ),
        ("<build_depend>nav_msgs</build_depend>", "<exec_depend>nav_msg</exec_depend>", "write 'nav_msgs' instead"),
        (
            '<depend condition="$ROS_VERSION == 1">nav_msgs</depend>',
            "<depend>nav_msg</depend>",
            "write 'nav_msgs' instead",
        ),
    ],
)
def test_what_was_meant_is_declared_already(judge: Judge, declared: str, tag: str, help: str):
    (one,) = judge(declared, tag)
    assert one.help == help


def test_one_finding_for_a_package(judge: Judge):
    (one,) = judge("<depend>Eigen3</depend>", "<depend>nav_msg</depend>")
    assert [related.place.line for related in one.related] == [4]


def of_packages(folder: Path, **tags: tuple[str, ...]) -> list[Finding]:
    """What PKG008 says of packages with these names and dependencies."""
    for name, lines in tags.items():
        (folder / name).mkdir()
        (folder / name / "package.xml").write_text(
            "\n".join(
                [
                    '<package format="3">',
                    f"<name>{name}</name>",
                    *lines,
                    "<export><build_type>ament_python</build_type></export></package>",
                ]
            ),
            encoding="utf-8",
        )
    (folder / "archlint.toml").write_text('select = ["PKG008"]', encoding="utf-8")
    return check(Request((".",), load(folder), cached=False, jobs=1)).findings


BUILD_TYPE, EIGEN, YAML = (
    "<buildtool_depend>ament_python</buildtool_depend>",
    "<depend>Eigen3</depend>",
    "<depend>yaml_cpp</depend>",
)


def test_one_finding_for_a_key_of_several_packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    (told,) = of_packages(tmp_path, arm=(BUILD_TYPE,), base=(BUILD_TYPE,), camera=("", BUILD_TYPE))

    assert told.message.endswith("it is a build type; 2 more package.xml files have it, too")
    assert (told.place.file, told.place.line) == ("arm/package.xml", 3)
    assert [(other.place.file, other.place.line) for other in told.related] == [
        ("base/package.xml", 3),
        ("camera/package.xml", 4),
    ]


def test_different_keys_of_several_packages_are_a_finding_each(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    told = of_packages(tmp_path, arm=(BUILD_TYPE,), base=(EIGEN,), camera=(YAML,))

    assert [one.place.file for one in told] == ["arm/package.xml", "base/package.xml", "camera/package.xml"]
    assert all("more" not in one.message for one in told)


def test_what_only_one_of_several_packages_has_stays_with_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    several, own = of_packages(tmp_path, arm=(BUILD_TYPE, EIGEN, YAML), base=(BUILD_TYPE,))

    assert several.message.endswith("it is a build type; another package.xml has it, too")
    assert (own.place.file, own.place.line) == ("arm/package.xml", 4)
    assert own.message.endswith("'eigen' was probably meant; another dependency of the file is unknown")


def test_a_suppression_takes_its_package_out(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    quiet = f"{BUILD_TYPE}  <!-- archlint: ignore[PKG008] our rosdep file has it -->"
    (told,) = of_packages(tmp_path, arm=(quiet,), base=(BUILD_TYPE,), camera=(BUILD_TYPE,))

    assert told.place.file == "base/package.xml"
    assert told.message.endswith("another package.xml has it, too")


AUTO = """
project(robot)
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
{more}
ament_auto_package()
"""


def help_for(judge: Judge, tag: str, cmake: str) -> str:
    (finding,) = judge(tag, build="ament_cmake", **{"CMakeLists.txt": cmake})
    return finding.help


def test_a_name_that_cmake_takes_from_package_xml_is_still_to_be_found(judge: Judge):
    told = help_for(judge, "<depend>Eigen3</depend>", AUTO.format(more=""))
    assert told == (
        "write 'eigen' instead, and add find_package(Eigen3 REQUIRED) to CMakeLists.txt, which takes its packages from "
        "here, and a target_link_libraries() for what uses it"
    )


@pytest.mark.parametrize(
    ("tag", "cmake"),
    [
        ("<depend>Eigen3</depend>", "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"),
        ("<depend>Eigen3</depend>", AUTO.format(more="find_package(Eigen3 REQUIRED)")),
        ("<exec_depend>Eigen3</exec_depend>", AUTO.format(more="")),  # not looked for
    ],
)
def test_a_name_that_cmake_does_not_take_from_package_xml(judge: Judge, tag: str, cmake: str):
    assert help_for(judge, tag, cmake) == "write 'eigen' instead"


def test_a_package_of_the_workspace_with_a_2_behind_its_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    depends = ("<test_depend>arm_msgs</test_depend>", "<test_depend>our_own_messages</test_depend>")
    (told,) = of_packages(tmp_path, arm_msgs2=(), arm=depends)

    assert (
        told.message
        == "'arm_msgs' is neither a ROS package nor a key of rosdep, which stops here: 'arm_msgs2' was probably meant"
    )


@pytest.mark.parametrize(
    ("name", "help"),
    [
        ("TODO", "write the name of the package instead"),
        ("Lab::bus", "a target of CMake: write the name of the package that has it, or remove the line if none has it"),
        ("https://example.org/arm.git", "write the name of the package instead"),
        ("static_transform_publisher", "write 'tf2_ros' instead"),
    ],
)
def test_what_is_no_package_at_all(judge: Judge, name: str, help: str):
    (told,) = judge(f"<depend>{name}</depend>", **{"README.md": f"It needs {name}."})
    assert (told.severity, told.help, told.place.line) == (Severity.WARNING, help, 3)


@pytest.mark.parametrize(
    ("name", "help"),
    [
        ("acme_interfaces", "remove the line, unless a package from elsewhere is meant"),
        (
            "acme_lidar_ros2",
            "bring its source into the workspace, as with a .repos file, or remove the line if nothing needs it",
        ),
    ],
)
def test_a_name_that_nothing_else_has(judge: Judge, name: str, help: str):
    (told,) = judge("<depend>rclpy</depend>", f"<depend>{name}</depend>")
    assert (
        told.message == f"'{name}' is neither a ROS package nor a key of rosdep, which stops here, and nothing uses it"
    )
    assert (told.severity, told.place.line, told.help) == (Severity.INFO, 4, help)


def test_a_name_of_which_cmake_links_the_library(judge: Judge):
    links = "find_library(MOTOR NAMES dome_motor)\nadd_executable(dome a.cpp)\ntarget_link_libraries(dome ${MOTOR})\n"
    (told,) = judge("<depend>dome-motor</depend>", build="ament_cmake", **{"CMakeLists.txt": links})
    assert told.message == "'dome-motor' is neither a ROS package nor a key of rosdep, which stops here"
    assert (told.help or "").startswith("give rosdep a rule for it, in a file of yours")


@pytest.mark.parametrize(
    "files",
    [
        {"robot/node.py": "import rclpy\nfrom acme_interfaces.msg import Speed\n"},
        {"README.md": "Clone acme-interfaces first.\n"},
        {"config/robot.yaml": "type: acme_interfaces/msg/Speed\n"},
        {"launch/it.launch.xml": '<launch><include file="$(find-pkg-share acme_interfaces)/a.launch.xml"/></launch>'},
        {"other/acme_interfaces/CMakeLists.txt": "project(other)\n"},
        {"launch/it.launch.xml": '<launch><node pkg="acme_interfaces_node" exec="relay"/></launch>'},
    ],
)
def test_a_name_that_something_else_has_may_come_from_elsewhere(judge: Judge, files: dict[str, str]):
    assert judge("<depend>acme_interfaces</depend>", **files) == []


@pytest.mark.parametrize(
    ("declared", "help"),
    [
        ([], "write 'rclpy' instead"),
        (["<depend>rclpy</depend>"], "remove the line, unless a package from elsewhere is meant"),
    ],
)
def test_a_short_name_that_is_a_letter_away_from_what_is_imported(judge: Judge, declared: list[str], help: str):
    (told,) = judge(*declared, "<depend>rclqy</depend>")
    assert told.help == help


def test_a_name_among_many_unknown_ones(judge: Judge):
    assert judge("<depend>acme_a</depend>", "<depend>acme_b</depend>", "<depend>acme_c</depend>") == []


def test_a_name_that_nothing_else_has_beside_one_that_was_meant_for_another(judge: Judge):
    """What is certain is not hidden behind what is not."""
    told = judge("<depend>acme_interfaces</depend>", "<depend>Eigen3</depend>")
    assert [(row.severity, row.place.line) for row in told] == [(Severity.INFO, 3), (Severity.WARNING, 4)]


REPOS = "repositories:\n  acme/{}:\n    type: git\n    url: https://example.com/acme/{}.git\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"src/plan.cpp": "#include <rclcpp/rclcpp.hpp>\n#include <gpsr_msgs/srv/plan.hpp>\n"}, 0),
        ({"robot/plan.py": "import rclpy\nfrom gpsr_msgs.srv import Plan\n"}, 0),
        ({"acme.repos": REPOS.format("gpsr_msgs", "gpsr_msgs")}, 0),
        ({"src/plan.cpp": "#include <rclcpp/rclcpp.hpp>\n#include <gps_msgs/msg/gps_fix.hpp>\n"}, 1),
        ({"acme.repos": REPOS.format("arm", "arm")}, 1),
    ],
)
def test_a_package_from_elsewhere_that_another_resembles(judge: Judge, files: dict[str, str], told: int):
    rows = judge("<depend>gpsr_msgs</depend>", build="ament_cmake", **files)
    assert [row.help for row in rows] == ["write 'gps_msgs' instead"] * told
