"""LCH012: controllers that are spawned and that the controller manager does not know."""

from __future__ import annotations

import pytest

CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    wheel_controller:
      type: diff_drive_controller/DiffDriveController
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
gripper_controller:
  ros__parameters:
    type: position_controllers/GripperActionController
wheel_controller:
  ros__parameters:
    publish_rate: 50.0
"""
MANAGER = (
    '<node pkg="controller_manager" exec="ros2_control_node"{}>'
    '<param from="$(find-pkg-share robot)/config/controllers.yaml"/>{}</node>'
)


def _spawner(words: str, more: str = "") -> str:
    return f'<node pkg="controller_manager" exec="spawner" args="{words}"{more}/>'


def _told(findings, launch: str, controllers: str = CONTROLLERS):
    return findings("LCH012", launch, **{"config/controllers.yaml": controllers})


def test_a_controller_of_another_name(findings):
    (told,) = _told(findings, MANAGER.format("", "") + _spawner("wheels_controller"))
    assert told.message == (
        "the controller manager gets no type of a controller 'wheels_controller', so that spawning it fails; "
        "did you mean 'wheel_controller'?"
    )
    assert told.help == "write 'wheel_controller'"
    assert told.place.file == "launch/it.launch.xml"
    (told,) = _told(findings, MANAGER.format("", "") + _spawner("imu_broadcaster -c /controller_manager"))
    assert told.help == "spawn one that it knows: arm_controller, gripper_controller, wheel_controller"


def test_a_controller_that_several_spawners_name(findings):
    launch = MANAGER.format("", "") + _spawner("legs --inactive") + _spawner("arm_controller legs")
    (told,) = _told(findings, launch)
    assert [row.message for row in told.related][1:] == ["it is spawned here, too"]


@pytest.mark.parametrize(
    "spawner",
    [
        _spawner("wheel_controller arm_controller gripper_controller --inactive"),
        _spawner("wheel_controller --controller-manager-timeout 30 -c controller_manager"),
        _spawner("legs --controller-type legs/Legs"),
        _spawner("legs --param-file legs.yaml"),
        _spawner("$(env CONTROLLER)"),
        _spawner("legs --new-option"),
        '<node pkg="controller_manager" exec="unspawner" args="legs"/>',
        '<node pkg="another_manager" exec="spawner" args="legs"/>',
    ],
)
def test_a_spawner_that_succeeds_or_may(findings, spawner: str):
    assert _told(findings, MANAGER.format("", "") + spawner) == []


@pytest.mark.parametrize(
    "manager",
    [
        "",
        '<arg name="real"/>' + MANAGER.format(' if="$(var real)"', ""),
        '<arg name="real" default="false"/>' + MANAGER.format(' if="$(var real)"', ""),
        MANAGER.format("", "") + MANAGER.format(' namespace="left"', ""),
        MANAGER.format("", '<param from="/etc/robot/controllers.yaml"/>'),
        MANAGER.format("", '<param name="legs.type" value="legs/Legs"/>'),
    ],
)
def test_a_manager_that_may_know_more(findings, manager: str):
    assert _told(findings, manager + _spawner("legs")) == []


def test_a_manager_that_knows_no_controller_at_all(findings):
    controllers = "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"
    assert _told(findings, MANAGER.format("", "") + _spawner("legs"), controllers) == []


NO_TYPES = """\
controller_manager:
  ros__parameters:
    update_rate: 100
arm_controller:
  ros__parameters:
    joints: [elbow]
"""


@pytest.mark.parametrize(
    ("controllers", "launch", "told"),
    [
        (NO_TYPES, MANAGER.format("", "") + _spawner("arm_controller legs"), 1),
        (NO_TYPES, MANAGER.format("", "") + _spawner("arm_controller --controller-type arm/Arm"), 0),
        (NO_TYPES, MANAGER.format("", '<param from="/etc/types.yaml"/>') + _spawner("arm_controller"), 0),
        (NO_TYPES, MANAGER.format(' args="--ros-args --params-file t.yaml"', "") + _spawner("arm_controller"), 0),
        (NO_TYPES.replace("100\n", "100\n    arm_controller.type: a/Arm\n"), MANAGER.format("", ""), 0),
        # Nothing there is for the manager.
        (NO_TYPES.replace("controller_manager", "move_group"), MANAGER.format("", "") + _spawner("arm_controller"), 0),
    ],
)
def test_a_file_with_the_values_of_a_controller_and_no_types(findings, controllers: str, launch: str, told: int):
    rows = _told(findings, launch, controllers)
    assert [row.message for row in rows] == [
        "the controller manager gets no type of a controller 'arm_controller', so that spawning it fails"
    ] * told
    assert all(
        row.help == "write `arm_controller: {type: …}` into the section of the controller manager" for row in rows
    )


def test_controllers_of_which_none_has_a_type_are_one_finding(findings):
    controllers = NO_TYPES + "leg_controller:\n  ros__parameters:\n    joints: [knee]\n"
    spawners = f"{_spawner('arm_controller')}\n{_spawner('leg_controller')}"
    (told,) = _told(findings, MANAGER.format("", "") + spawners, controllers)
    assert [row.message for row in told.related][1:] == ["what is spawned here has no type, either"]


MOVEIT = """\
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_spawn_controllers_launch


