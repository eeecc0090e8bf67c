"""PRM002 of parameter files for plugins and nodes from elsewhere, whose types are known: Nav2 and ros2_controllers."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import SETUP, manifest, node

NAV2 = """\
controller_server:
  ros__parameters:
    controller_frequency: 20.0
    controller_plugins: [FollowPath]
    FollowPath:
      plugin: {plugin}
      max_vel_x: {speed}
      critics: [GoalDist]
      GoalDist.scale: {scale}
local_costmap:
  local_costmap:
    ros__parameters:
      width: {width}
      inflation:
        plugin: nav2_costmap_2d::InflationLayer
        inflation_radius: {radius}
"""
RIGHT = {"plugin": "dwb_core::DWBLocalPlanner", "speed": "0.5", "scale": "24.0", "width": "3", "radius": "0.7"}
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: %s}
arm:
  ros__parameters:
    joints: [elbow]
    constraints:
      goal_time: %s
      elbow: {goal: %s}
"""
LOAD_IT = node('<param from="$(find-pkg-share robot)/config/p.yaml"/>')


def _told(findings, text: str, **others: str):
    return findings("PRM002", LOAD_IT, **{"config/p.yaml": text, **others})


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        (
            {"speed": "1"},
            "dwb_core::DWBLocalPlanner declares 'FollowPath.max_vel_x' as double, and this sets 1, of type integer",
        ),
        (
            {"scale": "32"},
            "dwb_core::DWBLocalPlanner declares 'FollowPath.GoalDist.scale' as double, and this sets 32, of type "
            "integer",
        ),
        ({"width": "2.5"}, "local_costmap declares 'width' as integer, and this sets 2.5, of type double"),
        (
            {"radius": "'0.7'"},
            "nav2_costmap_2d::InflationLayer declares 'inflation.inflation_radius' as double, and this sets '0.7', "
            "of type string",
        ),
    ],
)
def test_a_value_that_a_plugin_or_node_of_nav2_refuses(findings, changed: dict[str, str], message: str):
    (told,) = _told(findings, NAV2.format(**{**RIGHT, **changed}))
    assert (told.message, told.severity, told.place.file) == (message, Severity.ERROR, "config/p.yaml")


@pytest.mark.parametrize(
    "changed",
    [
        {},
        {"speed": "SPEED"},  # a program puts in what it stands for
        {"plugin": "team::Planner", "speed": "1", "scale": "32"},
    ],
)
def test_a_value_that_fits_or_may(findings, changed: dict[str, str]):
    assert _told(findings, NAV2.format(**{**RIGHT, **changed})) == []


def test_values_that_are_wrong_in_the_same_way_are_one_finding(findings):
    (told,) = _told(findings, NAV2.format(**{**RIGHT, "speed": "1", "scale": "32", "radius": "1"}))
    assert told.message.endswith("; 2 more values are of type integer instead of double, too")
    assert told.help == "write 1.0: rclcpp does not convert an integer to a double"


@pytest.mark.parametrize(
    ("kind", "goal_time", "goal", "names"),
    [
        ("joint_trajectory_controller/JointTrajectoryController", "5", "0.1", ["constraints.goal_time"]),
        ("joint_trajectory_controller/JointTrajectoryController", "5.0", "1", ["constraints.elbow.goal"]),
        ("joint_trajectory_controller/JointTrajectoryController", "5.0", "0.1", []),
        ("team_controllers/ArmController", "5", "1", []),
    ],
)
def test_a_value_that_a_controller_refuses(findings, kind: str, goal_time: str, goal: str, names: list[str]):
    told = _told(findings, CONTROLLERS % (kind, goal_time, goal))
    assert [row.message.split("'")[1] for row in told] == names


def test_a_controller_that_names_its_type_itself(findings):
    own = "arm:\n  ros__parameters:\n    type: diff_drive_controller/DiffDriveController\n    wheel_radius: 1\n"
    (told,) = _told(findings, own)
    assert told.message.startswith("diff_drive_controller/DiffDriveController declares 'wheel_radius' as double")


def test_a_section_of_one_name_may_be_of_another_node(findings):
    assert _told(findings, "amcl:\n  ros__parameters:\n    max_beams: 60.0\n") == []


@pytest.mark.parametrize(
    ("package", "changed", "times"),
    [
        ("dwb_core", {"speed": "1"}, 0),
        ("nav2_costmap_2d", {"width": "2.5"}, 0),
        ("dwb_core", {"width": "2.5"}, 1),
    ],
)
def test_a_plugin_whose_source_is_here_may_declare_it_otherwise(
    findings, package: str, changed: dict[str, str], times: int
):
    files = {"config/p.yaml": NAV2.format(**{**RIGHT, **changed}), "package.xml": manifest(package)}
    assert len(findings("PRM002", "", **files)) == times


def test_foxy_takes_a_value_of_any_type(findings):
    assert _told(findings, NAV2.format(**{**RIGHT, "speed": "1"}), **{"README.md": "For ROS 2 Foxy."}) == []
    of_foxy = {"config/foxy/p.yaml": NAV2.format(**{**RIGHT, "speed": "1"})}
    assert findings("PRM002", "", **of_foxy) == []


