"""MSG002 in C++: includes and types of interfaces that a package of the workspace does not define."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.cpp_nodes import NODE

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import manifest, write_files

INTERFACES = """
project(robot_msgs)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/JointState2.msg" "msg/WheelSpeed.msg" "srv/Reset.srv")
"""
BUILD = """
project(robot)
add_executable(robot src/robot.cpp)
install(TARGETS robot DESTINATION lib/${PROJECT_NAME})
"""
SOURCE = NODE.replace('#include "std_msgs/msg/string.hpp"', "%s")


def findings(root: Path, includes: str = "", statements: str = "", build: str = BUILD, **files: str) -> list[Finding]:
    """What MSG002 finds in a workspace of a node and the package of its interfaces."""
    texts = {
        "robot_msgs/package.xml": manifest("robot_msgs", "ament_cmake"),
        "robot_msgs/CMakeLists.txt": INTERFACES,
        "robot_msgs/msg/JointState2.msg": "float64 angle\n",
        "robot_msgs/msg/WheelSpeed.msg": "float64 left\n",
        "robot_msgs/msg/Forgotten.msg": "float64 left\n",
        "robot_msgs/srv/Reset.srv": "---\n",
        "robot/package.xml": manifest(build_type="ament_cmake", more="<depend>robot_msgs</depend>"),
        "robot/CMakeLists.txt": build,
        "robot/src/robot.cpp": SOURCE % (includes, statements),
        "archlint.toml": 'select = ["MSG002"]\n',
    }
    write_files(root, texts | files)
    return check(Request((".",), load(root), cached=False, jobs=1)).findings


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("wheel_speeds", "robot_msgs defines no message 'WheelSpeeds'; did you mean 'WheelSpeed'?"),
        ("reset", "robot_msgs defines no message 'Reset'; there is robot_msgs/srv/Reset"),
        (
            "forgotten",
            "robot_msgs defines no message 'Forgotten': msg/Forgotten.msg is not listed in "
            "rosidl_generate_interfaces() of its CMakeLists.txt",
        ),
    ],
)
def test_an_include_of_an_interface_that_is_not_there(here: Path, name: str, meant: str) -> None:
    [told] = findings(here, f'#include "robot_msgs/msg/{name}.hpp"')
    assert told.message == meant
    assert (told.place.file, told.place.line) == ("robot/src/robot.cpp", 3)


def test_a_type_that_is_not_there_is_told_with_its_include(here: Path) -> None:
    include = '#include "robot_msgs/msg/wheel_speeds.hpp"'
    [told] = findings(here, include, 'create_publisher<robot_msgs::msg::WheelSpeeds>("speeds", 10);')
    assert told.message == "robot_msgs defines no message 'WheelSpeeds'; did you mean 'WheelSpeed'?"
    assert [place.place.line for place in told.related] == [7]


def test_a_type_alone(here: Path) -> None:
    [told] = findings(here, "", 'create_publisher<robot_msgs::msg::Wheels>("speeds", 10);')
    assert told.place.line == 7
    assert told.help == "this does not compile; robot_msgs::msg has JointState2, WheelSpeed"


def test_a_type_of_a_package_of_ros(here: Path) -> None:
    [told] = findings(here, "", 'create_publisher<std_msgs::msg::Float>("speeds", 10);')
    assert (told.place.line, told.message) == (7, "std_msgs defines no message 'Float'")


@pytest.mark.parametrize(
    "include",
    [
        "robot_msgs/msg/wheel_speed.hpp",
        "robot_msgs/msg/joint_state2.hpp",
        "robot_msgs/srv/reset.hpp",
        "robot_msgs/msg/detail/wheel_speeds__struct.hpp",
        "robot_msgs/msg/wheel_speeds__struct.hpp",
        "robot_msgs/msg/helpers.h",
        "other_msgs/msg/wheel_speeds.hpp",
        "sensor_msgs/msg/point_cloud2_iterator.hpp",
    ],
)
def test_includes_that_are_right_or_of_elsewhere(here: Path, include: str) -> None:
    assert findings(here, f'#include "{include}"') == []


@pytest.mark.parametrize(
    "statement",
    [
        'create_publisher<robot_msgs::msg::WheelSpeed>("speeds", 10);',
        "robot_msgs::srv::Reset_Request request;",
        "robot_msgs::msg::WheelSpeed_<std::allocator<void>> speed;",
        "auto text = robot_msgs::msg::to_yaml(speed);",
        'create_publisher<other_msgs::msg::Wheels>("speeds", 10);',
        'create_publisher<std_msgs::msg::Float64>("speeds", 10);',
        "std_msgs::msg::Float64_<std::allocator<void>> speed;",
    ],
)
def test_types_that_are_right_or_of_elsewhere(here: Path, statement: str) -> None:
    assert findings(here, "", statement) == []


def test_what_the_preprocessor_may_leave_out_is_not_judged(here: Path) -> None:
    include = '#ifdef OLD_MESSAGES\n#include "robot_msgs/msg/wheels.hpp"\n#endif'
    statement = '#ifdef OLD_MESSAGES\ncreate_publisher<robot_msgs::msg::Wheels>("speeds", 10);\n#endif'
    assert findings(here, include, statement) == []


def test_a_source_that_nothing_builds_is_not_judged(here: Path) -> None:
    assert findings(here, '#include "robot_msgs/msg/wheels.hpp"', build="project(robot)\n") == []


def test_interfaces_that_the_build_makes_are_not_judged(here: Path) -> None:
    made = INTERFACES.replace("rosidl_gen", "configure_file(msg/A.msg.in msg/A.msg)\nrosidl_gen", 1)
    made = made.replace('"srv/Reset.srv"', '"srv/Reset.srv" ${MADE}')
    assert findings(here, '#include "robot_msgs/msg/a.hpp"', **{"robot_msgs/CMakeLists.txt": made}) == []


def test_interfaces_that_another_package_has_now(here: Path) -> None:
    includes = "\n".join(f'#include "robot_msgs/msg/{name}.hpp"' for name in ("arm_pose", "grip_force"))
    others = {
        "arm_msgs/package.xml": manifest("arm_msgs", "ament_cmake"),
        "arm_msgs/CMakeLists.txt": INTERFACES.replace("robot_msgs", "arm_msgs")
        .replace("JointState2", "ArmPose")
        .replace("WheelSpeed", "GripForce")
        .replace("Reset", "Home"),
        "arm_msgs/msg/ArmPose.msg": "float64 angle\n",
        "arm_msgs/msg/GripForce.msg": "float64 force\n",
        "arm_msgs/srv/Home.srv": "---\n",
        "robot/include/robot/arm.hpp": '#pragma once\n#include "robot_msgs/msg/arm_pose.hpp"\n',
    }
    (told,) = findings(here, f'{includes}\n#include "robot/arm.hpp"', **others)
    assert told.message == "robot_msgs defines no messages 'ArmPose' and 'GripForce'"
    assert told.help == "take them from arm_msgs::msg, which defines them"
    places = [told.place, *(row.place for row in told.related)]
    assert {place.file for place in places} == {"robot/src/robot.cpp", "robot/include/robot/arm.hpp"}
