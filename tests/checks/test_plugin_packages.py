"""PKG001: packages of the plugins that parameter files and descriptions of robots name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from robot_package import SETUP, manifest, node, write_files, write_robot

CONTROLLERS = """\
controller_manager:
  ros__parameters:
    wheels:
      type: diff_drive_controller/DiffDriveController
    own:
      type: own_controllers/Own
wheels:
  ros__parameters:
    left_wheel_names: [left]
"""
DESCRIPTION = """\
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <ros2_control name="wheels" type="system">
    <hardware>
      {}
    </hardware>
  </ros2_control>
</robot>
"""
LOADS = '<param from="$(find-pkg-share robot)/config/{}"/>'
LAUNCH = node(LOADS.format("controllers.yaml") + LOADS.format("robot.xacro"))
Findings = Callable[..., list[Finding]]


def _told(findings: Findings, *declared: str, **files: str) -> list[tuple[str, int]]:
    more = "".join(f"<exec_depend>{name}</exec_depend>" for name in declared)
    found = findings("PKG001", LAUNCH, **{"package.xml": manifest(more=more), **files})
    return [(name, finding.place.line) for finding in found for name in finding.identity[1:]]


@pytest.mark.parametrize(
    ("declared", "told"),
    [
        ((), [("diff_drive_controller", 4)]),
        (("diff_drive_controller",), []),
        (("ros2_controllers",), []),
        (("rviz2</exec_depend><!-- <exec_depend>diff_drive_controller</exec_depend> --><exec_depend>xacro",), []),
    ],
)
def test_the_type_of_a_controller(findings: Findings, declared: tuple[str, ...], told: list[tuple[str, int]]):
    assert _told(findings, *declared, **{"config/controllers.yaml": CONTROLLERS}) == told


@pytest.mark.parametrize(("needed", "count"), [("diff_drive_controller", 0), ("rviz2", 1)])
def test_another_package_of_the_workspace_that_declares_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, needed: str, count: int
):
    monkeypatch.chdir(tmp_path)
    write_robot(tmp_path / "robot", LAUNCH, **{"config/controllers.yaml": CONTROLLERS})
    other = manifest("starts_robot", more=f"<exec_depend>{needed}</exec_depend>")
    write_files(tmp_path, {"starts/package.xml": other, "archlint.toml": 'select = ["PKG001"]'})
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == count


@pytest.mark.parametrize(
    ("kind", "package"),
    [
        ("position_controllers/JointGroupPositionController", "position_controllers"),
        ("position_controllers/GripperActionController", "gripper_controllers"),
        ("velocity_controllers/JointVelocityController", ""),  # of ROS 1
        ("parallel_gripper_action_controller/GripperActionController", "parallel_gripper_controller"),
        ("someones_controllers/Legs", ""),
    ],
)
def test_the_package_of_a_class(findings: Findings, kind: str, package: str):
    controllers = CONTROLLERS.replace("diff_drive_controller/DiffDriveController", kind)
    told = [(package, 4)] if package else []
    assert _told(findings, **{"config/controllers.yaml": controllers}) == told


def test_a_file_that_nothing_names_or_installs(findings: Findings):
    assert _told(findings, **{"config/others.yaml": CONTROLLERS}) == []
    setup = SETUP.replace("config/*", "conf/*")
    assert _told(findings, **{"config/controllers.yaml": CONTROLLERS, "setup.py": setup}) == []


@pytest.mark.parametrize(
    ("hardware", "told"),
    [
        ("<plugin>gz_ros2_control/GazeboSimSystem</plugin>", [("gz_ros2_control", 4)]),
        ("<plugin>mock_components/GenericSystem</plugin>", [("hardware_interface", 4)]),
        ('<plugin filename="libgazebo_ros2_control.so" name="control"/>', [("gazebo_ros2_control", 4)]),
        ("<plugin>robot/Wheels</plugin>", []),
        ("<plugin>someones_driver/Wheels</plugin>", []),
        ("<!-- <plugin>gz_ros2_control/GazeboSimSystem</plugin> -->", []),
        ('<xacro:if value="$(arg sim)"><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>', []),
        ('<plugin filename="gz-sim-imu-system" name="imu"/>', []),
    ],
)
def test_the_plugin_of_a_description(findings: Findings, hardware: str, told: list[tuple[str, int]]):
    assert _told(findings, **{"config/robot.xacro": DESCRIPTION.format(hardware)}) == told


MACRO = '<xacro:macro name="simulated" params="ns"><plugin filename="libgazebo_ros2_control.so"/></xacro:macro>'


@pytest.mark.parametrize(
    ("call", "told"),
    [
        ("", []),
        ("<xacro:simulated_wheels/>", []),
        ('<!-- <xacro:simulated ns=""/> -->', []),
        ('<xacro:simulated ns=""/>', [("gazebo_ros2_control", 4)]),
        ('<xacro:call macro="${name}" ns=""/>', [("gazebo_ros2_control", 4)]),
    ],
)
def test_the_plugin_of_a_macro(findings: Findings, call: str, told: list[tuple[str, int]]):
    """What a macro holds is in the description where some file calls it."""
    other = f'<robot name="other" xmlns:xacro="http://www.ros.org/wiki/xacro">{call}</robot>'
    files = {"config/robot.xacro": DESCRIPTION.format(MACRO), "config/other.xacro": other}
    assert _told(findings, **files) == told