def test_a_file_that_no_launch_file_here_loads(findings):
    text = NAV2.format(**{**RIGHT, "speed": "1"})
    (told,) = findings("PRM002", "", **{"config/p.yaml": text})
    assert told.severity == Severity.WARNING
    not_installed = SETUP.replace("glob('config/*')", "[]")
    (told,) = findings("PRM002", "", **{"config/p.yaml": text, "setup.py": not_installed})
    assert told.severity == Severity.INFO


def test_a_value_that_a_launch_file_sets_anew(findings):
    launch_file = """\
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from nav2_common.launch import RewrittenYaml


def generate_launch_description():
    file = [FindPackageShare('robot'), '/config/p.yaml']
    changed = RewrittenYaml(source_file=file, param_rewrites={'%s': '0.5'}, convert_types=True)
    return LaunchDescription([Node(package='robot', executable='talker', parameters=[changed])])
"""
    text = NAV2.format(**{**RIGHT, "speed": "1"})
    for name, times in (("max_vel_x", 0), ("FollowPath.max_vel_x", 0), ("width", 1)):
        files = {"config/p.yaml": text, "launch/nav.launch.py": launch_file % name}
        assert len(findings("PRM002", "", **files)) == times, name


@pytest.mark.parametrize(
    ("keys", "codes"),
    [
        ("local_costmap:\n  ros__parameters:\n    width: 2.5\n", ["PRM005"]),  # nobody gets it: so nobody refuses it
        ("/local_costmap:\n  ros__parameters:\n    width: 2.5\n", ["PRM005"]),
        ("local_costmap:\n  local_costmap:\n    ros__parameters:\n      width: 2.5\n", ["PRM002"]),
        ("/local_costmap/local_costmap:\n  ros__parameters:\n    width: 2.5\n", ["PRM002"]),
        ("/robot/local_costmap:\n  ros__parameters:\n    width: 2\n", []),
        ("/**:\n  ros__parameters:\n    width: 2\nlocal_costmap:\n  ros__parameters:\n    width: 2\n", []),
    ],
)
def test_a_costmap_without_its_namespace(findings, keys: str, codes: list[str]):
    """The node of a costmap lies in a namespace of its own name."""
    others = "".join(f"{name}:\n  ros__parameters:\n    use_sim_time: false\n" for name in ("amcl", "bt_navigator"))
    files = {"config/p.yaml": others + "controller_server:\n  ros__parameters: {x: 1}\n" + keys}
    told = [row for code in ("PRM002", "PRM005") for row in findings(code, "", **files)]
    assert [row.code for row in told] == codes
    if codes == ["PRM005"]:
        assert told[0].message == (
            "these parameters are for /local_costmap, and the costmap of Nav2 is /local_costmap/local_costmap, "
            "which gets none of them"
        )
        assert told[0].place.line == 9


def test_the_costmaps_of_a_file_are_one_finding(findings):
    names = ("amcl", "local_costmap", "global_costmap")
    text = "".join(f"{name}:\n  ros__parameters:\n    use_sim_time: false\n" for name in names)
    (told,) = findings("PRM005", "", **{"config/p.yaml": text})
    assert (told.place.line, [row.place.line for row in told.related]) == (4, [7])
    assert [row.message for row in told.related] == ["so it is with '/global_costmap'"]
    assert told.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("started", "readme", "times"),
    [("controller, talker", "", 1), ("talker", "", 0), ("talker", "ros2 run … --params-file config/p.yaml", 1)],
    ids=["it is started", "it is left out", "by hand"],
)
def test_a_costmap_in_a_file_that_nothing_is_started_with(findings, started: str, readme: str, times: int):
    launch_file = f"""
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    file = os.path.join(get_package_share_directory('robot'), 'config', 'p.yaml')
    controller = Node(package='nav2_controller', executable='controller_server', parameters=[file])
    talker = Node(package='robot', executable='talker')
    return LaunchDescription([{started}])
"""
    keys = ("amcl", "local_costmap", "global_costmap")
    text = "".join(f"{name}:\n  ros__parameters:\n    use_sim_time: false\n" for name in keys)
    files = {"config/p.yaml": text, "launch/nav.launch.py": launch_file, "README.md": readme}
    told = [row for row in findings("PRM005", "", **files) if "gets none of them" in row.message]
    assert len(told) == times


@pytest.mark.parametrize(("named", "times"), [("nav2_params_v2", 0), ("nav2_params", 1), ("elsewhere", 1)])
def test_a_costmap_in_a_file_that_another_one_has_replaced(findings, named: str, times: int):
    """The file that a launch file names is the one in use; without any, the command line may name both."""
    names = ("amcl", "bt_navigator", "local_costmap")
    old = "".join(f"{name}:\n  ros__parameters:\n    use_sim_time: false\n" for name in names)
    new = old.replace("local_costmap:\n", "local_costmap:\n  local_costmap:\n  ").replace("    use", "      use")
    include = f"""
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    file = get_package_share_directory('robot') + '/config/{named}.yaml'
    return LaunchDescription([DeclareLaunchArgument('params_file', default_value=file)])
"""
    files = {"config/nav2_params.yaml": old, "config/nav2_params_v2.yaml": new, "launch/nav.launch.py": include}
    assert len(findings("PRM005", "", **files)) == times
