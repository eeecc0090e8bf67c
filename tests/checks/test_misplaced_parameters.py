"""PRM004: values for controllers of ros2_controllers that stand beside the map which they belong into."""

from __future__ import annotations

import pytest

from robot_package import manifest, node

CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {{type: {kind}}}
arm:
  ros__parameters:
    joints: [elbow]
    {line}
    constraints:
      elbow: {{goal: 0.1}}
"""
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
LOAD_IT = node('<param from="$(find-pkg-share robot)/config/p.yaml"/>')


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("goal_time: 1.0", ["constraints.goal_time"]),
        ("stopped_velocity_tolerance: 0.1", ["constraints.stopped_velocity_tolerance"]),
        ("constraints.goal_time: 1.0", []),
        ("state_publish_rate: 50.0", []),
        # A slip for command_interfaces, and a word that may be of anything.
        ("command_interface: [position]", []),
        ("enable: true", []),
        # Of no controller: nobody knows what was meant.
        ("goal_times: 1.0", []),
    ],
)
def test_a_parameter_that_belongs_into_a_map(findings, line: str, meant: list[str]):
    told = findings("PRM004", LOAD_IT, **{"config/p.yaml": CONTROLLERS.format(kind=TRAJECTORY, line=line)})
    assert [row.meant for row in told] == meant
    assert [(row.place.file, row.place.line) for row in told] == [("config/p.yaml", 7)] * len(meant)
    assert all(row.help == "write it below 'constraints:'" for row in told)


def test_what_is_said_of_it(findings):
    text = CONTROLLERS.format(kind=TRAJECTORY, line="goal_time: 1.0")
    (told,) = findings("PRM004", LOAD_IT, **{"config/p.yaml": text})
    assert told.message == (
        "joint_trajectory_controller::JointTrajectoryController declares no parameter 'goal_time', so this value has "
        "no effect; did you mean 'constraints.goal_time'?"
    )


SECTION = """\
arm:
  ros__parameters:
    goal_time: 1.0
"""


@pytest.mark.parametrize(
    ("kind", "more", "lines"),
    [
        # The type is in another file, the one for the controller manager.
        (TRAJECTORY, {}, [3]),
        ("arm_control/ArmController", {}, []),
        # Which of the two it is, nobody knows.
        (TRAJECTORY, {"config/q.yaml": CONTROLLERS.format(kind="arm_control/ArmController", line="a: 1")}, []),
    ],
)
def test_a_file_without_the_type(findings, kind: str, more: dict[str, str], lines: list[int]):
    files = {"config/p.yaml": CONTROLLERS.format(kind=kind, line="a: 1"), "config/moveit.yaml": SECTION}
    told = findings("PRM004", LOAD_IT, **files, **more)
    assert [row.place.line for row in told if row.place.file == "config/moveit.yaml"] == lines


def test_a_fork_of_the_controller(findings):
    """It may declare more than the released one."""
    files = {"config/p.yaml": CONTROLLERS.format(kind=TRAJECTORY, line="goal_time: 1.0")}
    fork = manifest("joint_trajectory_controller")
    assert findings("PRM004", LOAD_IT, **files, **{"package.xml": fork}) == []
