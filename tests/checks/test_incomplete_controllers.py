"""PRM012: controllers without the parameters that their class needs."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding

TYPES = "controller_manager:\n  ros__parameters:\n    arm:\n      type: {}\n"
SECTION = "{}:\n  ros__parameters:\n    update_rate: 50\n{}"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
Findings = Callable[..., list[Finding]]


def _file(kind: str, *lines: str, node: str = "arm") -> str:
    return TYPES.format(kind) + SECTION.format(node, "".join(f"    {line}\n" for line in lines))


@pytest.mark.parametrize(
    ("kind", "lines", "lacking"),
    [
        (TRAJECTORY, ["joints: [elbow]"], "command_interfaces and no state_interfaces"),
        (TRAJECTORY, ["joints: [elbow]", "command_interfaces: [position]"], "state_interfaces"),
        ("diff_drive_controller/DiffDriveController", ["left_wheel_names: [left]"], "right_wheel_names"),
        ("forward_command_controller/ForwardCommandController", ["joints: [elbow]"], "interface_name"),
        ("position_controllers/GripperActionController", ["joints: [finger]"], "joint"),
    ],
)
def test_what_a_controller_lacks(findings: Findings, kind: str, lines: list[str], lacking: str):
    (told,) = findings("PRM012", **{"config/p.yaml": _file(kind, *lines)})
    name = kind.rpartition("/")[2]
    assert told.message == f"'arm' is given no {lacking}, without which {name} cannot be configured"
    assert told.place.line == 5


@pytest.mark.parametrize(
    "text",
    [
        _file(TRAJECTORY, "command_interfaces: [position]", "state_interfaces: [position]"),
        _file("velocity_controllers/JointGroupVelocityController", "joints: [elbow]"),
        _file("arm_controllers/Arm"),
        _file(TRAJECTORY, node="leg"),
        TYPES.format(TRAJECTORY),
        _file(TRAJECTORY)
        + "/**:\n  ros__parameters:\n    command_interfaces: [position]\n    state_interfaces: [position]\n",
    ],
)
def test_a_controller_that_lacks_nothing_or_of_which_little_is_known(findings: Findings, text: str):
    assert findings("PRM012", **{"config/p.yaml": text}) == []


def test_a_controller_with_parameters_in_two_files(findings: Findings):
    rest = SECTION.format("arm", "    command_interfaces: [position]\n    state_interfaces: [position]\n")
    assert findings("PRM012", **{"config/p.yaml": _file(TRAJECTORY, "joints: [a]"), "config/more.yaml": rest}) == []


MOVEIT = """\
moveit_simple_controller_manager:
  controller_names: [arm, leg, absent]
  arm:
    {}
  leg: {{type: GripperCommand, action_ns: gripper_cmd, joints: [knee]}}
  unlisted: {{type: FollowJointTrajectory}}
"""


@pytest.mark.parametrize(
    ("line", "lacking"),
    [
        ("{type: FollowJointTrajectory, joints: [elbow]}", ["action_ns"]),
        ("{joints: [elbow]}", ["action_ns", "type"]),
        ("{type: FollowJointTrajectory, joints: [elbow], action_ns: follow_joint_trajectory}", []),
        ("$(var arm)", []),
    ],
)
def test_a_controller_that_moveit_passes_over(findings: Findings, line: str, lacking: list[str]):
    found = findings("PRM012", **{"config/moveit_controllers.yaml": MOVEIT.format(line)})
    assert [(row.message, row.place.line) for row in found] == (
        [(f"'arm' is given no {' and no '.join(lacking)}, without which MoveIt passes over it", 3)] if lacking else []
    )
