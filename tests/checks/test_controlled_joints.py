"""PRM012: what parameter files give to controllers of ros2_control in vain."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from robot_package import SETUP, manifest, write_files

ROBOT = """\
<robot name="robot">
  <joint name="elbow_joint" type="fixed"/>
  <joint name="arm_joint_1" type="fixed"/>
  <ros2_control name="robot" type="system">
    <joint name="elbow_joint"><command_interface name="velocity"/><state_interface name="position"/></joint>
    <gpio name="lights"><command_interface name="set_led"/></gpio>
  </ros2_control>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: arm_controllers/Arm}
arm:
  ros__parameters:
"""


def _told(findings, *lines: str, robot: str = ROBOT, head: str = CONTROLLERS):
    text = head + "".join(f"    {line}\n" for line in lines)
    return findings("PRM012", **{"config/p.yaml": text, "urdf/robot.urdf.xacro": robot})


@pytest.mark.parametrize(
    ("lines", "message", "help"),
    [
        (
            ("joints: [elbow]",),
            "no robot description here has 'elbow', which 'arm' is given as one of its joints; did you mean "
            "'elbow_joint'?",
            "write 'elbow_joint'",
        ),
        (
            ("left_wheel_names: ['elbwo_joint']",),
            "no robot description here has 'elbwo_joint', which 'arm' is given as one of its left_wheel_names; did you "
            "mean 'elbow_joint'?",
            "write 'elbow_joint'",
        ),
        (
            ("joints: [elbow_joint]", "command_interfaces: [position]"),
            "'arm' wants the command interface 'elbow_joint/position', and the hardware there has 'velocity'",
            "write 'velocity'",
        ),
        (
            ("gpios: [lights]", "command_interfaces:", "  lights:", "  - interfaces: [set_leds]"),
            "'arm' wants the command interface 'lights/set_leds', and the hardware there has 'set_led'",
            "write 'set_led'",
        ),
        (
            ("joints: [elbow_joint]", "gains:", "  elbow: {p: 1.0}"),
            "'arm' has gains for 'elbow', which is none of its joints",
            "remove them, or name the joint; it has elbow_joint",
        ),
        (
            ("joints: [elbow_joint]", "constraints:", "  elbow_jiont: {goal: 0.1, trajectory: 0.2}"),
            "'arm' has constraints for 'elbow_jiont', which is none of its joints; did you mean 'elbow_joint'?",
            "write 'elbow_joint'",
        ),
    ],
)
def test_what_the_robot_or_the_controller_does_not_have(findings, lines: tuple[str, ...], message: str, help: str):
    (told,) = _told(findings, *lines)
    assert (told.message, told.help, told.severity) == (message, help, Severity.WARNING)


@pytest.mark.parametrize(
    "lines",
    [
        ("joints: [elbow_joint]", "command_interfaces: [velocity]", "state_interfaces: [position]"),
        ("joints: [elbow_joint]", "gains: {elbow_joint: {p: 1.0}}", "constraints: {goal_time: 0.5}"),
        ("joints: [shoulder_pan_joint]",),  # the robot may be elsewhere
        ("joints: [arm_joint_2]",),  # another joint than that with the number 1
        ("joints: [arm_joint_1]", "command_interfaces: [position]"),  # no hardware here has it
        ("command_joints: [elbow_pid/elbow]",),  # a controller in front of the joint
        ("joints: [$(var prefix)elbow]",),
        ("gains: {elbow: {p: 1.0}}",),  # its joints stand elsewhere
        ("joints: [elbow_joint]", "constraints: {stopped_velocity_tolerance: 0.1}"),
    ],
)
def test_what_they_have_or_may_have(findings, lines: tuple[str, ...]):
    assert _told(findings, *lines) == []


def test_a_section_of_a_node_that_is_no_controller(findings):
    assert _told(findings, "joints: [elbow]", head="arm:\n  ros__parameters:\n") == []


@pytest.mark.parametrize(
    ("line", "times"),
    [
        ("<joint name='${side}elbow'/>", 0),
        ("<joint name='$(arg side)_elbow'/>", 1),  # never without the bar in front
        ("<!-- <joint name='elbow'/> -->", 1),
    ],
)
def test_a_name_that_xacro_makes(findings, line: str, times: int):
    robot = ROBOT.replace('<joint name="arm_joint_1" type="fixed"/>', line)
    assert len(_told(findings, "joints: [elbow]", robot=robot)) == times


@pytest.mark.parametrize(
    "line",
    [
        '<joint name="elbow_joint"><command_interface name="${mode}"/></joint>',
        '<joint name="elbow_joint"><command_interface name="position"/></joint>',  # of another variant
        '<joint name="${prefix}elbow_joint"><command_interface name="position"/></joint>',
    ],
)
def test_an_interface_that_another_description_may_have(findings, line: str):
    other = f"<robot><ros2_control>{line}</ros2_control></robot>"
    text = CONTROLLERS + "    joints: [elbow_joint]\n    command_interfaces: [position]\n"
    files = {"config/p.yaml": text, "urdf/robot.urdf.xacro": ROBOT, "urdf/other.xacro": other}
    assert findings("PRM012", **files) == []


def test_an_interface_that_a_macro_gives_to_every_joint(findings):
    macro = """\
