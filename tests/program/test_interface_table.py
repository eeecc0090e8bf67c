"""Standard interfaces and those of the workspace, and which of them a name means."""

from __future__ import annotations

import pytest

from archlint.program.interface_table import InterfaceTable
from archlint.workspace.model import SourceFile


def table(**files: str) -> InterfaceTable:
    """Interface files of the package ``robot_interfaces``; ``Battery_msg`` is ``msg/Battery.msg``."""
    texts = {f"msg/{name.replace('_', '.')}": text for name, text in files.items()}
    found = [
        SourceFile(path=f"/w/{path}", relative=path, kind="interface", package="robot_interfaces", module=None)
        for path in texts
    ]
    return InterfaceTable(found, lambda file: texts[file.relative])


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
