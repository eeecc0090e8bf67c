"""PKG001: what counts as declared, what is said once for a package, and which lines its fix adds."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from archlint.ros.packages import table
from robot_package import SETUP

Lint = Callable[..., list[Finding]]


@pytest.fixture
def lint(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Lint:
    """Lays out files and gives what PKG001, or ``code``, finds; ``only`` are the paths that are asked for."""
    monkeypatch.chdir(tmp_path)

    def run(files: dict[str, str], *only: str, config: str = "", code: str = "PKG001") -> list[Finding]:
        for name, text in {"archlint.toml": f'select = ["{code}"]\n{config}', **files}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return check(Request(only or (".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def manifest(name: str, *tags: str, head: str = 'format="3"') -> str:
    lines = "".join(f"  {tag}\n" for tag in tags)
    kind = "<export><build_type>ament_python</build_type></export>"
    return f"<package {head}>\n  <name>{name}</name>\n  <license>MIT</license>\n{lines}  {kind}\n</package>\n"


def depends(*names: str, tag: str = "exec_depend") -> list[str]:
    return [f"<{tag}>{name}</{tag}>" for name in names]


def node(*imports: str) -> str:
    return "".join(f"{line}\n" for line in ("import rclpy", *imports, "rclpy.create_node('talk')"))


LASER = "from sensor_msgs.msg import LaserScan"
POSE = "from geometry_msgs.msg import Pose"
PATH = "from nav_msgs.msg import Path"


def missing(found: list[Finding]) -> list[str]:
    return [name for one in found for name in one.identity[1:]]


# ------------------------------------------------------------------------------------------- what is declared


@pytest.mark.parametrize(
    ("tags", "lacking"),
    [
        (["<!-- built from source: <exec_depend>sensor_msgs</exec_depend> -->"], ["nav_msgs"]),
        (["<!--", *depends("sensor_msgs", "nav_msgs"), "-->"], []),
        (["<!-- sensor_msgs and nav_msgs -->"], ["nav_msgs", "sensor_msgs"]),
    ],
)
def test_a_dependency_that_is_taken_out(lint: Lint, tags: list[str], lacking: list[str]):
    files = {"talk/package.xml": manifest("talk", *depends("rclpy"), *tags), "talk/talk.py": node(LASER, PATH)}
    assert sorted(missing(lint(files))) == lacking


@pytest.mark.parametrize(
    ("setup", "command", "told"),
    [
        ("~/base_ws/install/setup.bash", "source {SETUP} && env -0", 0),
        ("~/base_ws/install/local_setup.sh", ". {SETUP} && env", 0),
        ("~/base_ws/install/setup.bash", "cat {SETUP}", 1),
        ("~/base_ws/settings.txt", "source {SETUP}", 1),
    ],
)
def test_a_launch_file_that_sources_another_workspace(lint: Lint, setup: str, command: str, told: int):
    launch = f"""import os
import subprocess
from launch import LaunchDescription
from launch_ros.actions import Node

SETUP = os.path.expanduser('{setup}')

def source():
    for line in subprocess.check_output(['bash', '-c', f'{command}']).decode().split('\\0'):
        name, _, value = line.partition('=')
        os.environ[name] = value

def generate_launch_description():
    source()
    return LaunchDescription([
        Node(package='base_driver', executable='base'),
        Node(package='nav2_map_server', executable='map_server'),
    ])