<robot name="other" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="driven" params="name">
    <joint name="${name}"><command_interface name="velocity"/><command_interface name="position"/></joint>
  </xacro:macro>
  <ros2_control name="other" type="system"><xacro:driven name="elbow_joint"/></ros2_control>
</robot>
"""
    text = CONTROLLERS + "    joints: [elbow_joint]\n    command_interfaces: [effort]\n"
    files = {"urdf/robot.urdf.xacro": ROBOT, "urdf/other.urdf.xacro": macro}
    assert findings("PRM012", **{**files, "config/p.yaml": text.replace("effort", "position")}) == []
    (found,) = findings("PRM012", **{**files, "config/p.yaml": text})
    assert found.message.endswith("and the hardware there has 'position', 'velocity'")


def test_an_interface_that_several_joints_lack_is_told_once(findings):
    robot = ROBOT.replace("<gpio", '<joint name="arm_joint_1"><command_interface name="velocity"/></joint><gpio')
    (found,) = _told(findings, "joints: [elbow_joint, arm_joint_1]", "command_interfaces: [position]", robot=robot)
    assert found.related == ()
    wants = "'arm' wants the command interface 'elbow_joint/position' (and that of 1 more joint)"
    assert found.message == f"{wants}, and the hardware there has 'velocity'"


@pytest.mark.parametrize(
    ("commands", "states", "help"),
    [
        (
            "position",
            "[position, velocity]",  # the controller refuses [position, position]
            "remove 'velocity' from state_interfaces, or add it to the joint in the description, if the hardware has "
            "it",
        ),
        (
            "velocity",
            "[position, velocity]",  # and a trajectory of velocities without the state of them
            "add it to the joint in the description, if the hardware has it",
        ),
        ("position", "[velocity]", "write 'position'"),
    ],
)
def test_what_to_write_instead_of_an_interface(findings, commands: str, states: str, help: str):
    robot = ROBOT.replace('"velocity"', f'"{commands}"')
    lines = ("joints: [elbow_joint]", f"command_interfaces: [{commands}]", f"state_interfaces: {states}")
    (found,) = _told(findings, *lines, robot=robot)
    assert (found.message.partition(",")[0], found.help) == (
        "'arm' wants the state interface 'elbow_joint/velocity'",
        help,
    )


def test_a_file_that_nobody_reads_is_information(findings):
    not_installed = {"setup.py": SETUP.replace("glob('config/*')", "[]")}
    text = CONTROLLERS + "    joints: [elbow]\n"
    (told,) = findings("PRM012", **{"config/p.yaml": text, "urdf/robot.urdf.xacro": ROBOT}, **not_installed)
    assert told.severity == Severity.INFO


def test_the_names_of_one_list_are_one_finding(findings):
    robot = ROBOT.replace('<gpio name="lights">', '<joint name="wrist_joint"/><gpio name="lights">')
    told, other = _told(findings, "joints: [elbow, wrist]", "dof_names: [elbwo_joint]", robot=robot)
    assert told.message.endswith("did you mean 'elbow_joint'?; another name of the list is unknown, too")
    assert ["'wrist'" in row.message for row in told.related] == [True]
    assert "'elbwo_joint'" in other.message


@pytest.mark.parametrize(
    ("named", "told"),
    [
        (("new.yaml",), []),  # the old one is left over
        (("old.yaml",), ["config/old.yaml"]),
        (("old.yaml", "new.yaml"), ["config/old.yaml"]),
        ((), ["config/old.yaml"]),  # somebody may start either
    ],
)
def test_a_file_whose_controllers_another_has_that_is_used(findings, named: tuple[str, ...], told: list[str]):
    uses = "".join(f"<plugin><parameters>$(find robot)/config/{name}</parameters></plugin>" for name in named)
    robot = ROBOT.replace("</robot>", f"<gazebo>{uses}</gazebo></robot>")
    old, new = (f"{CONTROLLERS}    joints: [{joint}]\n" for joint in ("elbow", "elbow_joint"))
    files = {"config/old.yaml": old, "config/new.yaml": new, "urdf/robot.urdf.xacro": robot}
    files |= {"README.md": "What is old is left.\n"}
    assert [row.place.file for row in findings("PRM012", **files)] == told


@pytest.mark.parametrize(
    ("own", "times"),
    [
        ("<joint name='wheel'><command_interface name='position'/></joint>", 0),  # other hardware
        ("<joint name='${side}_joint'><command_interface name='velocity'/></joint>", 1),
        ("", 1),
    ],
)
def test_the_description_of_another_package(tmp_path, own: str, times: int):
    """The package of the file has a robot of its own, and the joints are of another one's."""
    text = CONTROLLERS + "    joints: [elbow_joint]\n    command_interfaces: [effort]\n"
    robot = f"<robot><ros2_control>{own}</ros2_control></robot>"
    files = {"robot/package.xml": manifest(), "robot/config/p.yaml": text, "robot/urdf/robot.xacro": robot}
    files |= {"arm/package.xml": manifest("arm"), "arm/urdf/arm.xacro": ROBOT}
    write_files(tmp_path, {**files, "archlint.toml": 'select = ["PRM012"]\n'})
    request = Request((str(tmp_path),), load(tmp_path), cached=False, jobs=1)
    assert len(check(request).findings) == times


