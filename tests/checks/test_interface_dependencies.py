"""PKG007: what interface files use and CMake is not given; PKG001: what package.xml does not declare of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import write_files

GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>"
FIELDS = "std_msgs/Header header\ngeometry_msgs/Pose[] path\n"


def package(*depends: str, group: str = GROUP) -> str:
    rows = "".join(f"<depend>{name}</depend>" for name in depends)
    return f"""<package format="3"><name>robot_msgs</name>
<buildtool_depend>rosidl_default_generators</buildtool_depend>{rows}{group}
<export><build_type>ament_cmake</build_type></export></package>
"""


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[Finding]]:
    """What one rule finds in a package of interfaces and nothing else."""
    monkeypatch.chdir(tmp_path)

    def run(code: str, cmake: str, manifest: str, text: str = FIELDS, **more: str) -> list[Finding]:
        files = {"CMakeLists.txt": cmake, "package.xml": manifest, "msg/Goal.msg": text, **more}
        write_files(tmp_path, {**files, "archlint.toml": f'select = ["{code}"]'})
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def generate(*words: str) -> str:
    return f"project(robot_msgs)\nrosidl_generate_interfaces(${{PROJECT_NAME}} {' '.join(words)})\n"


def test_a_package_that_the_command_is_not_given(found):
    cmake = generate("msg/Goal.msg", "DEPENDENCIES std_msgs")
    (finding,) = found("PKG007", cmake, package("std_msgs"))
    assert finding.message == (
        "the interfaces of 'robot_msgs' use geometry_msgs/msg/Pose, and rosidl_generate_interfaces is not given "
        "'geometry_msgs': the build fails"
    )
    assert finding.help == (
        "add geometry_msgs to DEPENDENCIES, and find_package(geometry_msgs REQUIRED) before it; declare "
        "<depend>geometry_msgs</depend> in package.xml, too"
    )
    assert (finding.place.file, finding.place.line) == ("CMakeLists.txt", 2)
    assert [(row.place.file, row.place.line) for row in finding.related] == [("msg/Goal.msg", 2)]
    assert found("PKG001", cmake, package("std_msgs")) == []  # said once


def test_no_dependencies_at_all(found):
    (finding,) = found("PKG007", generate("msg/Goal.msg"), package("std_msgs", "geometry_msgs"))
    assert finding.message.endswith("is not given 'geometry_msgs': the build fails; nor is it given 'std_msgs'")
    assert finding.help.endswith("; so with 'std_msgs'")
    assert [row.message for row in finding.related][-1] == "'std_msgs' is missing, too"


def test_a_package_that_the_manifest_does_not_declare(found):
    cmake = generate("msg/Goal.msg", "DEPENDENCIES std_msgs geometry_msgs")
    assert found("PKG007", cmake, package("std_msgs")) == []
    (finding,) = found("PKG001", cmake, package("std_msgs"))
    assert finding.message == (
        "package 'robot_msgs' uses types of 'geometry_msgs', which its package.xml does not declare"
    )
    assert (finding.place.file, finding.place.line) == ("msg/Goal.msg", 2)


def test_a_package_that_does_not_say_that_it_has_interfaces(found):
    cmake = generate("msg/Goal.msg", "DEPENDENCIES std_msgs geometry_msgs")
    (finding,) = found("PKG007", cmake, package("std_msgs", "geometry_msgs", group=""))
    assert finding.message == (
        "package 'robot_msgs' generates interfaces, and its package.xml does not say so: the build stops here"
    )
    assert finding.help == f"add {GROUP} to package.xml"


@pytest.mark.parametrize(
    ("cmake", "text"),
    [
        (generate("msg/Goal.msg", "DEPENDENCIES std_msgs geometry_msgs"), FIELDS),
        (generate("msg/Goal.msg", "DEPENDENCIES nav_msgs"), FIELDS),  # which brings both
        (generate("msg/Goal.msg", "DEPENDENCIES std_msgs our_own_msgs"), FIELDS),  # which may bring anything
        (generate("msg/Goal.msg", "DEPENDENCIES ${needed}"), FIELDS),
        ("set(needed geometry_msgs std_msgs)\n" + generate("msg/Goal.msg", "DEPENDENCIES ${needed}"), FIELDS),
        (generate("msg/Other.msg", "DEPENDENCIES std_msgs"), FIELDS),  # is not generated
        (f"if(WITH_GOALS)\n{generate('msg/Goal.msg')}endif()\n", FIELDS),
        (generate("msg/Goal.msg"), "builtin_interfaces/Time stamp\nGoal[] more\nrobot_msgs/Goal first\nfloat64 x\n"),
    ],
)
def test_what_is_given_or_not_known(found, cmake, text):
    manifest = package("std_msgs", "geometry_msgs", "nav_msgs", "builtin_interfaces")
    assert found("PKG007", cmake, manifest, text) == []
    assert found("PKG001", cmake, manifest, text) == []


# --------------------------------------------------------------------------------------------- types that are not there


@pytest.mark.parametrize(
    ("field", "type", "meant", "help"),
    [
        ("Header header", "Header", "std_msgs/Header", "write std_msgs/Header"),
        ("Int16 timeout", "Int16", "int16", "write int16"),
        ("Int16[] timeouts", "Int16", "int16", "write int16"),
        ("robot_msgs/Wheel wheel", "Wheel", "", "add Wheel.msg to robot_msgs, or correct the type"),
    ],
)
def test_a_type_that_the_package_does_not_define(found, field: str, type: str, meant: str, help: str):
    (finding,) = found("PKG007", generate("msg/Goal.msg"), package(), f"float64 x\n{field}\n")
    hint = f"; did you mean '{meant}'?" if meant else ""
    assert finding.message == f"robot_msgs defines no message '{type}': the build of 'robot_msgs' fails{hint}"
    assert finding.help == help
    assert (finding.place.file, finding.place.line) == ("msg/Goal.msg", 2)


def test_a_type_that_another_package_does_not_define(found):
    cmake = generate("msg/Goal.msg", "DEPENDENCIES std_msgs")
    (finding,) = found("PKG007", cmake, package("std_msgs"), "std_msgs/Velocity speed\n")
    assert finding.message == "std_msgs defines no message 'Velocity': the build of 'robot_msgs' fails"


def test_all_fields_of_such_a_type_are_one_finding(found):
    (finding,) = found("PKG007", generate("msg/Goal.msg"), package(), "Int16 first\nfloat64 x\nInt16 second\n")
    assert [(row.place.file, row.place.line) for row in finding.related] == [("msg/Goal.msg", 3)]


@pytest.mark.parametrize(
    ("words", "text", "more"),
    [
        (["msg/Goal.msg", "msg/Wheel.msg"], "Wheel wheel\n", {"msg/Wheel.msg": "float64 speed\n"}),
        (["msg/Goal.msg", "msg/Wheel.idl"], "Wheel wheel\n", {}),
        (["msg/Goal.msg", "${made}"], "Wheel wheel\n", {}),
        (["msg/Goal.msg"], "somewhere/Wheel wheel\n", {}),
        (["msg/Goal.msg"], "time stamp\nstring<=5 word\n", {}),
    ],
)
def test_types_that_are_there_or_may_be(found, words: list[str], text: str, more: dict[str, str]):
    told = found("PKG007", generate(*words), package(), text, **more)
    assert not any("defines no message" in finding.message for finding in told)


# ------------------------------------------------------------------------------- PKG004: what the command is not given

LISTS = """project(robot_msgs)
set(messages "msg/Goal.msg")
set(actions "action/Move.action" "action/Turn.action")
rosidl_generate_interfaces(${{PROJECT_NAME}} ${{messages}} {more})
"""
ACTIONS = {"action/Move.action": "---\n---\n", "action/Turn.action": "---\n---\n"}


def test_a_list_of_actions_that_the_command_is_not_given(found):
    (finding,) = found("PKG004", LISTS.format(more=""), package(), "float64 x\n", **ACTIONS)
    assert finding.message == (
        "rosidl_generate_interfaces() is not given 2 files that are named here: action/Move.action, "
        "action/Turn.action: nobody can import them"
    )
    assert (finding.place.file, finding.place.line) == ("CMakeLists.txt", 4)


def test_a_list_that_the_command_is_given(found):
    assert found("PKG004", LISTS.format(more="${actions}"), package(), "float64 x\n", **ACTIONS) == []


def test_an_interface_that_no_list_names_is_left_out_on_purpose(found):
    cmake = "project(robot_msgs)\n# not yet: action/Move.action\nrosidl_generate_interfaces(robot_msgs msg/Goal.msg)\n"
    assert found("PKG004", cmake, package(), "float64 x\n", **ACTIONS) == []


def test_a_slip_in_the_name_of_a_package_is_told_where_it_is_written(found):
    cmake = generate("msg/Goal.msg", "DEPENDENCIES std_msgs geometry_msgs")
    manifest = package("std_msgs", "geometry_msgs")
    (finding,) = found("PKG007", cmake, manifest, FIELDS.replace("geometry_msgs", "geometry_msg"))
    assert finding.message == (
        "the interfaces of 'robot_msgs' use geometry_msg/msg/Pose, and there is no package 'geometry_msg': the build "
        "fails; did you mean 'geometry_msgs'?"
    )
    assert (finding.place.file, finding.place.line, finding.help) == ("msg/Goal.msg", 2, "write geometry_msgs/msg/Pose")
    (other,) = found("PKG007", cmake, manifest, FIELDS.replace("geometry_msgs", "secret_arm_msgs"))
    assert other.place.file == "CMakeLists.txt"