"""
    files = {"talk/package.xml": manifest("talk", *depends("launch")), "talk/launch/it.launch.py": launch}
    found = lint(files)
    assert len(found) == 2 * told


@pytest.mark.parametrize(
    ("declared", "lines"),
    [
        ("nav_msgs", [POSE]),  # a message of nav_msgs holds one of geometry_msgs
        ("rclpy", ["from builtin_interfaces.msg import Time", "from rcl_interfaces.msg import Log"]),
        ("rclpy", ["from action_msgs.msg import GoalStatus", "from ament_index_python import get_package_prefix"]),
        ("rclcpp_action", ["from action_msgs.msg import GoalStatus"]),
        ("navigation2", ["from nav2_msgs.action import NavigateToPose"]),  # metapackages
        ("desktop", ["from turtlesim.msg import Pose", LASER]),
        ("rtabmap_ros", ["from rtabmap_msgs.msg import OdomInfo"]),
        ("grid_map", ["from visualization_msgs.msg import Marker", "from grid_map_msgs.msg import GridMap"]),
        ("plansys2_bringup", ["from plansys2_msgs.msg import Plan"]),
        ("ublox", ["from ublox_msgs.msg import NavPVT"]),
        ("tf2_ros", ["import tf2_ros"]),  # the tutorials say so, though the module is in tf2_ros_py
    ],
)
def test_what_a_declared_package_brings_along_is_there(lint: Lint, declared: str, lines: list[str]):
    assert lint({"package.xml": manifest("talk", *depends("rclpy", declared)), "talk/node.py": node(*lines)}) == []


@pytest.mark.parametrize(
    ("line", "needed"),
    [
        ("from nav2_common.launch import RewrittenYaml", "nav2_common"),
        ("from moveit_configs_utils import MoveItConfigsBuilder", "moveit_configs_utils"),
        ("import rqt_gui.main", "rqt_gui"),
        ("from python_qt_binding.QtWidgets import QWidget", "python_qt_binding"),
    ],
)
def test_modules_of_ros_packages(lint: Lint, line: str, needed: str):
    files = {"package.xml": manifest("robot", *depends("rclpy")), "robot/talk.py": node(line)}
    assert missing(lint(files)) == [needed]


def test_a_module_of_a_package_with_another_name(lint: Lint):
    """``tf2_ros`` of C++ and ``tf2_ros_py`` do not bring each other."""
    (found,) = lint({"package.xml": manifest("robot", *depends("rclpy")), "robot/talk.py": node("import tf2_ros")})
    assert found.message == ("package 'robot' imports a module of 'tf2_ros_py', which its package.xml does not declare")
    assert found.help == "add <exec_depend>tf2_ros_py</exec_depend> to package.xml"


def test_what_a_declared_package_does_not_bring_is_missing(lint: Lint):
    files = {"package.xml": manifest("talk", *depends("rclpy", "std_srvs")), "talk/node.py": node(POSE)}
    assert missing(lint(files)) == ["geometry_msgs"]


@pytest.mark.parametrize(
    ("declared", "expected"),
    [
        ("ourarm", []),  # nobody knows this package: it may well be the metapackage of ourarm_msgs
        ("ourarm_driver", ["ourarm_msgs"]),
        ("our", ["ourarm_msgs"]),  # another name, not the first part of this one
    ],
)
def test_an_unknown_package_may_bring_what_is_named_after_it(lint: Lint, declared: str, expected: list[str]):
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy", declared)),
        "talk/talk/node.py": node("from ourarm_msgs.msg import Joint"),
        "user/package.xml": manifest("user", *depends("ourarm_msgs")),  # so there is one, somewhere
    }
    assert missing(lint(files)) == expected


def test_what_a_package_is_known_to_need_is_all_that_it_brings(lint: Lint):
    assert table().brings["nav_msgs"]  # it has been read
    one = {
        "talk/talk/node.py": node("from nav_msgs_extra.msg import Model"),
        "user/package.xml": manifest("user", *depends("nav_msgs_extra")),
    }
    known = manifest("talk", *depends("rclpy", "nav_msgs"))
    assert missing(lint({**one, "talk/package.xml": known})) == ["nav_msgs_extra"]


def test_what_a_package_of_the_workspace_needs_is_all_that_it_brings(lint: Lint):
    files = {
        "arm/package.xml": manifest("arm", *depends("rclpy")),
        "msgs/package.xml": manifest("arm_msgs"),
        "talk/package.xml": manifest("talk", *depends("rclpy", "arm")),
        "talk/talk/node.py": node("from arm_msgs.msg import Joint"),
    }
    assert missing(lint(files)) == ["arm_msgs"]


@pytest.mark.parametrize(
    ("install", "expected"),
    [
        ("", []),
        ("install(PROGRAMS tools/node.py DESTINATION lib/${PROJECT_NAME})", ["geometry_msgs"]),
        ("install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})", ["geometry_msgs"]),
        ("ament_python_install_package(${PROJECT_NAME})", ["geometry_msgs"]),
        ("include(${ours}/install.cmake)", ["geometry_msgs"]),
    ],
)
def test_loose_scripts_of_a_package_that_installs_nothing(lint: Lint, install: str, expected: list[str]):
    cmake = f"project(talk)\nfind_package(ament_cmake REQUIRED)\n{install}\nament_package()\n"
    files = {
        "package.xml": manifest("talk", *depends("ament_cmake", "rclpy")).replace("ament_python", "ament_cmake"),
        "CMakeLists.txt": cmake,
        "tools/node.py": node(POSE),
        "talk/__init__.py": "",
    }
    assert missing(lint(files)) == expected


@pytest.mark.parametrize(
    ("install", "expected"),
    [
        ("install(DIRECTORY include/ DESTINATION include)", []),
        ("install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})", []),
        ("install(PROGRAMS tools/node.py DESTINATION lib/${PROJECT_NAME})", ["geometry_msgs"]),
        ("install(PROGRAMS tools/other.py DESTINATION lib/${PROJECT_NAME})", []),
        ("install(PROGRAMS ${tools} DESTINATION lib/${PROJECT_NAME})", ["geometry_msgs"]),
    ],
)
def test_loose_scripts_of_a_package_of_cpp_programs(lint: Lint, install: str, expected: list[str]):
    targets = "add_executable(driver src/driver.cpp)\ninstall(TARGETS driver DESTINATION lib/${PROJECT_NAME})"
    files = {
        "package.xml": manifest("talk", *depends("ament_cmake", "rclpy")).replace("ament_python", "ament_cmake"),
        "CMakeLists.txt": f"project(talk)\nfind_package(ament_cmake REQUIRED)\n{targets}\n{install}\nament_package()\n",
        "tools/node.py": node(POSE, "rclpy.init()"),
        "tools/other.py": "print('other')\n",
    }
    assert missing(lint(files)) == expected


def test_what_stands_inside_export_is_to_be_moved_out(lint: Lint):
    inside = "<exec_depend>geometry_msgs</exec_depend></export>"
    text = manifest("talk", *depends("rclpy"))
    files = {"package.xml": text.replace("</export>", f"\n  {inside}"), "talk/node.py": node(POSE)}
    (found,) = lint(files)
    assert found.help == "declare it outside of <export>: entries inside it do not count"
    assert [(one.place.file, one.place.line, one.message) for one in found.related] == [
        ("package.xml", 6, "'geometry_msgs' is inside <export> here, where it does not count")
    ]
    assert found.sites is None, "a second line would leave the first"
    (plain,) = lint({**files, "package.xml": text})
    assert plain.help == "add <exec_depend>geometry_msgs</exec_depend> to package.xml"


def test_metapackages_of_a_launch_file(lint: Lint):
    launch = '<launch><node pkg="imu_filter_madgwick" exec="imu_filter_madgwick_node"/></launch>'
    files = {"launch/imu.launch.xml": launch, "talk/node.py": node()}
    assert lint({**files, "package.xml": manifest("talk", *depends("rclpy", "imu_tools"))}) == []
    assert missing(lint({**files, "package.xml": manifest("talk", *depends("rclpy"))})) == ["imu_filter_madgwick"]
    assert {"lanelet2_io", "lanelet2_python"} <= set(table().brings["lanelet2"])
    assert "trac_ik_lib" in table().brings["trac_ik"]


@pytest.mark.parametrize(("tag", "expected"), [("exec_depend", []), ("test_depend", ["lidar_msgs"])])
def test_what_a_package_of_the_workspace_brings_is_there(lint: Lint, tag: str, expected: list[str]):
    files = {
        "lidar/package.xml": manifest("lidar", *depends("lidar_msgs", tag=tag)),
        "talk/package.xml": manifest("talk", *depends("rclpy", "lidar")),
        "talk/talk/node.py": node("from lidar_msgs.msg import Scan"),
    }
    assert missing(lint(files)) == expected


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("$ROS_VERSION == 1", ["sensor_msgs"]),
        ("$ROS_VERSION == 2", []),
        ("$BUILD == hardware", []),  # only the machine that builds knows
        ("$ROS_DISTRO == humble", []),
        ("$ROS_VERSION == 1 and $BUILD == hardware", ["sensor_msgs"]),
    ],
)
def test_a_dependency_under_a_condition(lint: Lint, condition: str, expected: list[str]):
    tag = f'<exec_depend condition="{condition}">sensor_msgs</exec_depend>'
    files = {"package.xml": manifest("talk", *depends("rclpy"), tag), "talk/node.py": node(LASER)}
    assert missing(lint(files)) == expected


def test_what_is_declared_for_tests_is_not_there_when_a_node_runs(lint: Lint):
    tags = [*depends("rclpy"), *depends("sensor_msgs", tag="test_depend")]
    (found,) = lint({"package.xml": manifest("talk", *tags), "talk/a.py": node(LASER), "test/test_it.py": node(POSE)})
    assert found.message == "package 'talk' imports 'sensor_msgs', which its package.xml declares for tests only"


def test_imports_that_may_fail_or_are_for_tests_need_no_dependency(lint: Lint):
    optional = "try:\n    from sensor_msgs.msg import Image\nexcept ImportError:\n    Image = None"
    files = {"talk/node.py": node(optional), "test/test_it.py": node(POSE), "test/it.launch.xml": "<launch/>"}
    assert lint({**files, "package.xml": manifest("talk", *depends("rclpy"))}) == []


@pytest.mark.parametrize(("module", "names"), [("arm_msgs.msg.dds_", []), ("arm_msgs.msg", ["arm_msgs"])])
def test_what_idlc_makes_of_a_message_is_no_package(lint: Lint, module: str, names: list[str]):
    files = {
        "arm_msgs/package.xml": manifest("arm_msgs"),
        "arm_msgs/msg/Speed.msg": "float64 speed\n",
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/talk/node.py": node(f"from {module} import Speed_"),
    }
    assert missing(lint(files)) == names


def test_a_package_of_the_workspace_is_meant_only_where_it_has_such_a_module(lint: Lint):
    files = {
        "serial/package.xml": manifest("serial"),  # C++; the import means a module of PyPI
        "arm/package.xml": manifest("arm"),
        "arm/arm/__init__.py": "",
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/talk/node.py": node("import serial", "import arm"),
    }
    assert missing(lint(files)) == ["arm"]


def test_two_packages_of_nearly_one_name_are_no_slip(lint: Lint):
    files = {
        "arm_interface/package.xml": manifest("arm_interface"),
        "arm_interface/arm_interface/__init__.py": "",
        "talk/package.xml": manifest("talk", *depends("rclpy", "arm_interfazes")),
        "talk/talk/node.py": node("import arm_interface"),
    }
    (slip,) = lint(files)
    assert slip.message.endswith("; did you mean 'arm_interface' by 'arm_interfazes'?")
    assert slip.help.startswith("write 'arm_interface' for 'arm_interfazes' in line ") and "add" not in slip.help
    (both,) = lint(files | {"arm_interfazes/package.xml": manifest("arm_interfazes")})
    assert "did you mean" not in both.message


def test_a_name_with_its_words_in_another_order(lint: Lint):
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy", "sensor_geometry_msgs", "tf2_msgs_geometry")),
        "talk/talk/node.py": node("import tf2_geometry_msgs", "from sensor_msgs.msg import Imu"),
    }
    (found,) = lint(files)
    assert found.help.startswith("write 'tf2_geometry_msgs' for 'tf2_msgs_geometry' in line ")
    assert found.help.endswith("; add <exec_depend>sensor_msgs</exec_depend> to talk/package.xml")


def test_a_name_that_is_told_to_be_another_one_is_told_once(lint: Lint):
    """PKG008 says what to write for it: to declare that beside it would be one line too many."""
    files = {
        "package.xml": manifest("talk", *depends("rclpy", "sensor_msg")),
        "talk/talk/node.py": node(LASER, POSE),
    }
    assert missing(lint(files)) == ["geometry_msgs"]
    assert [row.meant for row in lint(files, code="PKG008")] == ["sensor_msgs"]
    files["package.xml"] = manifest("talk", *depends("rclpy"), *depends("sensor_msg", tag="test_depend"))
    assert missing(lint(files)) == ["geometry_msgs", "sensor_msgs"]


def test_a_name_of_ros_1_stands_for_that_of_ros_2(lint: Lint):
    files = built("find_package(rclcpp REQUIRED)", *depends("roscpp", tag="depend"))
    assert lint(files) == []
    assert [row.meant for row in lint(files, code="PKG008")] == ["rclcpp"]
    shown = {
        "package.xml": manifest("talk", *depends("rclpy", "rviz")),
        "launch/it.launch.xml": '<launch><node pkg="rviz2" exec="rviz2"/><node pkg="joy" exec="joy_node"/></launch>',
    }
    assert missing(lint(shown)) == ["joy"]
    assert [row.meant for row in lint(shown, code="PKG008")] == ["rviz2"]


# -------------------------------------------------------------------------------------------------- one finding


def test_one_finding_for_a_package_with_each_place(lint: Lint):
    files = {
        "package.xml": manifest("talk", *depends("rclpy")),
        "talk/a.py": node(LASER, POSE),
        "talk/b.py": node(LASER),
        "launch/it.launch.xml": '<launch>\n<node pkg="joy" exec="joy_node"/></launch>',
    }
    (found,) = lint(files)
    assert found.message == (
        "package 'talk' uses 3 packages that its package.xml does not declare: geometry_msgs, joy, sensor_msgs"
    )
    assert (found.place.file, found.place.line) == ("launch/it.launch.xml", 2)
    assert [(one.place.file, one.place.line, one.message) for one in found.related] == [
        ("talk/a.py", 3, "'geometry_msgs' is imported here"),
        ("talk/a.py", 2, "'sensor_msgs' is imported here and at 1 more place"),
    ]
    assert found.help == "add a line like <exec_depend>geometry_msgs</exec_depend> for each to package.xml"


HELPER = (
    "from launch_ros.actions import Node\n\ndef start(package):\n    return [Node(package=package, executable='run')]\n"
)
CALLER = """\
from helper.launch import start
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription(start('rtabmap_odom'))
"""


def passed_on(*declared: str, helper: tuple[str, ...] = ()) -> dict[str, str]:
    """A package whose launch file gives a package name to the function of another package."""
    return {
        "helper/package.xml": manifest("helper", *depends("launch_ros", *helper)),
        "helper/setup.py": "from setuptools import setup\nsetup(name='helper', packages=['helper'])\n",
        "helper/helper/__init__.py": "",
        "helper/helper/launch.py": HELPER,
        "slam/package.xml": manifest("slam", *depends("helper", *declared)),
        "slam/launch/slam.launch.py": CALLER,
    }


def test_a_package_name_belongs_to_the_launch_file_that_writes_it(lint: Lint):
    (found,) = lint(passed_on())
    assert (found.place.file, found.place.line) == ("slam/launch/slam.launch.py", 5)
    assert "package 'slam' starts a node of 'rtabmap_odom'" in found.message
    assert lint(passed_on("rtabmap_odom")) == []


def test_it_is_enough_if_one_package_on_the_way_declares_it(lint: Lint):
    assert lint(passed_on(helper=("rtabmap_odom",))) == []
    constant = CALLER.replace("import start", "import ODOM, start").replace("'rtabmap_odom'", "ODOM")
    files = passed_on("rtabmap_odom") | {"slam/launch/slam.launch.py": constant}
    assert lint(files | {"helper/helper/launch.py": HELPER + "\nODOM = 'rtabmap_odom'\n"}) == []


def test_files_that_are_asked_for_are_judged_alone(lint: Lint):
    files = {"package.xml": manifest("talk", *depends("rclpy")), "talk/a.py": node(LASER), "talk/b.py": node(POSE)}
    (found,) = lint(files, "talk/b.py")
    assert (found.place.file, missing([found])) == ("talk/b.py", ["geometry_msgs"])


def test_the_manifest_may_lie_above_where_one_stands(lint: Lint, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    lint({"package.xml": manifest("talk", *depends("rclpy")), "talk/deep/a.py": node(LASER)})
    monkeypatch.chdir(tmp_path / "talk" / "deep")
    (found,) = check(Request((".",), load(Path()), cached=False, jobs=1)).findings
    assert (found.place.file, found.help) == ("a.py", "add <exec_depend>sensor_msgs</exec_depend> to ../../package.xml")


def test_a_comment_allows_one_use_and_a_setting_those_of_a_file(lint: Lint):
    files = {
        "package.xml": manifest("talk", *depends("rclpy")),
        "talk/a.py": node(f"{LASER}  # archlint: ignore[PKG001]"),
        "talk/b.py": node(POSE),
        "tools/c.py": node(PATH),
    }
    assert missing(lint(files)) == ["geometry_msgs", "nav_msgs"]
    ignored = '[per-file-ignores]\n"talk/b.py" = ["PKG001"]\n'
    assert missing(lint(files, config=ignored)) == ["nav_msgs"]


# ------------------------------------------------------------------------------------------------------ the fix


def added(found: Finding) -> str | None:
    return None if found.fix is None else "".join(edit.text for edit in found.fix.edits)


def test_the_lines_that_are_missing(lint: Lint):
    files = {"package.xml": manifest("talk", *depends("rclpy")), "talk/a.py": node(LASER, POSE)}
    (found,) = lint(files)
    assert added(found) == "  <exec_depend>geometry_msgs</exec_depend>\n  <exec_depend>sensor_msgs</exec_depend>\n"
    assert found.fix is not None and found.fix.edits[0].place.line == 5


@pytest.mark.parametrize(
    ("written", "line"),
    [
        ("<depend>rclpy</depend>\n<!--\n<depend>nav_msgs</depend>\n-->\n</package>", 3),
        ("<author>A</author>\n<license>MIT</license>\n</package>", 4),  # it declares nothing yet
        ("<depend>rclpy</depend></package>", None),
    ],
)
def test_where_the_missing_lines_go(lint: Lint, written: str, line: int | None):
    head = "<package format='3'><name>talk</name><export><build_type>ament_python</build_type></export>"
    (found,) = lint({"package.xml": f"{head}\n{written}\n", "talk/a.py": node(LASER)})
    assert (None if found.fix is None else found.fix.edits[0].place.line) == line


CIRCLE = {
    "talk/package.xml": manifest("talk", *depends("rclpy")),
    "arm/package.xml": manifest("arm", *depends("hand")),
    "hand/package.xml": manifest("hand", *depends("talk")),
    "talk/talk/a.py": node("from arm.msg import Joint\nprint(Joint)"),
}
EACH_OTHER = {
    "talk/package.xml": manifest("talk", *depends("rclpy")),
    "talk/talk/__init__.py": "",
    "talk/talk/a.py": node("import arm\nprint(arm)"),
    "arm/package.xml": manifest("arm", *depends("rclpy")),
    "arm/arm/__init__.py": "",
    "arm/arm/a.py": node("import talk\nprint(talk)"),
}


def test_no_line_is_asked_for_that_closes_a_circle(lint: Lint):
    assert lint(CIRCLE) == []
    (found,) = lint({**CIRCLE, "talk/talk/a.py": node("from arm.msg import Joint", LASER)})
    assert missing([found]) == ["sensor_msgs"]
    assert added(found) == "  <exec_depend>sensor_msgs</exec_depend>\n"
    assert lint(EACH_OTHER) == []


def test_a_circle_that_one_package_does_not_declare_is_told_where_it_uses_the_other(lint: Lint):
    (found,) = lint(CIRCLE, code="PKG003")
    assert found.message == (
        "packages depend on each other in a circle: talk → arm → hand → talk; 'talk' uses 'arm' here without "
        "declaring it"
    )
    assert (found.place.file, found.place.line) == ("talk/talk/a.py", 2)
    related = [(one.place.file, one.message) for one in found.related]
    assert related == [
        ("arm/package.xml", "'arm' depends on 'hand' here"),
        ("hand/package.xml", "'hand' depends on 'talk' here"),
    ]


@pytest.mark.parametrize(
    ("hand", "help"),
    [
        ("", "remove the dependency of 'hand' on 'talk': nothing in 'hand' uses it"),
        ("from talk.msg import Word\nprint(Word)\n", "move what both need into a separate package"),
    ],
)
def test_a_circle_that_an_unused_dependency_closes(lint: Lint, hand: str, help: str):
    own = {
        "arm/arm/a.py": node("from hand.msg import Finger\nprint(Finger)"),
        "hand/hand/a.py": f"import rclpy\n{hand}",
    }
    (found,) = lint({**CIRCLE, **own}, code="PKG003")
    assert (found.place.file, found.help) == ("talk/talk/a.py", help)


def test_a_circle_of_a_package_that_installs_modules_under_other_names(lint: Lint):
    own = {
        "arm/arm/a.py": node("from hand.msg import Finger\nprint(Finger)"),
        "hand/hand/a.py": "import rclpy\nimport words\nprint(words)\n",
        "talk/src/words/__init__.py": "",
        "talk/src/words/plain.py": "WORDS = ['yes', 'no']\n",
        "talk/package.xml": manifest("talk", *depends("rclpy")).replace("ament_python", "ament_cmake"),
        "talk/CMakeLists.txt": "cmake_minimum_required(VERSION 3.8)\nproject(talk)\n"
        "find_package(ament_cmake REQUIRED)\nfind_package(ament_cmake_python REQUIRED)\n"
        "ament_python_install_package(words PACKAGE_DIR src/words)\nament_package()\n",
    }
    (found,) = lint({**CIRCLE, **own}, code="PKG003")
    assert found.help == "move what both need into a separate package"


@pytest.mark.parametrize(
    ("included", "help"),
    [
        ("drive.launch.xml", "move what uses it from here to a launch file of 'all': other packages include this file"),
        ("", "move the launch files that use it into a package of their own, such as talk_bringup"),
    ],
)
def test_a_launch_file_in_a_circle_is_not_moved_where_others_include_it(lint: Lint, included: str, help: str):
    include = (
        f'<include file="$(find-pkg-share talk)/launch/{included}"/>' if included else '<node pkg="talk" exec="speak"/>'
    )
    drive = '<launch><node pkg="all" exec="watch"/></launch>'
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/launch/drive.launch.xml": drive,
        "all/package.xml": manifest("all", *depends("talk")),
        "all/launch/all.launch.xml": f"<launch>{include}</launch>",
    }
    (found,) = lint(files, code="PKG003")
    assert (found.place.file, found.help) == ("talk/launch/drive.launch.xml", help)


MOVED = "move the launch files that use it into a package of their own, such as talk_bringup"
MOVE = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    other = 'all'
    ranges = 'ranges.yaml'
    file = os.path.join(get_package_share_directory(other), 'config', ranges)
    return LaunchDescription([Node(package='talk', executable='speak', parameters=[file])])
"""


