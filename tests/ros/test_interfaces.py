"""Standard interfaces and those of the workspace, and which of them a name means."""

from __future__ import annotations

import pytest

from archlint.programs.installs import read_cmake
from archlint.ros.interfaces import InterfaceTable
from archlint.workspace.installed import Installs
from archlint.workspace.model import SourceFile
from builds import Build


def table(cmake: str = "", **files: str) -> InterfaceTable:
    """Interface files of the package ``robot_interfaces``; ``Battery_msg`` is ``msg/Battery.msg``.  ``cmake`` are
    the words of its CMakeLists.txt."""
    texts = {f"msg/{name.replace('_', '.')}": text for name, text in files.items()}
    found = [
        SourceFile(path=f"/w/{path}", relative=path, kind="interface", package="robot_interfaces", module=None)
        for path in texts
    ]
    listed = {"robot_interfaces": cmake.split()} if cmake else {}
    return InterfaceTable(found, lambda file: texts[file.relative], listed)


STANDARD = table()


@pytest.mark.parametrize(
    ("package", "kind", "name", "defined"),
    [
        ("std_msgs", "msg", "String", True),
        ("std_msgs", "msg", "Strin", False),
        ("std_srvs", "srv", "Trigger", True),
        ("std_srvs", "msg", "Trigger", False),
        ("nav2_msgs", "action", "NavigateToPose", True),
        ("example_interfaces", "action", "Fibonacci", True),
        ("vendor_msgs", "msg", "Anything", None),
    ],
)
def test_what_a_standard_package_defines(package: str, kind: str, name: str, defined: bool | None):
    assert STANDARD.defines(package, kind, name) is defined


def test_fields_arrays_and_constants_of_a_standard_message():
    section = STANDARD.section("sensor_msgs/msg/BatteryState", "")
    assert section is not None
    cells = section.field("cell_voltage")
    assert cells is not None and (cells.type.name, cells.type.array) == ("float32", "unbounded")
    assert STANDARD.constant("sensor_msgs/msg/BatteryState", "", "POWER_SUPPLY_STATUS_FULL") == 4


def test_a_field_of_a_message_type_is_named_in_full():
    kind = STANDARD.field_type("geometry_msgs/msg/PoseStamped", "", "pose")
    assert kind is not None and kind.name == "geometry_msgs/msg/Pose"
    header = STANDARD.field_type("geometry_msgs/msg/PoseStamped", "", "header")
    assert header is not None and header.name == "std_msgs/msg/Header"


def test_parts_of_services_and_actions():
    assert STANDARD.has("std_srvs/srv/SetBool", "Request", "data") is True
    assert STANDARD.has("std_srvs/srv/SetBool", "Response", "data") is False
    assert STANDARD.has("example_interfaces/action/Fibonacci", "Feedback", "sequence") is True


def test_a_field_that_only_some_distributions_have_is_a_field():
    # Humble's name and the later one.
    for field in ("missed_waypoints", "error_code"):
        assert STANDARD.has("nav2_msgs/action/FollowWaypoints", "Result", field) is True


def test_a_field_whose_type_changed_has_no_known_type():
    assert STANDARD.field_type("nav2_msgs/action/NavigateThroughPoses", "Goal", "poses") is None


def test_a_package_of_the_workspace():
    own = table(Battery_msg="float64 voltage\n")
    assert own.defines("robot_interfaces", "msg", "Battery") is True
    assert own.defines("robot_interfaces", "msg", "Batery") is False
    assert own.of_package("robot_interfaces", "msg") == ["Battery"]
    assert own.has("robot_interfaces/msg/Battery", "", "percent") is False


def test_a_definition_with_mistakes_proves_nothing():
    assert table(Battery_msg="float64 Voltage\n").has("robot_interfaces/msg/Battery", "", "percent") is None


def test_other_definitions_of_a_package_may_be_out_of_sight():
    own = table(Battery_msg="float64 voltage\n", Arm_idl="module robot_interfaces {};")
    assert own.defines("robot_interfaces", "msg", "Battery") is True
    assert own.defines("robot_interfaces", "msg", "Arm") is None


@pytest.mark.parametrize(
    ("words", "defined"),
    [
        ("rosidl_generate_interfaces Battery.msg", False),
        ("rosidl_generate_interfaces Battery.msg Arm.msg", None),  # in another folder, or made by the build
        ("rosidl_generate_interfaces Battery.msg Arm.idl", None),
        ("rosidl_generate_interfaces Battery.msg .idl GLOB", None),  # all that match *.idl
        ("rosidl_generate_interfaces Battery.msg configure_file", None),
        ("install Arm.msg", False),
    ],
)
def test_what_is_generated_but_not_read(words: str, defined: bool | None):
    assert table(words, Battery_msg="float64 voltage\n").defines("robot_interfaces", "msg", "Arm") is defined


