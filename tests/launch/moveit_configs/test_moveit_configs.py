"""What MoveItConfigsBuilder collects from the files of a package."""

from __future__ import annotations

import pytest

from archlint.syntax.parameter_files import NotKnown

BUILDER = """
from moveit_configs_utils import MoveItConfigsBuilder
configs = MoveItConfigsBuilder('arm'{given}){calls}
"""


@pytest.fixture
def arm(launches):
    launches.package("arm_moveit_config")
    for name, text in FILES.items():
        launches.file(f"arm_moveit_config/{name}", text)
    return launches


FILES = {
    "setup.py": """
from setuptools import setup
setup(name='arm_moveit_config', data_files=[
    ('share/arm_moveit_config', ['package.xml', '.setup_assistant']),
    ('share/arm_moveit_config/config', ['config/arm.urdf.xacro', 'config/arm.srdf', 'config/kinematics.yaml',
        'config/joint_limits.yaml', 'config/moveit_controllers.yaml', 'config/ompl_planning.yaml'])])
""",
    ".setup_assistant": "moveit_setup_assistant_config: {}\n",
    "config/arm.urdf.xacro": "<robot/>",
    "config/arm.srdf": "<robot/>",
    "config/kinematics.yaml": "arm:\n  kinematics_solver: kdl/KDL\n",
    "config/joint_limits.yaml": "joint_limits:\n  lift:\n    max_velocity: 0.5\n",
    "config/moveit_controllers.yaml": "moveit_controller_manager: simple\n",
    "config/ompl_planning.yaml": "longest_valid_segment_fraction: 0.1\nplanner_configs: {}\n",
}


def parameters(launches, given: str = "", calls: str = ".to_moveit_configs()", value: str = "configs.to_dict()", **how):
    """The parameters of a node that is given what a builder makes, by name; and why there may be more."""
    before = BUILDER.format(given=given, calls=calls)
    node = f"Node(package='robot', executable='talker', parameters=[{value}])"
    launches.file("robot/launch/it.launch.py", "")
    (started,) = launches.python(f"[{node}]", before, **how).started
    known = {row.name: row.value for row in started.parameters if getattr(row, "name", None)}
    return known, [row.reason for row in started.parameters if not hasattr(row, "name") and hasattr(row, "reason")]


def test_the_files_of_the_package_are_collected(arm):
    found, more = parameters(arm, calls=".planning_pipelines(pipelines=['ompl']).to_moveit_configs()")
    assert isinstance(found["robot_description"], NotKnown)  # xacro makes it
    assert isinstance(found["robot_description_semantic"], NotKnown)
    assert found["robot_description_kinematics.arm.kinematics_solver"] == "kdl/KDL"
    assert found["robot_description_planning.joint_limits.lift.max_velocity"] == 0.5
    assert found["moveit_controller_manager"] == "simple"
    assert found["moveit_manage_controllers"] is True
    assert found["publish_robot_description"] is False
    assert found["planning_pipelines"] == ["ompl"]
    assert found["default_planning_pipeline"] == "ompl"
    assert found["ompl.longest_valid_segment_fraction"] == 0.1
    assert "ompl.planner_configs.RRT.type" not in found  # the package has planner_configs of its own
    assert more == []


def test_what_the_calls_say_comes_first(arm):
    arm.file("arm_moveit_config/config/other.yaml", "gripper:\n  kinematics_solver: mine\n")
    calls = """.robot_description_kinematics('config/other.yaml').planning_scene_monitor(
    publish_robot_description=True).planning_pipelines('stomp', ['stomp', 'ompl']).to_moveit_configs()"""
    found, _ = parameters(arm, calls=calls)
    assert found["robot_description_kinematics.gripper.kinematics_solver"] == "mine"
    assert found["publish_robot_description"] is True
    assert found["default_planning_pipeline"] == "stomp"


def test_one_part_alone(arm):
    found, more = parameters(arm, value="configs.robot_description_kinematics")
    assert found == {"robot_description_kinematics.arm.kinematics_solver": "kdl/KDL"}
    assert more == []


def test_the_order_in_which_a_folder_lists_its_files_is_not_known(arm):
    found, _ = parameters(arm)
    order = found["planning_pipelines"]
    assert isinstance(order, NotKnown)
    assert order.reason == "the order in which a folder lists its files"
    assert found["default_planning_pipeline"] == "ompl"


def test_the_defaults_of_a_distribution_that_is_not_known_are_open(arm):
    _, more = parameters(arm, calls=".planning_pipelines(pipelines=['chomp']).to_moveit_configs()")
    assert more == ["a dict of parameters with entries that are not known"]


def test_a_package_that_is_not_here_is_open(launches):
    found, more = parameters(launches, calls=".planning_pipelines(pipelines=['ompl']).to_moveit_configs()")
    assert isinstance(found["robot_description"], NotKnown)
    assert more != []


def test_a_name_that_is_not_known_makes_all_of_it_open(arm):
    found, more = parameters(arm, given=", package_name=os.environ['PACKAGE']")
    assert "robot_description_kinematics.arm.kinematics_solver" not in found
    assert more != []


def test_parameters_of_ones_own(arm):
    calls = ".parameter('mode', 'fast').yaml('config/joint_limits.yaml', 'limits')"
    found, more = parameters(arm, calls=calls, value="configs.to_dict(include_moveit_configs=False)")
    assert found == {"mode": "fast", "limits.joint_limits.lift.max_velocity": 0.5}
    assert more == []


def test_a_branch_that_is_not_decided_leaves_its_part_open(arm):
    calls = """
if os.environ['SENSORS']:
    configs.joint_limits('config/kinematics.yaml')
limits = configs.to_moveit_configs().joint_limits
"""
    found, more = parameters(arm, calls=calls, value="limits")
    assert found == {}
    assert more != []