@pytest.mark.parametrize(
    ("robot", "help"),
    [
        (
            "<robot><include file='$(find all)/config/x'/></robot>",
            f"{MOVED}, and with them talk/urdf/it.xacro, which needs it, too",
        ),
        (
            "<robot><include file='package://all/x'/></robot>",
            f"{MOVED}, and with them talk/urdf/it.xacro, which needs it, too",
        ),
        ("<robot><include file='$(find allies)/x'/></robot>", MOVED),
    ],
)
def test_a_description_in_a_circle_goes_with_the_launch_file(lint: Lint, robot: str, help: str):
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy", "launch", "launch_ros")),
        "talk/launch/drive.launch.py": MOVE,
        "talk/urdf/it.xacro": robot,
        "all/package.xml": manifest("all", *depends("talk")),
        "all/config/ranges.yaml": "",
        "all/launch/all.launch.xml": '<launch><node pkg="talk" exec="speak"/></launch>',
    }
    (found,) = lint(files, code="PKG003")
    assert (found.place.file, found.place.line, found.help) == ("talk/launch/drive.launch.py", 9, help)


def including(*packages: str) -> str:
    paths = [f"$(find-pkg-share {package})/launch/it.launch.xml" for package in packages]
    return "".join(["<launch>", *(f'<include file="{path}"/>' for path in paths), "</launch>"])


def test_circles_through_the_launch_file_of_one_package_are_one_finding(lint: Lint):
    """The package of the messages starts all others; one of these uses another one without declaring it, too."""
    files = {
        "msgs/package.xml": manifest("msgs", *depends("rclpy")),
        "msgs/launch/it.launch.xml": including("arm", "leg", "world"),
        "world/package.xml": manifest("world", *depends("rclpy")),
        "world/launch/it.launch.xml": including("arm"),
        "mission/package.xml": manifest("mission", *depends("rclpy", "msgs")),
        "mission/launch/it.launch.xml": including("msgs"),
    }
    for name in ("arm", "leg"):
        files[f"{name}/package.xml"] = manifest(name, *depends("rclpy", "msgs"))
        files[f"{name}/launch/it.launch.xml"] = f"<launch><node pkg='{name}' exec='run'/></launch>"
    (found,) = lint(files, code="PKG003")
    assert found.place.file == "msgs/launch/it.launch.xml"
    assert found.message == "'msgs' uses 3 packages that depend on it, without declaring them: arm, leg, world"
    assert found.help == (
        "move the launch files that use it into a package of their own, such as msgs_bringup, and with them those of "
        "other packages that include them"
    )


def test_a_package_that_closes_several_circles_is_told_once(lint: Lint):
    uses = node("import arm\nimport leg\nprint(arm, leg)")
    leg = {
        "leg/package.xml": manifest("leg", *depends("rclpy", "talk")),
        "leg/leg/__init__.py": "",
        "leg/leg/a.py": node(),
    }
    leg["arm/package.xml"] = manifest("arm", *depends("rclpy", "talk"))
    (found,) = lint({**EACH_OTHER, **leg, "talk/talk/a.py": uses}, code="PKG003")
    assert found.message == "'talk' uses 2 packages that depend on it, without declaring them: arm, leg"
    assert found.help == "move what both need into a separate package"
    assert [one.message for one in found.related] == ["'leg' is used here"]


REMOVE = "remove find_package() of arm: nothing else in 'talk' uses it"
SHARE = "move what both need into a separate package"


