"""The launch files that MoveIt's setup assistant writes: each calls one function of moveit_configs_utils."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import overrides_of
from launching import names

SRDF = """<?xml version='1.0'?>
<robot name='arm'>
  <virtual_joint name='fixed' type='fixed' parent_frame='world' child_link='base'/>
  <virtual_joint name='rail' type='planar' parent_frame='world' child_link='carriage'/>
</robot>
"""
FILES = {
    "setup.py": """
from glob import glob
from setuptools import setup
setup(name='arm_moveit_config', data_files=[
    ('share/arm_moveit_config', ['package.xml', '.setup_assistant']),
    ('share/arm_moveit_config/launch', glob('launch/*')),
    ('share/arm_moveit_config/config', glob('config/*'))])
""",
    ".setup_assistant": "moveit_setup_assistant_config: {}\n",
    "config/arm.urdf.xacro": "<robot/>",
    "config/arm.srdf": SRDF,
    "config/kinematics.yaml": "arm:\n  kinematics_solver: kdl/KDL\n",
    "config/joint_limits.yaml": "joint_limits:\n  lift:\n    max_velocity: 0.5\n",
    "config/moveit_controllers.yaml": (
        "moveit_controller_manager: simple\n"
        "moveit_simple_controller_manager:\n  controller_names: [arm_controller, hand_controller]\n"
    ),
    "config/ompl_planning.yaml": "longest_valid_segment_fraction: 0.1\nplanner_configs: {}\n",
    "config/ros2_controllers.yaml": "controller_manager:\n  ros__parameters:\n    update_rate: 100\n",
}
JOINTS = ["static_transform_publisher"] * 2
FUNCTIONS = (
    "rsp",
    "moveit_rviz",
    "move_group",
    "spawn_controllers",
    "static_virtual_joint_tfs",
    "warehouse_db",
    "demo",
)
FILE = """
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_{0}_launch

def generate_launch_description():
    configs = MoveItConfigsBuilder('arm', package_name='arm_moveit_config').to_moveit_configs()
    return generate_{0}_launch(configs)
"""


@pytest.fixture
def arm(launches):
    launches.package("arm_moveit_config")
    for name, text in FILES.items():
        launches.file(f"arm_moveit_config/{name}", text)
    for name in FUNCTIONS:
        launches.file(f"arm_moveit_config/launch/{name}.launch.py", FILE.format(name))
    return launches


def launched(arm, name: str, **arguments: str):
    return arm.of_workspace().run(f"arm_moveit_config/launch/{name}.launch.py", arguments)


def executables(found) -> list[str]:
    return [started.executable.text for started in found.started if not started.dormant]


@pytest.mark.parametrize(
    ("name", "started"),
    [
        ("rsp", ["robot_state_publisher"]),
        ("moveit_rviz", ["rviz2"]),
        ("move_group", ["move_group"]),
        ("spawn_controllers", ["spawner", "spawner", "spawner"]),
        ("static_virtual_joint_tfs", JOINTS),
        ("warehouse_db", ["mongo_wrapper_ros.py"]),
        (
            "demo",
            [
                *JOINTS,
                "robot_state_publisher",
                "move_group",
                "rviz2",
                "ros2_control_node",
                "spawner",
                "spawner",
                "spawner",
            ],
        ),
    ],
)
def test_what_a_function_starts(arm, name: str, started: list[str]):
    assert executables(launched(arm, name)) == started


@pytest.mark.parametrize(
    ("name", "arguments", "started"),
    [
        ("demo", {"use_rviz": "false", "db": "true"}, "mongo_wrapper_ros.py"),
        ("warehouse_db", {"reset": "true"}, "moveit_init_demo_warehouse"),
        ("move_group", {"debug": "true"}, "move_group"),
    ],
)
def test_its_arguments_decide(arm, name: str, arguments: dict[str, str], started: str):
    assert started in executables(launched(arm, name, **arguments))


def test_a_demo_needs_no_launch_file_of_a_database(launches):
    launches.package("arm_moveit_config")
    for name, text in FILES.items():
        launches.file(f"arm_moveit_config/{name}", text)
    launches.file("arm_moveit_config/launch/demo.launch.py", FILE.format("demo"))
    missing = {reference.written for reference in launched(launches, "demo").references if reference.source is None}
    assert not any("warehouse_db" in written for written in missing)
    assert any("move_group.launch.py" in written for written in missing)


def test_the_controllers_are_named_in_a_file(arm):
    words = [started.arguments for started in launched(arm, "spawn_controllers").started]
    assert words == [["arm_controller"], ["hand_controller"], ["joint_state_broadcaster"]]


def test_a_transform_for_each_virtual_joint(arm):
    started = launched(arm, "static_virtual_joint_tfs").started
    assert [(one.name.text, one.arguments[1], one.arguments[3]) for one in started] == [
        ("static_transform_publisher0", "world", "base"),
        ("static_transform_publisher1", "world", "carriage"),
    ]


def test_the_setup_assistant_names_the_file(arm):
    arm.file("arm_moveit_config/config/other.srdf", SRDF.replace("carriage", "cart"))
    named = "moveit_setup_assistant_config:\n  srdf:\n    relative_path: config/other.srdf\n"
    arm.file("arm_moveit_config/.setup_assistant", named)
    assert [one.arguments[3] for one in launched(arm, "static_virtual_joint_tfs").started] == ["base", "cart"]


@pytest.mark.parametrize("text", ["<robot><xacro:include filename='arm.xacro'/></robot>", "<robot", "${robot}"])
def test_how_many_virtual_joints_xacro_makes_is_not_known(arm, text: str):
    arm.file("arm_moveit_config/config/arm.srdf", text)
    found = launched(arm, "static_virtual_joint_tfs")
    assert found.started == []
    assert [gap.reason for gap in found.not_followed()]


def test_the_parameters_of_move_group(arm):
    [group] = [started for started in launched(arm, "move_group").started if not started.dormant]
    found = overrides_of(group, "/move_group", arm.of_workspace().files.parameters)
    assert found["publish_planning_scene"] is True
    assert found["monitor_dynamics"] is False
    assert found["capabilities"] == ""
    assert found["robot_description_kinematics.arm.kinematics_solver"] == "kdl/KDL"
    assert found["moveit_controller_manager"] == "simple"


def test_a_configuration_that_is_not_known(arm):
    launch = arm.python(
        "generate_rsp_launch(given())", "from moveit_configs_utils.launches import generate_rsp_launch\n"
    )
    assert names(launch) == []
    assert [gap.reason for gap in launch.not_followed()]


def test_a_launch_file_that_makes_a_debuggable_node_itself(arm):
    before = (
        "from moveit_configs_utils.launch_utils import DeclareBooleanLaunchArg, add_debuggable_node\n"
        "description = LaunchDescription([DeclareBooleanLaunchArg('debug', default_value=False)])\n"
        "add_debuggable_node(description, package='rviz2', executable='rviz2', arguments=['-d', 'arm.rviz'],\n"
        "                    extra_debug_args=['--debug'], output='log')\n"
    )
    started = arm.python("description", before).started
    assert [(one.arguments, one.dormant) for one in started] == [
        (["-d", "arm.rviz"], False),
        (["-d", "arm.rviz", "--debug"], True),
    ]