WHEELS = """\
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <xacro:macro name="wheel" params="side">
    <link name="${side}_wheel"/>
    <joint name="${side}_wheel_joint" type="continuous"><parent link="base"/><child link="${side}_wheel"/></joint>
  </xacro:macro>
  <xacro:wheel side="back_left"/>
"""
HARDWARE = """\
  <ros2_control name="robot" type="system">
    <joint name="NAME"><command_interface name="velocity"/></joint>
  </ros2_control>
"""


STARTS = '<let name="robot" value="$(find-pkg-share robot)/urdf/robot.urdf.xacro"/>'


def _of_hardware(findings, joint: str, before: str = "", launch: str = STARTS, **files: str):
    robot = WHEELS + before + HARDWARE.replace("NAME", joint) + "</robot>\n"
    return findings("PRM012", launch, **{"urdf/robot.urdf.xacro": robot}, **files)


@pytest.mark.parametrize(
    ("joint", "near"),
    [("rear_left_wheel_joint", ""), ("back_left_wheel_jiont", "back_left_wheel_joint")],
)
def test_a_joint_of_hardware_that_the_robot_does_not_have(findings, joint: str, near: str):
    (told,) = _of_hardware(findings, joint)
    asked = f"; did you mean '{near}'?" if near else ""
    assert told.message == (
        f"<ros2_control> has a joint '{joint}', and the robot in 'robot.urdf.xacro' has none{asked}: since Jazzy the "
        "controller manager refuses such a description; before, no link moves with it"
    )
    assert told.help == (f"write '{near}'" if near else "give it the name of a joint of the robot, or remove it")
    assert (told.place.file, told.place.line) == ("urdf/robot.urdf.xacro", 9)


@pytest.mark.parametrize(
    ("joint", "before"),
    [
        ("back_left_wheel_joint", ""),
        ("${'back_left'}_wheel_joint", ""),
        ("front_wheel_joint", '<xacro:if value="$(arg front)"><xacro:wheel side="front"/></xacro:if>'),
        ("front_wheel_joint", '<xacro:wheel side="$(arg side)"/>'),
        ("front_wheel_joint", '<xacro:include filename="$(find elsewhere)/front.xacro"/>'),
        ("$(arg joint)", ""),
    ],
)
def test_a_joint_of_hardware_that_the_robot_has_or_may_have(findings, joint: str, before: str):
    assert _of_hardware(findings, joint, before) == []


def test_a_joint_of_hardware_in_a_part_of_a_robot(findings):
    whole = WHEELS.replace("back_left", "arm") + '<xacro:include filename="robot.urdf.xacro"/></robot>'
    launch = STARTS + STARTS.replace("robot.urdf", "whole")
    assert _of_hardware(findings, "arm_wheel_joint", launch=launch, **{"urdf/whole.xacro": whole}) == []


@pytest.mark.parametrize(("launch", "told"), [(STARTS, 1), (STARTS.replace("robot.urdf", "rover.urdf"), 0), ("", 0)])
def test_a_joint_of_hardware_in_a_description_that_no_launch_file_names(findings, launch: str, told: int):
    assert len(_of_hardware(findings, "rear_left_wheel_joint", launch=launch)) == told


def test_what_hardware_calls_a_joint_and_is_none(findings):
    scaling = '<joint name="speed_scaling"><state_interface name="speed_scaling_factor"/></joint>'
    robot = WHEELS + f'<ros2_control name="robot" type="system">{scaling}</ros2_control></robot>'
    assert findings("PRM012", STARTS, **{"urdf/robot.urdf.xacro": robot}) == []