@pytest.mark.parametrize(
    ("lines", "code", "help"),
    [
        ("find_package(arm REQUIRED)  # of the arm", {}, REMOVE),
        ("find_package(arm REQUIRED)", {"talk/scripts/say.py": "print('arm')\n"}, REMOVE),
        ("find_package(arm REQUIRED)\nament_target_dependencies(speak arm)", {}, SHARE),
        ("find_package(arm REQUIRED)", {"talk/src/say.cpp": '#include "arm/arm.hpp"\n'}, SHARE),
        ("find_package(arm REQUIRED)", {"talk/scripts/say.py": "def say():\n    import arm\n"}, SHARE),
    ],
)
def test_a_circle_that_a_needless_find_package_closes(lint: Lint, lines: str, code: dict[str, str], help: str):
    talk = {f"talk/{name}": text.replace("robot", "talk") for name, text in built(lines).items()}
    arm = {
        "arm/package.xml": manifest("arm", *depends("rclpy", "talk")),
        "arm/arm/__init__.py": "",
        "arm/arm/a.py": node("from talk.msg import Word\nprint(Word)"),
    }
    (told,) = lint({**talk, **arm, **code}, code="PKG003")
    assert told.help == help


def shared(*users: str) -> dict[str, str]:
    """Packages that import the names of topics from the one that starts their nodes."""
    files = {
        "robot/package.xml": manifest("robot", *depends("launch_ros")),
        "robot/robot/__init__.py": "",
        "robot/robot/topics.py": "SCAN = '/scan'\n",
        "robot/launch/robot.launch.xml": "".join(
            ["<launch>", *(f"<node pkg='{user}' exec='{user}'/>" for user in users), "</launch>"]
        ),
    }
    for user in users:
        files[f"{user}/package.xml"] = manifest(user, *depends("rclpy"))
        files[f"{user}/{user}/__init__.py"] = ""
        files[f"{user}/{user}/a.py"] = node("from robot.topics import SCAN\nprint(SCAN)")
    return files


def test_circles_through_one_shared_package_are_one_finding(lint: Lint):
    (found,) = lint(shared("arm", "leg", "wheel"), code="PKG003")
    assert found.message == (
        "packages depend on each other in a circle: arm → robot → arm; 'arm' uses 'robot' here without declaring it; "
        "2 more packages use 'robot' in a circle, too"
    )
    assert found.help == (
        "move the launch files of 'robot' that use 'arm' into a package of their own, such as robot_bringup"
    )
    assert [one.place.file for one in found.related] == [
        "robot/launch/robot.launch.xml",
        "leg/leg/a.py",
        "wheel/wheel/a.py",
    ]
    (alone,) = lint(shared("arm"), code="PKG003")
    assert alone.message.endswith("'arm' uses 'robot' here without declaring it")


@pytest.mark.parametrize(
    "more",
    [
        {"robot/robot/tool.py": node("from arm.limits import FAR\nprint(FAR)"), "arm/arm/limits.py": "FAR = 1.0\n"},
        {"robot/urdf/it.xacro": "<robot><include file='$(find arm)/urdf/arm.xacro'/></robot>"},
    ],
)
def test_a_circle_that_moving_launch_files_does_not_end(lint: Lint, more: dict[str, str]):
    (found,) = lint({**shared("arm"), **more}, code="PKG003")
    assert "bringup" not in (found.help or "")


@pytest.mark.parametrize(
    ("comment", "told"),
    [
        ("<!-- robot is not declared here, to avoid a circular dependency -->", 0),
        ("<!-- not declared:\n  'robot' would close a cycle -->", 0),
        ("<!-- robot is started by hand -->", 1),
        ("<!-- robots in no circular dependency -->", 1),
    ],
)
def test_a_circle_that_a_comment_of_the_manifest_avoids_is_decided(lint: Lint, comment: str, told: int):
    files = shared("arm")
    files["arm/package.xml"] = manifest("arm", *depends("rclpy"), comment)
    assert len(lint(files, code="PKG003")) == told


def test_two_packages_that_import_each_other(lint: Lint):
    (found,) = lint(EACH_OTHER, code="PKG003")
    assert (found.place.file, [one.place.file for one in found.related]) == ("arm/arm/a.py", ["talk/talk/a.py"])
    assert lint({**EACH_OTHER, "talk/talk/a.py": node()}, code="PKG003") == []
    guarded = node("try:\n    import arm\nexcept ImportError:\n    arm = None")
    assert lint({**EACH_OTHER, "talk/talk/a.py": guarded}, code="PKG003") == []


@pytest.mark.parametrize(
    "left_over",
    [
        "import arm",  # nothing uses it
        "from arm.a import Grip\nprint(Grip)",  # it has no such class
    ],
)
def test_an_import_that_is_to_be_removed_closes_no_circle(lint: Lint, left_over: str):
    setup = {"arm/setup.py": "from setuptools import setup\nsetup(name='arm', packages=['arm'])\n"}
    assert lint({**EACH_OTHER, **setup, "talk/talk/a.py": node(left_over)}, code="PKG003") == []


def test_the_package_of_a_node_is_named_by_who_calls_the_helper(lint: Lint):
    """A helper of another package starts nodes of the packages that its callers name, which declare them."""
    files = {
        "helper/package.xml": manifest("helper", *depends("launch_ros")),
        "helper/helper/__init__.py": "",
        "helper/helper/start.py": (
            "from launch_ros.actions import Node\n"
            "def start(package, executable):\n    return [Node(package=package, executable=executable)]\n"
        ),
        "slam/package.xml": manifest("slam", *depends("helper", "rtabmap_odom")),
        "slam/launch/slam.launch.py": (
            "from helper.start import start\nfrom launch import LaunchDescription\n"
            "def generate_launch_description():\n    return LaunchDescription(start('rtabmap_odom', 'rgbd_odometry'))\n"
        ),
    }
    assert lint(files) == []
    (found,) = lint({**files, "slam/package.xml": manifest("slam", *depends("helper"))})
    assert (found.place.file, found.place.line, missing([found])) == ("slam/launch/slam.launch.py", 4, ["rtabmap_odom"])


@pytest.mark.parametrize(
    ("path", "text", "line"),
    [
        ("build.sh", "colcon build \\\n  --packages-skip arm camera --symlink-install\n", 2),
        ("docker/Dockerfile", "FROM ros:jazzy\nRUN colcon build --packages-ignore 'camera'\n", 2),
        (".github/workflows/ci.yml", "steps:\n  - run: colcon test --packages-skip camera\n", 2),
        ("build.sh", "colcon build --packages-skip arm\ncolcon build --packages-select camera\n", None),
        ("build.sh", "# colcon build --packages-skip camera\n", None),
        ("build.sh", "colcon build --packages-skip-regex camera\n", None),
        ("notes.txt", "colcon build --packages-skip camera\n", None),
    ],
)
def test_a_package_that_a_build_leaves_out(lint: Lint, path: str, text: str, line: int | None):
    files = {
        "robot/package.xml": manifest("robot", *depends("rclpy")),
        "robot/talk.py": node("import camera", POSE),
        "camera/package.xml": manifest("camera"),
        "camera/camera/__init__.py": "",
        path: text,
    }
    [found] = lint(files)
    assert missing([found]) == ["camera", "geometry_msgs"]
    assert ("camera" in (added(found) or "")) is (line is None) and "geometry_msgs" in (added(found) or "")
    out = [(one.place.file, one.place.line) for one in found.related if "left out of a build" in one.message]
    assert out == ([] if line is None else [(path, line)])


def test_types_of_a_package_that_is_nowhere_are_told_apart(lint: Lint):
    """Nobody knows what to declare: it may be the old name of another one, and rosdep would stop at it."""
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/talk/a.py": node("from secret_msgs.msg import X", LASER),
    }
    first, second = lint(files)
    assert first.message.startswith(
        "package 'talk' imports 'secret_msgs', which is neither in this workspace nor in rosdistro"
    )
    assert missing([second]) == ["sensor_msgs"]