def generate_launch_description():
    config = MoveItConfigsBuilder('robot', package_name='robot').to_moveit_configs()
    description = generate_spawn_controllers_launch(config)
    known = {'arm_controller.type': 'joint_trajectory_controller/JointTrajectoryController'}
    known['joint_state_broadcaster.type'] = 'joint_state_broadcaster/JointStateBroadcaster'
    description.add_action(Node(package='controller_manager', executable='ros2_control_node', parameters=[known]))
    return description
"""
NAMED = """\
moveit_simple_controller_manager:
  controller_names:
    - {0}
  {0}:
    type: FollowJointTrajectory
"""


def test_a_controller_that_the_configuration_of_moveit_names(findings):
    files = {"launch/spawn.launch.py": MOVEIT, "config/moveit_controllers.yaml": NAMED.format("arms_controller")}
    (told,) = findings("LCH012", **files)
    assert (told.place.file, told.place.line) == ("config/moveit_controllers.yaml", 3)
    assert told.help == "write 'arm_controller'"
    assert [(row.place.file, row.place.line) for row in told.related] == [
        ("launch/spawn.launch.py", 8),
        ("launch/spawn.launch.py", 11),
    ]
    files["config/moveit_controllers.yaml"] = NAMED.format("arm_controller")
    assert findings("LCH012", **files) == []


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("--set-state active wheels", 1),
        ("wheels --set-state inactive -c /controller_manager", 1),
        ("--set-state active wheel_controller", 0),
        ("wheels $(find-pkg-share robot)/config/wheels.yaml", 0),
        ("--set-state active $(env NAME)", 0),
    ],
)
def test_the_command_that_loads_a_controller(findings, words: str, told: int):
    command = f'<executable cmd="ros2 control load_controller {words}"/>'
    assert len(_told(findings, MANAGER.format("", "") + command)) == told
    other = '<executable cmd="ros2 control list_controllers wheels"/>'
    assert _told(findings, MANAGER.format("", "") + other) == []


DESCRIPTION = """\
<robot name="robot" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <gazebo>
    <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      {}
    </plugin>
  </gazebo>
</robot>
"""
NAMES_FILE = "<parameters>$(find robot)/config/controllers.yaml</parameters>"


def _in_simulator(findings, launch: str, names: str = NAMES_FILE, **files: str):
    files = {"config/controllers.yaml": CONTROLLERS, "urdf/robot.urdf.xacro": DESCRIPTION.format(names)} | files
    return findings("LCH012", launch, **files)


@pytest.mark.parametrize(
    "before",
    [
        "",
        '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>',
        '<node pkg="ros_gz_sim" exec="create"/>',
    ],
)
def test_a_manager_in_a_simulator(findings, before: str):
    (told,) = _in_simulator(findings, before + _spawner("arm_controller") + _spawner("wheels_controller"))
    assert told.message.endswith("'wheels_controller', so that spawning it fails; did you mean 'wheel_controller'?")
    assert [(row.message, row.place.file, row.place.line) for row in told.related] == [
        ("the controller manager in the simulator gets its file here", "urdf/robot.urdf.xacro", 4)
    ]


@pytest.mark.parametrize(
    "names",
    [
        "",
        "<parameters>$(arg controllers)</parameters>",
        f"{NAMES_FILE}<parameters>$(find elsewhere)/config/controllers.yaml</parameters>",
        "<parameters>$(find robot)/config/others.yaml</parameters>",
        f"<!-- {NAMES_FILE} -->",
    ],
)
def test_a_manager_in_a_simulator_that_may_get_other_files(findings, names: str):
    assert _in_simulator(findings, _spawner("legs"), names) == []


@pytest.mark.parametrize(
    ("launch", "files"),
    [
        (_spawner("arm_controller gripper_controller"), {}),
        (_spawner("legs --controller-type legs/Legs"), {}),
        (_spawner("legs"), {"config/more.yaml": "controllers: [legs]\n"}),
        ('<include file="$(find-pkg-share elsewhere)/launch/control.launch.py"/>' + _spawner("legs"), {}),
        ('<include file="$(env FILE)"/>' + _spawner("legs"), {}),
        (_spawner("legs"), {"urdf/robot.urdf.xacro": "<robot name='robot'/>"}),
    ],
)
def test_a_simulator_in_which_a_spawner_succeeds_or_may(findings, launch: str, files: dict[str, str]):
    assert _in_simulator(findings, launch, **files) == []