@pytest.mark.parametrize(
    ("words", "left_out"),
    [
        ("rosidl_generate_interfaces Battery.msg", True),
        ("rosidl_generate_interfaces Battery.msg Arm.msg", False),
        ("rosidl_generate_interfaces Battery.msg GLOB .msg", False),
        ("rosidl_generate_interfaces Battery.msg foreach", False),
        ("rosidl_generate_interfaces", False),  # what it is given stands somewhere else
        ("", False),
    ],
)
def test_a_file_that_is_not_generated(words: str, left_out: bool):
    own = table(words, Battery_msg="float64 voltage\n", Arm_msg="float64 angle\n")
    assert own.is_left_out("robot_interfaces", "msg", "Arm") is left_out
    assert own.defines("robot_interfaces", "msg", "Arm") is not left_out
    assert own.defines("robot_interfaces", "msg", "Battery") is True


@pytest.mark.parametrize(
    ("cmake", "defined"),
    [
        (
            "include(docs.cmake)\nrosidl_generate_interfaces(${PROJECT_NAME} msg/Battery.msg DEPENDENCIES std_msgs)",
            False,
        ),
        ("set(FILES msg/Battery.msg)\nforeach(x a)\nrosidl_generate_interfaces(robot_interfaces ${FILES})", False),
        ("rosidl_generate_interfaces(robot_interfaces msg/Battery.msg msg/Arm.msg)", None),
        ("include(files.cmake)\nrosidl_generate_interfaces(robot_interfaces ${FILES})", None),
        (
            "include(x)\nrosidl_generate_interfaces(a msg/Battery.msg)\nrosidl_generate_interfaces(b msg/Leg.msg)",
            None,
        ),
    ],
    ids=["all are literal", "by a variable of the file", "one that is not here", "by an unknown variable", "two lists"],
)
def test_what_the_generating_command_names_is_all_there_is(cmake: str, defined: bool | None):
    installs = Installs("robot_interfaces", ".")
    read_cmake(installs, "CMakeLists.txt", Build({"CMakeLists.txt": f"project(robot_interfaces)\n{cmake}"}))
    file = SourceFile("/w/msg/Battery.msg", "msg/Battery.msg", "interface", "robot_interfaces", None)
    generated = {} if installs.generated is None else {"robot_interfaces": installs.generated}

    own = InterfaceTable([file], lambda file: "float64 voltage\n", {"robot_interfaces": installs.words}, generated)

    assert own.defines("robot_interfaces", "msg", "Battery") is True
    assert own.defines("robot_interfaces", "msg", "Arm") is defined


@pytest.mark.parametrize(
    ("words", "kind", "defined"),
    [
        ("srv/Arm.srv", "msg", False),  # the name is listed, but as a service
        ("srv/Arm.srv", "srv", None),
        ("msg/Arm.idl", "srv", False),
        ("msg/Arm.idl", "msg", None),
        ("Arm.idl", "action", None),
    ],
)
def test_a_name_is_listed_with_its_kind(words: str, kind: str, defined: bool | None):
    own = table(f"rosidl_generate_interfaces {words}", Battery_msg="float64 voltage\n")
    assert own.defines("robot_interfaces", kind, "Arm") is defined


def test_a_package_that_generates_no_interfaces_defines_none():
    own = InterfaceTable([], lambda file: None, without=["robot"])
    assert own.defines("robot", "msg", "Battery") is False
    assert own.of_package("robot", "msg") == []
    assert own.defines("vendor", "msg", "Battery") is None


def test_types_of_fields():
    own = table(All_msg="Point[<=5] bounded\nPoint[3] fixed\nstring<=4 name\nwstring wide\nbuiltin_interfaces/Time t\n")
    types = {name: own.field_type("robot_interfaces/msg/All", "", name) for name in ("bounded", "fixed", "wide", "t")}
    assert [(one.name, one.array) for one in types.values() if one is not None] == [
        ("robot_interfaces/msg/Point", "bounded"),
        ("robot_interfaces/msg/Point", "fixed"),
        ("wstring", ""),
        ("builtin_interfaces/msg/Time", ""),
    ]
    assert own.has("robot_interfaces/msg/All", "", "name") is True


def test_which_field_has_a_field_is_not_asked_of_numbers(monkeypatch: pytest.MonkeyPatch):
    """A message of many numbers, of which code misspells each: every slip asks this."""
    asked: list[str] = []
    real = InterfaceTable._interface_in
    monkeypatch.setattr(
        InterfaceTable, "_interface_in", lambda table, *names: asked.append(names[2]) or real(table, *names)
    )
    numbers = "".join(f"int32 speed{number}\n" for number in range(100))
    own = table(Wheel_msg="float64 radius\n", Base_msg=f"{numbers}Wheel left\n")
    assert own.inside("robot_interfaces/msg/Base", "", "radius") == "left"
    assert own.inside("robot_interfaces/msg/Base", "", "width") is None
    assert asked == ["left", "left"]