STARTS = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([{0}])
"""


def launching(*actions: str) -> dict[str, str]:
    return {
        "talk/package.xml": manifest("talk", *depends("rclpy", "launch_ros")),
        "talk/launch/talk.launch.py": STARTS.format(", ".join(actions)),
    }


def started(package: str, executable: str = "run_it") -> str:
    return f"Node(package='{package}', executable='{executable}')"


@pytest.mark.parametrize(
    ("package", "comment", "told"),
    [
        ("isaac_ros_visual_slam", "", 0),  # NVIDIA has a repository of its own for apt
        ("visual_slam", "", 1),
        ("secret_driver", "# https://example.org/acme/secret_driver", 0),
        ("secret_driver", "# https://example.org/acme/secret-driver_node.git", 0),
        ("secret_driver", "# https://example.org/acme/secret_drivers", 1),
        ("secret_driver", "# secret_driver is started here", 1),
    ],
)
def test_a_launch_file_that_says_where_a_package_comes_from(lint: Lint, package: str, comment: str, told: int):
    files = launching(started(package))
    launch_file = "talk/launch/talk.launch.py"
    assert len(lint(files | {launch_file: f"{comment}\n{files[launch_file]}"})) == told


def test_a_package_that_a_launch_file_names_and_that_is_nowhere(lint: Lint):
    (found,) = lint(launching(started("secret_driver")))
    assert found.message == (
        "package 'talk' starts a node of 'secret_driver', which is neither in this workspace nor in rosdistro, "
        "and which its package.xml does not declare"
    )
    assert (found.fix, found.place.line) == (None, 8)


@pytest.mark.parametrize(
    ("document", "told"),
    [
        ("- secret_driver: in a repository of its own\n", 0),
        ("    ros2 run secret_driver it\n", 1),
        ("- secret_driver: in a repository of its own\n\n    ros2 launch talk talk.launch.py\n", 1),
        ("- secret_drivers\n", 1),
    ],
)
def test_a_launch_file_for_a_module_of_which_a_document_speaks(lint: Lint, document: str, told: int):
    """Nothing starts it here: who has that module does."""
    assert len(lint(launching(started("secret_driver")) | {"README.md": document})) == told


@pytest.mark.parametrize(
    ("declared", "told"), [("secret_bringup", 0), ("secret_msgs", 1), ("message_generation", 1), ("rclpy", 1)]
)
def test_a_package_that_an_unknown_one_may_bring(lint: Lint, declared: str, told: int):
    files = launching(started("secret_driver"))
    files["talk/package.xml"] = manifest("talk", *depends("rclpy", "launch_ros", declared))
    found = lint(files)
    assert len(found) == told
    assert [("where 'secret_msgs' does" in (row.help or "")) for row in found] == [declared == "secret_msgs"] * told


FOLDER = "get_package_share_directory('secret_models')"


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (f"FOLDER = {FOLDER}", 1),
        (f"def load():\n    return {FOLDER} + '/model.pt'", 1),
        # It may do without the package, or without the branch.
        (f"try:\n    FOLDER = {FOLDER}\nexcept Exception:\n    FOLDER = '.'", 0),
        (f"if SIMULATED:\n    FOLDER = {FOLDER}", 0),
        ("FOLDER = get_package_share_directory('nav2_bringup')", 0),
        ("FOLDER = get_package_share_directory('talk')", 0),
        ("FOLDER = 'secret_models'", 0),
    ],
)
def test_a_package_that_a_node_looks_for_and_that_is_nowhere(lint: Lint, lines: str, told: int):
    index = "from ament_index_python.packages import get_package_share_directory"
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy", "ament_index_python")),
        "talk/talk/a.py": f"SIMULATED = True\n{node(index)}\n{lines}\n",
    }
    found = lint(files)
    assert [row.message for row in found] == [
        "package 'talk' looks for the folder of 'secret_models', which is neither in this workspace nor in rosdistro, "
        "and which its package.xml does not declare"
    ] * told
    declared = manifest("talk", *depends("rclpy", "ament_index_python", "secret_models"))
    assert lint(files | {"talk/package.xml": declared}) == []


@pytest.mark.parametrize(
    ("installed", "include", "told"),
    [
        ("glob('launch/*.launch.py')", "nav2_bringup", False),
        ("glob('launch/*.launch.py')", "talk", True),
        ("glob('launch/*.py')", "nav2_bringup", True),
        ("['nothing.py']", "nav2_bringup", True),  # no launch file is installed: they are forgotten
    ],
)
def test_a_launch_file_that_is_left_out_and_that_none_includes(lint: Lint, installed: str, include: str, told: bool):
    path = f"get_package_share_directory('{include}') + '/launch/navigation_launch.py'"
    action = f"IncludeLaunchDescription(PythonLaunchDescriptionSource({path}))"
    head = "from launch.actions import IncludeLaunchDescription\n"
    head += "from launch.launch_description_sources import PythonLaunchDescriptionSource\n"
    setup = "from glob import glob\nfrom setuptools import setup\nsetup(name='talk', packages=['talk'],\n"
    files = {
        **launching(),
        "talk/package.xml": manifest("talk", *depends("rclpy", "launch_ros", "nav2_bringup")),
        "talk/launch/talk.launch.py": head + STARTS.format(action),
        "talk/launch/navigation_launch.py": STARTS.format(started("usb_cam")),
        "talk/setup.py": f"{setup}      data_files=[('share/talk/launch', {installed})])\n",
        "talk/talk/__init__.py": "",
        "talk/talk/a.py": node("from ackermann_msgs.msg import AckermannDrive"),
    }
    (found,) = lint(files)
    assert missing([found]) == (["ackermann_msgs", "usb_cam"] if told else ["ackermann_msgs"])


@pytest.mark.parametrize("name", ["secret_driver", "secret-driver", "secretdriver"])
def test_a_package_that_a_list_of_repositories_brings(lint: Lint, name):
    listed = f"repositories:\n  {name}:\n    type: git\n    url: https://example.org/it.git\n"
    (found,) = lint(launching(started("secret_driver")) | {"all.repos": listed})
    assert found.message == "package 'talk' starts a node of 'secret_driver', which its package.xml does not declare"
    assert found.help == "add <exec_depend>secret_driver</exec_depend> to talk/package.xml"


@pytest.mark.parametrize(
    ("name", "is_known"), [("secret", True), ("drivers", False), ("sec", False), ("driver", False)]
)
def test_a_repository_may_bring_a_package_of_a_longer_name(lint: Lint, name: str, is_known: bool):
    listed = f"repositories:\n  {name}:\n    type: git\n    url: https://example.org/it.git\n"
    (told,) = lint(launching(started("secret_driver")) | {"all.repos": listed})
    assert ("nor in rosdistro" not in told.message) is is_known


@pytest.mark.parametrize(
    ("files", "help"),
    [
        ({}, "declare it in package.xml if a repository of all.repos has it, else correct the name"),
        (
            {"drivers/package.xml": manifest("sonar")},
            "correct the name, or declare it in package.xml and say where it comes from",
        ),
    ],
    ids=["not here", "here"],
)
def test_a_repository_of_another_name_may_bring_any_package(lint: Lint, files: dict[str, str], help: str):
    listed = {"all.repos": "repositories:\n  drivers:\n    type: git\n    url: https://example.org/it.git\n"}
    (told,) = lint(launching(started("secret_board")) | listed | files)
    assert told.help == help


@pytest.mark.parametrize(
    ("tag", "help"),
    [
        ("<exec_depend>base_board</exec_depend>", "declare it in package.xml if it comes from where 'base_board' does"),
        ("<buildtool_depend>ament_python</buildtool_depend>", "correct the name, or declare it in package.xml and say"),
    ],
)
def test_what_builds_a_package_is_from_nowhere(lint: Lint, tag: str, help: str):
    """``ament_python`` is no package, and no project that brings others."""
    files = launching(started("secret_driver"))
    [path] = [name for name in files if name.endswith("package.xml")]
    (told,) = lint(files | {path: files[path].replace("  <export>", f"  {tag}\n  <export>")})
    assert (told.help or "").startswith(help)


def test_a_repository_that_is_here_brings_no_other_package(lint: Lint):
    listed = {"all.repos": "repositories:\n  secret_driver:\n    type: git\n    url: https://example.org/it.git\n"}
    here = {"others/secret_driver/package.xml": manifest("secret4_driver")}
    (found,) = lint(launching(started("secret_driver"), started("rviz2")) | listed)
    assert "uses 2 packages" in found.message
    (found,) = lint(launching(started("secret_driver"), started("rviz2")) | listed | here)
    assert found.message == "package 'talk' starts a node of 'rviz2', which its package.xml does not declare"


def test_all_that_are_nowhere_are_one_finding_for_a_package(lint: Lint):
    config = "get_package_share_directory('secret_maps') + '/maps/hall.yaml'"
    actions = [started("secret_driver"), f"Node(package='talk', executable='a', parameters=[{{'map': {config}}}])"]
    (found,) = lint(launching(*actions))
    assert found.message == (
        "package 'talk' uses 2 packages that are neither in this workspace nor in rosdistro, and that its "
        "package.xml does not declare: secret_driver, secret_maps"
    )
    assert [row.message for row in found.related] == ["'secret_maps' is named here"]


def test_a_package_of_ros_1_has_a_successor(lint: Lint):
    (found,) = lint(launching(started("map_server")))
    assert found.message.endswith("; did you mean 'nav2_map_server'?")


@pytest.mark.parametrize(
    "more",
    [
        {"archlint.toml": 'select = ["PKG001"]\nexternal = ["secret_driver"]\n'},
        {"README.md": "git clone https://example.org/secret_driver.git\n"},
        {"robot.repos": "repositories: {drivers/secret_driver: {type: git}}\n"},
        {"drivers/secret_driver/CMakeLists.txt": "project(secret_driver)\n"},
        {"talk/.gitignore": "x\n", "README.md": "For ROS 2 Foxy.\n"},
        {"other/package.xml": "<package><name>secret_driver</name><"},
    ],
)
def test_a_package_that_may_be_somewhere(lint: Lint, more: dict[str, str]):
    assert [found for found in lint(launching(started("secret_driver")) | more) if found.code == "PKG001"] == []


def test_a_package_of_a_distribution_that_has_ended(lint: Lint):
    assert lint(launching(started("nav2_recoveries", "recoveries_server"))) == []


def test_a_name_of_which_another_rule_says_what_is_meant(lint: Lint):
    assert lint(launching(started("your_package"))) == []


@pytest.mark.parametrize(
    ("path", "told"),
    [
        ("talk/talk/data/plot.py", 0),  # no package of Python, so that nothing installs it
        ("talk/talk/plot.py", 1),
        ("talk/plot.py", 0),
    ],
)
def test_a_script_that_is_run_by_hand_where_it_lies(lint: Lint, path: str, told: int):
    entries = "entry_points={'console_scripts': ['talk = talk.main:main']}"
    setup = "from setuptools import find_packages, setup\nsetup(name='talk', packages=find_packages(), {})\n"
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/setup.py": setup.format(entries),
        "talk/talk/__init__.py": "",
        "talk/talk/main.py": "import rclpy\n\n\ndef main():\n    rclpy.init()\n",
        path: node(LASER),
    }
    assert len(lint(files)) == told


def test_no_fix_names_a_package_that_only_another_manifest_knows(lint: Lint):
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/talk/a.py": node("from secret_msgs.msg import X"),
        "user/package.xml": manifest("user", *depends("secret_msgs")),
    }
    (found,) = lint(files)
    assert (missing([found]), found.fix) == (["secret_msgs"], None)


def test_the_place_is_one_that_runs(lint: Lint):
    """Neither a copy nor a module that no program imports, where there is a better one."""
    files = {
        "package.xml": manifest("robot", *depends("rclpy")),
        "setup.py": SETUP,
        "robot/__init__.py": "",
        "robot/kept (copy).py": node(LASER, POSE, PATH),
        "robot/older.py": node(LASER, POSE),
        "robot/talker.py": node("from robot import tools", LASER),
        "robot/tools.py": "",
    }
    told, *_ = lint(files)
    assert missing([told]) == ["geometry_msgs", "sensor_msgs"]
    assert (told.place.file, told.place.line) == ("robot/talker.py", 3)
    assert [row.place.file for row in told.related] == ["robot/older.py"]


def test_each_file_goes_by_the_manifest_around_it(lint: Lint):
    """Two packages of one name, and a package.xml inside a package, which makes none."""
    files = {
        "old/package.xml": manifest("talk", *depends("rclpy")),
        "old/talk/a.py": node(LASER),
        "new/package.xml": manifest("talk", *depends("rclpy", "sensor_msgs")),
        "new/talk/a.py": node(LASER),
        "new/template/package.xml": manifest("template"),
        "new/template/template/a.py": node(POSE),
    }
    (found,) = lint(files)
    assert found.place.file == "old/talk/a.py"
    assert found.fix is not None and found.fix.edits[0].place.file == "old/package.xml"


@pytest.mark.parametrize("head", ["", 'format="1"'])
def test_format_1_calls_it_otherwise_and_refuses_a_second_mention(lint: Lint, head: str):
    tags = [*depends("rclpy", tag="run_depend"), *depends("geometry_msgs", tag="test_depend")]
    (found,) = lint({"package.xml": manifest("talk", *tags, head=head), "talk/a.py": node(LASER, POSE)})
    assert added(found) == "  <run_depend>sensor_msgs</run_depend>\n"


# ---------------------------------------------------------------------------------------------------- the table


def test_the_table_of_known_packages():
    known = table()
    assert {"rclpy", "navigation2", "imu_tools", "desktop", "turtlesim"} <= known.names
    assert "numpy" not in known.names
    assert all(set(needs) <= known.names and name not in needs for name, needs in known.brings.items())


# --------------------------------------------------------------------------------------- what a build asks for


def built(find: str, *tags: str) -> dict[str, str]:
    """A package that CMake builds, with a command among those of its CMakeLists.txt."""
    by_cmake = manifest("robot", *depends("ament_cmake", tag="buildtool_depend"), *tags).replace("_python", "_cmake")
    head = "cmake_minimum_required(VERSION 3.8)\nproject(robot)\nfind_package(ament_cmake REQUIRED)\n"
    return {"package.xml": by_cmake, "CMakeLists.txt": f"{head}{find}\nament_package()\n"}


@pytest.mark.parametrize(
    ("find", "message", "tag"),
    [
        ("find_package(rclcpp REQUIRED)", "builds with 'rclcpp'", "depend"),
        ("find_package(rosidl_default_generators REQUIRED)", "builds with 'rosidl_default", "buildtool_depend"),
        ("find_package(eigen3_cmake_module REQUIRED)", "builds with 'eigen3_cmake_module'", "buildtool_depend"),
        ("find_package(ament_index_cpp REQUIRED)", "builds with 'ament_index_cpp'", "depend"),  # a library
        ("if(BUILD_TESTING)\nfind_package(ament_lint_auto REQUIRED)\nendif()", "builds its tests with", "test_depend"),
        (
            "# set(BUILD_TESTING OFF)\nif(BUILD_TESTING)\nfind_package(ament_lint_auto REQUIRED)\nendif()",
            "builds its tests with",
            "test_depend",
        ),
        ("foreach(name std_srvs)\nfind_package(${name} REQUIRED)\nendforeach()", "builds with 'std_srvs'", "depend"),
    ],
)
def test_what_cmake_asks_for(lint: Lint, find: str, message: str, tag: str):
    (one,) = lint(built(find))
    assert f"package 'robot' {message}" in one.message
    assert f"add <{tag}>" in (one.help or "")


@pytest.mark.parametrize(
    ("find", "tags"),
    [
        ("find_package(rclcpp REQUIRED)", depends("rclcpp", tag="build_depend")),
        ("find_package(rclcpp REQUIRED)", depends("rclcpp", tag="test_depend")),
        ("find_package(rcl REQUIRED)", depends("rclcpp")),  # brought along
        ("find_package(rclcpp)", []),
        ("find_package(ament_cmake_python REQUIRED)", []),  # ament_cmake brings it
        ("find_package(Eigen3 REQUIRED)", []),  # no package of ROS
        ("find_package(urdfdom REQUIRED)", depends("liburdfdom-dev")),
        ("find_package(eigen3_cmake_module REQUIRED)", depends("flight_lib")),  # nobody knows what that exports
        ("if(WITH_NODE)\nfind_package(rclcpp REQUIRED)\nendif()", []),
        ("if(BUILD_TESTING)\nelse()\nfind_package(rclcpp REQUIRED)\nendif()", []),
        ("set(BUILD_TESTING OFF)\nif(BUILD_TESTING)\nfind_package(rclcpp REQUIRED)\nendif()", []),
        ("if(BUILD_TESTING)\nif(WITH_NODE)\nfind_package(rclcpp REQUIRED)\nendif()\nendif()", []),
        ("if(WIN32)\nreturn()\nendif()\nfind_package(rclcpp REQUIRED)", []),
        ("# find_package(rclcpp REQUIRED)", []),
    ],
)
def test_what_cmake_does_not_need_declared(lint: Lint, find: str, tags: list[str]):
    assert lint(built(find, *tags)) == []


@pytest.mark.parametrize(
    ("declared", "told"),
    [("ament_cmake_ros", 0), ("ament_cmake_auto", 0), ("ament_cmake_python", 1), ("ament_cmake_core", 1)],
)
def test_what_exports_ament_cmake(lint: Lint, declared: str, told: int):
    files = built("")
    files["package.xml"] = files["package.xml"].replace("ament_cmake<", f"{declared}<", 1)
    messages = [row.message for row in lint(files)]
    assert messages == told * ["package 'robot' builds with 'ament_cmake', which its package.xml does not declare"]


@pytest.mark.parametrize(("others", "told"), [(["rclcpp", "std_msgs"], 1), (["rclcpp", "acme_base"], 0), ([], 1)])
def test_what_others_are_built_with_is_not_brought_along(lint: Lint, others: list[str], told: int):
    files = built("", *depends(*others, tag="depend"))
    files["package.xml"] = files["package.xml"].replace("<buildtool_depend>ament_cmake</buildtool_depend>", "")
    messages = [row.message for row in lint(files)]
    assert messages == told * ["package 'robot' builds with 'ament_cmake', which its package.xml does not declare"]


OTHER = manifest("arm_msgs", *depends("std_msgs"))


def with_other(find: str, *tags: str) -> dict[str, str]:
    """Such a package below one that it needs."""
    files = {f"robot/{name}": text for name, text in built(find, *tags).items()}
    return {**files, "arm_msgs/package.xml": OTHER, "arm_msgs/setup.py": SETUP}


FIND_OTHER = "find_package(arm_msgs REQUIRED)"


LINT = "if(BUILD_TESTING)\nfind_package(ament_lint_auto REQUIRED)\nendif()"


@pytest.mark.parametrize(
    ("find", "lines"),
    [
        ("find_package(std_srvs REQUIRED)", "<depend>std_srvs</depend> and <test_depend>ament_lint_auto</test_depend>"),
        (
            "find_package(std_srvs REQUIRED)\nfind_package(rclcpp REQUIRED)",
            "a line like <depend>rclcpp</depend> for rclcpp, std_srvs, and <test_depend>ament_lint_auto</test_depend>",
        ),
    ],
)
def test_each_kind_of_dependency_has_its_line(lint: Lint, find: str, lines: str):
    (told,) = lint(built(f"{LINT}\n{find}"))
    assert told.help == f"add {lines} to package.xml"


def test_format_1_has_a_line_for_the_build_and_one_for_running(lint: Lint):
    files = built("find_package(std_srvs REQUIRED)")
    files["package.xml"] = files["package.xml"].replace('format="3"', 'format="1"')
    (told,) = lint(files)
    assert told.help == "add <build_depend>std_srvs</build_depend> and <run_depend>std_srvs</run_depend> to package.xml"
    assert added(told) == "  <build_depend>std_srvs</build_depend>\n  <run_depend>std_srvs</run_depend>\n"


@pytest.mark.parametrize(
    ("find", "tags"),
    [
        (FIND_OTHER, depends("arm_msgs", tag="depend")),
        (FIND_OTHER, depends("arm_msgs", tag="exec_depend")),  # colcon builds it first, too
        (FIND_OTHER, [*depends("arm_msgs", tag="test_depend")]),
        (f"if(BUILD_TESTING)\n{FIND_OTHER}\nendif()", depends("arm_msgs", tag="exec_depend")),
        ("find_package(std_msgs REQUIRED)", depends("std_msgs", tag="exec_depend")),  # there before the workspace is
    ],
)
def test_what_is_there_when_the_package_is_built(lint: Lint, find: str, tags: list[str]):
    assert lint(with_other(find, *tags)) == []


AUTO = (
    "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
    'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Speed.msg")'
)


def test_a_package_of_interfaces_whose_generators_only_package_xml_can_name(lint: Lint):
    auto = depends("ament_cmake_auto", tag="buildtool_depend")
    files = {"msg/Speed.msg": "float64 speed\n"}
    (one,) = lint(built(AUTO, *auto) | files)
    assert one.help == "add <buildtool_depend>rosidl_default_generators</buildtool_depend> to package.xml"
    declared = depends("rosidl_default_generators", tag="buildtool_depend")
    assert lint(built(AUTO, *auto, *declared) | files) == []
    assert lint(built(f"find_package(rosidl_default_generators)\n{AUTO}", *auto) | files) == []


DESCRIBED = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch.substitutions import Command, FindExecutable, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

def generate_launch_description():
    return LaunchDescription([{}])
"""


@pytest.mark.parametrize(
    ("action", "needed"),
    [
        ("Node(package='robot', executable='a', parameters=[{'d': Command(['xacro ', 'a.xacro'])}])", ["xacro"]),
        ("Node(package='robot', executable='a', parameters=[{'d': Command('cat a.urdf')}])", []),
        ("Node(package='robot', executable='a', arguments=[FindExecutable(name='xacro')])", ["xacro"]),
        ("ExecuteProcess(cmd=['rviz2', '-d', 'a.rviz'], output='screen')", ["rviz2"]),
        ("ExecuteProcess(cmd=[['rviz2 ', '-d a.rviz']], shell=True)", ["rviz2"]),
        ("ExecuteProcess(cmd=['gazebo', '--verbose'], name='rviz2')", []),
        ("ExecuteProcess(cmd=['bash', '-c', 'rviz2'])", []),
        ("IncludeLaunchDescription([FindPackageShare('nav2_bringup'), '/launch/a.launch.py'])", ["nav2_bringup"]),
        ("IncludeLaunchDescription([FindPackageShare('robot'), '/launch/a.launch.py'])", []),
    ],
)
def test_what_launch_files_need_besides_nodes(lint: Lint, action: str, needed: list[str]):
    files = {"package.xml": manifest("robot", *depends("rclpy")), "launch/robot.launch.py": DESCRIBED.format(action)}
    assert missing(lint(files)) == needed


@pytest.mark.parametrize(
    ("tags", "needed"),
    [
        ([], ["launch_testing"]),
        (depends("launch_testing", tag="test_depend"), []),
        (depends("launch_testing_ament_cmake", tag="test_depend"), []),
    ],
)
def test_what_tests_import(lint: Lint, tags: list[str], needed: list[str]):
    files = {
        "package.xml": manifest("robot", *depends("rclpy"), *tags),
        "test/test_robot.py": "import launch_testing\nimport nav_msgs.msg\nimport rclpy\n",
    }
    assert missing(lint(files)) == needed


def test_a_circle_that_a_copy_of_a_launch_file_closes(lint: Lint):
    both = "".join(f"Node(package='{package}', executable='it'), " for package in ("arm", "talk"))
    launch = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        f"def generate_launch_description():\n    return LaunchDescription([{both}])\n"
    )
    files = {
        **{f"{name}/package.xml": manifest(name, *depends("launch", "launch_ros")) for name in ("arm", "talk")},
        "arm/launch/both.launch.py": launch,
        "talk/launch/both.launch.py": launch,
    }
    (found,) = lint(files, code="PKG003")
    assert found.help == "remove talk/launch/both.launch.py: it is a copy of this file"
    assert found.severity is Severity.INFO  # what a launch file starts is found when it runs
    changed = {"talk/launch/both.launch.py": f"{launch}# For the arm alone.\n"}
    assert lint({**files, **changed}, code="PKG003") == []
    code = {"arm/arm/__init__.py": "", "arm/arm/a.py": node("import talk\nprint(talk)"), "talk/talk/__init__.py": ""}
    (found,) = lint({**files, **code}, code="PKG003")
    assert found.severity is Severity.WARNING


# --------------------------------------------------------------------------------------- what C++ code includes

TALKER_CPP = "#include <rclcpp/rclcpp.hpp>\n#include <tf2_ros/buffer.h>\nint main() {}\n"
BUILD = """project(robot)
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
install(TARGETS talker DESTINATION lib/robot)
"""


def of_cpp(*tags: str, **files: str) -> dict[str, str]:
    """A package of C++ that declares rclcpp and ``tags``."""
    xml = manifest("robot", *depends("rclcpp", tag="depend"), *tags).replace("ament_python", "ament_cmake")
    return {"package.xml": xml, "CMakeLists.txt": BUILD, "src/talker.cpp": TALKER_CPP} | files


def test_a_header_of_a_package_that_is_not_declared(lint):
    (found,) = lint(of_cpp())
    assert found.message == "package 'robot' includes headers of 'tf2_ros', which its package.xml does not declare"
    assert (found.place.file, found.place.line) == ("src/talker.cpp", 2)
    assert found.help == "add <depend>tf2_ros</depend> to package.xml"


def test_a_header_that_a_source_reaches(lint):
    header = "#ifndef ROBOT_BUFFER\n#define ROBOT_BUFFER\n#include <tf2_ros/buffer.h>\n#endif\n"
    files = {"src/talker.cpp": '#include "robot/buffer.hpp"\nint main() {}\n', "include/robot/buffer.hpp": header}
    (found,) = lint(of_cpp(**files))
    assert (found.place.file, found.place.line) == ("include/robot/buffer.hpp", 3)


@pytest.mark.parametrize(
    "source",
    [
        "#ifdef WITH_TF\n#include <tf2_ros/buffer.h>\n#endif\n",
        "#if __has_include(<tf2_ros/buffer.h>)\n#include <tf2_ros/buffer.h>\n#endif\n",
        "// #include <tf2_ros/buffer.h>\n/*\n#include <tf2_ros/buffer.h>\n*/\n",
        "#include <rcl_interfaces/msg/parameter.hpp>\n",
        "#include <moveit/move_group_interface/move_group_interface.h>\n#include <gtsam/geometry/Pose3.h>\n",
        '#include "buffer.h"\n#include <vector>\n',
    ],
)
def test_headers_that_need_no_declaration(lint, source):
    assert lint(of_cpp(**{"src/talker.cpp": source})) == []


def test_what_is_declared_is_not_built_or_may_be_brought(lint):
    assert lint(of_cpp("<depend>tf2_ros</depend>")) == []
    assert lint(of_cpp("<depend>my_tools</depend>")) == []
    assert lint(of_cpp(**{"CMakeLists.txt": BUILD.replace("src/talker.cpp", "src/other.cpp")})) == []
    assert lint(of_cpp(**{"include/tf2_ros/buffer.h": "// a copy\n"})) == []


def test_a_trial_is_built_like_anything_else(lint):
    """As taste goes, it is left alone; whether it can be built is no matter of taste."""
    files = {f"robot_testing/{name}": text for name, text in of_cpp().items()}
    (found,) = lint(files)
    assert found.place.file == "robot_testing/src/talker.cpp"


def test_what_a_package_needs_to_run_is_built_before_it_too(lint):
    """tf2_geometry_msgs needs tf2_ros: rosdep installs both."""
    for tag in ("exec_depend", "build_depend", "depend"):
        assert lint(of_cpp(f"<{tag}>tf2_geometry_msgs</{tag}>")) == []
        assert lint(of_cpp(f"<{tag}>tf2_ros</{tag}>")) == []
    assert len(lint(of_cpp("<test_depend>tf2_geometry_msgs</test_depend>"))) == 1


# ---------------------------------------------------------------------------------------- files of other packages

CONFIG = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = get_package_share_directory('turtlebot3_description') + '/config/talker.yaml'
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[config])])
"""


def test_a_file_of_a_package_that_is_not_declared(lint):
    files = {"package.xml": manifest("robot"), "launch/it.launch.py": CONFIG}
    (found,) = lint(files)
    assert found.message == (
        "package 'robot' takes files of 'turtlebot3_description', which its package.xml does not declare"
    )
    declared = {"package.xml": manifest("robot", *depends("turtlebot3_description"))}
    assert lint(files | declared) == []


OPTIONAL = """
from ament_index_python.packages import PackageNotFoundError, get_package_prefix, get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node


def share_of(package):
    try:
        return get_package_share_directory(package)
    except PackageNotFoundError:
        return None


def generate_launch_description():
    actions = []
    {}
    return LaunchDescription(actions)
"""
INCLUDE = "actions.append(IncludeLaunchDescription(PythonLaunchDescriptionSource(share + '/launch/rviz2.launch.py')))"
TRIED = "    try:\n        share = get_package_share_directory('turtlebot3_bringup')\n    except {}:\n        {}\n"


@pytest.mark.parametrize(
    ("code", "told"),
    [
        (f"{TRIED.format('PackageNotFoundError', 'share = None')}    if share is not None:\n        {INCLUDE}", 0),
        (f"{TRIED.format('Exception as error', 'share = str(error)')}    {INCLUDE}", 0),
        (f"{TRIED.format('Exception', 'raise RuntimeError()')}    {INCLUDE}", 1),
        (f"{TRIED.format('Exception', 'return LaunchDescription([])')}    {INCLUDE}", 1),
        (f"{TRIED.format('Exception', 'return LaunchDescription([LogInfo(msg=str(1))])')}    {INCLUDE}", 0),
        (f"{TRIED.format('Exception', 'return LaunchDescription(actions)')}    {INCLUDE}", 1),
        (f"{TRIED.format('OSError', 'share = None')}    {INCLUDE}", 1),
        (f"    share = share_of('turtlebot3_bringup')\n    if share:\n        {INCLUDE}", 0),
        (f"    share = get_package_share_directory('turtlebot3_bringup')\n    {INCLUDE}", 1),
        (
            "    try:\n        get_package_prefix('turtlebot3_bringup')\n"
            "        actions.append(Node(package='turtlebot3_bringup', executable='any'))\n"
            "    except PackageNotFoundError:\n        actions.append(LogInfo(msg='no robot'))\n",
            0,
        ),
    ],
)
def test_a_package_that_a_launch_file_can_do_without(lint, code: str, told: int):
    files = {"package.xml": manifest("robot"), "launch/it.launch.py": OPTIONAL.format(code.strip())}
    assert len(lint(files)) == told


def test_the_name_under_which_setup_py_indexes_a_package_is_the_package_itself(lint):
    launch = '<launch><node pkg="turtlesim" exec="drive"/></launch>'
    setup = "from setuptools import setup\nsetup(name='turtlesim', data_files=[('share/{}', ['resource/turtlesim'])])\n"
    files = {"package.xml": manifest("robot"), "resource/turtlesim": "", "launch/it.launch.xml": launch}
    assert lint({**files, "setup.py": setup.format("ament_index/resource_index/packages")}) == []
    [told] = lint({**files, "setup.py": setup.format("turtlesim")})
    assert "'turtlesim'" in told.message


def test_a_path_that_another_file_passes_on_is_told_in_that_file(lint):
    """The one that only includes what its argument names needs nothing for it."""
    includes = '<launch><arg name="part"/><include file="$(var part)"/></launch>'
    passes = (
        '<launch>\n<include file="$(find-pkg-share base)/launch/any.launch.xml">\n'
        '<arg name="part" value="$(find-pkg-share turtlebot3_bringup)/launch/rviz2.launch.py"/>\n</include>\n</launch>'
    )
    files = {
        "base/package.xml": manifest("base"),
        "base/CMakeLists.txt": "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})",
        "base/launch/any.launch.xml": includes,
        "robot/package.xml": manifest("robot", *depends("base")),
        "robot/launch/it.launch.xml": passes,
    }
    assert [(one.place.file, missing([one])) for one in lint(files)] == [
        ("robot/launch/it.launch.xml", ["turtlebot3_bringup"])
    ]


STARTS_WITH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = LaunchConfiguration('config', default='')
    own = get_package_share_directory('turtlebot3_bringup') + '/param/waffle.yaml'
    return LaunchDescription([Node(package='base', executable='drive', parameters=[{{'config': {value}}}])])
"""


@pytest.mark.parametrize(("value", "files_told"), [("config", ["robot"]), ("own", ["base"])])
def test_a_parameter_that_is_an_argument_needs_what_the_including_file_names(lint, value, files_told):
    """A file that hands its own argument on names no package, whichever kind of value the argument is for."""
    passes = (
        '<launch>\n<include file="$(find-pkg-share base)/launch/drive.launch.py">\n'
        '<arg name="config" value="$(find-pkg-share turtlebot3_bringup)/param/burger.yaml"/>\n</include>\n</launch>'
    )
    files = {
        "base/package.xml": manifest("base", *depends("launch_ros")),
        "base/CMakeLists.txt": "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})",
        "base/launch/drive.launch.py": STARTS_WITH.format(value=value),
        "robot/package.xml": manifest("robot", *depends("base")),
        "robot/CMakeLists.txt": "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})",
        "robot/launch/robot.launch.xml": passes,
    }
    assert [(found.place.file.split("/")[0], missing([found])) for found in lint(files)] == [
        (package, ["turtlebot3_bringup"]) for package in files_told
    ]


INCLUDING = """\
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

def include(description, package, name):
    path = PathJoinSubstitution([FindPackageShare(package), 'launch', f'{name}.launch.py'])
    description.add_action(IncludeLaunchDescription(path))
"""
INCLUDES = """\
from launch import LaunchDescription
from helper.include import include

def generate_launch_description():
    description = LaunchDescription()
    include(description, 'slam', 'part')
    include(description, 'nav2_bringup', 'navigation_launch')
    return description
"""


def test_the_package_of_an_include_is_named_by_who_calls_the_helper(lint: Lint):
    """What includes the files of packages that it is given depends on none of them: there is no circle."""
    files = {
        "helper/package.xml": manifest("helper", *depends("launch_ros")),
        "helper/setup.py": "from setuptools import setup\nsetup(name='helper', packages=['helper'])\n",
        "helper/helper/__init__.py": "",
        "helper/helper/include.py": INCLUDING,
        "slam/package.xml": manifest("slam"),
        "slam/launch/slam.launch.py": INCLUDES,
        "slam/launch/part.launch.py": PART,
    }
    assert lint(files, code="PKG003") == []
    (diagnostic,) = lint(files)
    assert missing([diagnostic]) == ["helper", "nav2_bringup"]
    assert (diagnostic.place.file, diagnostic.place.line) == ("slam/launch/slam.launch.py", 2)
    assert [related.place.line for related in diagnostic.related if "nav2_bringup" in related.message] == [7]
    # A helper that names the package itself depends on it.
    fixed = INCLUDING.replace("description, package,", "description, package='slam',").replace("name)", "name='part')")
    (diagnostic,) = lint({**files, "helper/helper/include.py": fixed}, code="PKG003")
    assert "helper → slam → helper" in diagnostic.message


PART = "from launch import LaunchDescription\n\ndef generate_launch_description():\n    return LaunchDescription()\n"


@pytest.mark.parametrize(
    ("submodule", "said"),
    [
        ("secret_ros", "which its package.xml does not declare"),  # not checked out: it may be in there
        ("ros-secret-driver", "which its package.xml does not declare"),  # it has the name of the package in its own
        ("ros_secret", "which its package.xml does not declare"),  # it has the word with which that begins
        ("ros-hidden-driver", "neither in this workspace nor in rosdistro"),
        ("hidden_ros", "neither in this workspace nor in rosdistro"),
        ("talk", "neither in this workspace nor in rosdistro"),  # checked out, and it is not there
    ],
)
def test_a_package_that_a_submodule_may_bring(lint: Lint, submodule: str, said: str):
    modules = f'[submodule "{submodule}"]\n\tpath = {submodule}\n\turl = https://example.org/x.git\n'
    (found,) = lint(launching(started("secret_driver")) | {".gitmodules": modules})
    assert said in found.message
    assert found.message.startswith("package 'talk' starts a node of 'secret_driver', which ")


@pytest.mark.parametrize(
    ("declared", "said"),
    [
        ("fast_local_planner", "which its package.xml does not declare"),  # of which nothing is known
        ("fast_global_planner", "neither in this workspace nor in rosdistro"),
    ],
)
def test_a_package_with_the_initials_of_an_unknown_one(lint: Lint, declared: str, said: str):
    files = launching(started("flp_ros"))
    files["talk/package.xml"] = manifest("talk", *depends("rclpy", "launch_ros", declared))
    (found,) = lint(files)
    assert said in found.message


@pytest.mark.parametrize(
    ("path", "text", "said"),
    [
        ("fetch.sh", "git clone -b humble https://example.org/acme/secret-ros2-driver.git src/x\n", "does not declare"),
        ("fetch.sh", "git clone git@example.org:acme/secret_things\n", "does not declare"),
        ("fetch.sh", "git clone https://example.org/acme/hidden-ros2-driver.git\n", "neither in this workspace"),
        ("fetch.sh", "git clone https://example.org/acme/talk_secret_driver.git talk\n", "does not declare"),
        (".gitignore", "build/\n/src/secret_driver/\n", "does not declare"),
        (".gitignore", "build/\nsrc/*/config\n", "neither in this workspace"),
        ("secret", "", "does not declare"),  # the place of a repository, of which it may have the name of the maker
        ("README.md", "", "neither in this workspace"),
        ("COLCON_DEFAULTS", "", "neither in this workspace"),
        ("sensor_msgs", "", "neither in this workspace"),
    ],
)
def test_a_package_of_a_repository_that_is_not_there(lint: Lint, path: str, text: str, said: str):
    (told,) = lint(launching(started("secret_driver")) | {path: text})
    assert said in told.message
    assert (said == "does not declare") is (
        told.help == "add <exec_depend>secret_driver</exec_depend> to talk/package.xml"
    )


def test_a_package_that_a_repository_of_which_nothing_is_known_may_bring(lint: Lint):
    """A name that is wrong stops rosdep: there is no advice to add a line for it."""
    files = launching(started("secret_driver"), started("nav2_amcl"), started("slam_toolbox"))
    doubtful, known = lint({**files, "ros2-hidden": ""})
    assert known.message.endswith("uses 2 packages that its package.xml does not declare: nav2_amcl, slam_toolbox")
    assert known.help.startswith("add a line like <exec_depend>nav2_amcl</exec_depend> for each to ")
    assert doubtful.message.endswith("starts a node of 'secret_driver', which its package.xml does not declare")
    assert doubtful.help == "declare it in package.xml if the repository 'ros2-hidden' has it, else correct the name"


def test_the_place_of_a_repository_with_the_beginning_of_a_name(lint: Lint, tmp_path: Path):
    (tmp_path / "secret_x1").mkdir()
    (told,) = lint(launching(started("secret_x1_ros2")))
    assert told.message.endswith("'secret_x1_ros2', which its package.xml does not declare")


def test_a_folder_of_the_package_itself_is_no_place_of_a_repository(lint: Lint):
    """The name that a package had before: to declare it would stop rosdep."""
    files = {path.removeprefix("talk/"): text for path, text in launching(started("secret_driver")).items()}
    assert lint({**files, "secret_driver/__init__.py": ""}) == []


def test_scripts_beside_interfaces(lint: Lint):
    """A CMakeLists.txt that makes interfaces of files and installs nothing else."""
    cmake = "project(talk)\nfind_package(ament_cmake REQUIRED)\nfind_package(rosidl_default_generators REQUIRED)\n"
    cmake += 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/A.msg" DEPENDENCIES geometry_msgs)\nament_package()\n'
    declared = depends("ament_cmake", "rosidl_default_generators", tag="buildtool_depend")
    files = {
        "package.xml": manifest("talk", *declared).replace("ament_python", "ament_cmake"),
        "CMakeLists.txt": cmake,
        "msg/A.msg": "geometry_msgs/Pose pose\n",
        "client.py": node(LASER),
    }
    assert missing(lint(files)) == ["geometry_msgs"]


def test_a_package_whose_folder_is_empty(lint: Lint, tmp_path: Path):
    """That of a submodule which no .gitmodules names: git keeps no empty folder."""
    (tmp_path / "secret_driver").mkdir()
    (found,) = lint(launching(started("secret_driver")))
    assert found.message == "package 'talk' starts a node of 'secret_driver', which its package.xml does not declare"


def test_a_package_in_whose_place_is_an_empty_file(lint: Lint, tmp_path: Path):
    """What some archives have for a repository in another one."""
    (found,) = lint({**launching(started("secret_driver")), "secret_driver": ""})
    assert found.message == "package 'talk' starts a node of 'secret_driver', which its package.xml does not declare"
    (found,) = lint({**launching(started("secret_driver")), "secret_driver": "A note."})
    assert "neither in this workspace" in found.message


@pytest.mark.parametrize(("parameters", "told"), [("my_package", 0), ("talk", 1)])
def test_a_launch_file_of_a_template_in_which_no_name_was_put_yet(lint: Lint, parameters: str, told: int):
    config = f"name='driver', parameters=[{{'owner': '{parameters}'}}]"
    action = f"Node(package='secret_driver', executable='run_it', {config})"
    assert len(lint(launching(action))) == told


@pytest.mark.parametrize(("entry", "told"), [("main", 0), ("wander", 1)])
def test_a_copied_program_that_no_entry_point_starts(lint: Lint, entry: str, told: int):
    wander = (
        "from secret_msgs.action import Wander\n" + node() + "print(Wander)\nif __name__ == '__main__':\n    main()\n"
    )
    entries = f"entry_points={{'console_scripts': ['talk = talk.{entry}:main']}}"
    files = {
        "talk/package.xml": manifest("talk", *depends("rclpy")),
        "talk/setup.py": f"from setuptools import setup\nsetup(name='talk', packages=['talk'], {entries})\n",
        "talk/talk/__init__.py": "",
        "talk/talk/main.py": node(),
        "talk/talk/wander.py": wander,
    }
    assert len(lint(files)) == told


START = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='camera', executable='{}')])
"""


@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("talk", 0),  # LCH001 says that it is the package's own program: 'camera' is the wrong name
        ("look", 1),
        ("stare", 1),  # nobody installs it: LCH001 cannot say which package is meant
    ],
)
def test_a_package_of_which_a_launch_file_wants_what_another_one_installs(lint: Lint, program: str, told: int):
    files = {f"{name}/package.xml": manifest(name, *depends("rclpy")) for name in ("robot", "camera")}
    for name, entry in (("robot", "talk"), ("camera", "look")):
        entries = f"entry_points={{'console_scripts': ['{entry} = {name}.it:main']}}"
        setup = f"setup(name='{name}', packages=['{name}'], {entries})"
        files |= {f"{name}/setup.py": f"from setuptools import setup\n\n{setup}\n", f"{name}/{name}/__init__.py": ""}
        files[f"{name}/{name}/it.py"] = f"import rclpy\n\n\ndef main():\n    rclpy.create_node('{entry}')\n"
    assert len(lint(files | {"robot/launch/it.launch.py": START.format(program)})) == told
