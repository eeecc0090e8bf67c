"""The programs of packages of ROS that launch files start most, as all distributions since Foxy install them.

Source: their CMakeLists.txt and setup.py in the branches of these distributions.  A package is left out whose programs
are many, or change.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

_PROGRAMS: Mapping[str, str] = {
    "controller_manager": "ros2_control_node spawner unspawner hardware_spawner spawner.py unspawner.py",
    "foxglove_bridge": "foxglove_bridge",
    "gazebo_ros": "spawn_entity.py gazebo_ros_paths.py",
    "joint_state_publisher": "joint_state_publisher",
    "joint_state_publisher_gui": "joint_state_publisher_gui",
    "joy": "joy_node game_controller_node joy_enumerate_devices",
    "nav2_amcl": "amcl",
    "nav2_behaviors": "behavior_server",
    "nav2_bt_navigator": "bt_navigator",
    "nav2_collision_monitor": "collision_monitor collision_detector",
    "nav2_controller": "controller_server",
    "nav2_lifecycle_manager": "lifecycle_manager",
    "nav2_map_server": "map_server map_saver_cli map_saver_server costmap_filter_info_server vector_object_server",
    "nav2_planner": "planner_server",
    "nav2_smoother": "smoother_server",
    "nav2_velocity_smoother": "velocity_smoother",
    "nav2_waypoint_follower": "waypoint_follower",
    "rclcpp_components": "component_container component_container_mt component_container_isolated",
    "robot_localization": "ekf_node ukf_node navsat_transform_node robot_localization_listener_node se_node",
    "robot_state_publisher": "robot_state_publisher",
    "ros_gz_bridge": "parameter_bridge static_bridge bridge_node",
    "ros_gz_sim": "create gzserver remove delete_entity spawn_entity set_entity_pose",
    "ros_ign_bridge": "parameter_bridge static_bridge",
    "ros_ign_gazebo": "create",
    "rviz2": "rviz2",
    "slam_toolbox": "async_slam_toolbox_node sync_slam_toolbox_node localization_slam_toolbox_node "
    "lifelong_slam_toolbox_node map_and_localization_slam_toolbox_node merge_maps_kinematic",
    "teleop_twist_joy": "teleop_node",
    "teleop_twist_keyboard": "teleop_twist_keyboard",
    "tf2_ros": "static_transform_publisher tf2_echo tf2_monitor buffer_server",
    "turtlesim": "turtlesim_node turtle_teleop_key draw_square mimic",
    "twist_mux": "twist_mux twist_marker",
}
_MORE = {
    "rclcpp_components": re.compile(r"component_container_\w+"),
    "slam_toolbox": re.compile(r"\w+slam_toolbox_node"),
}
"""What newer ones of a package are called."""


_BEFORE_HUMBLE: Mapping[str, frozenset[str]] = {"controller_manager": frozenset({"spawner.py", "unspawner.py"})}
"""Those of them that Humble and all later distributions lack."""

_LAUNCH_FILES: Mapping[str, frozenset[str]] = {
    "gazebo_ros": frozenset({"gazebo", "gzserver", "gzclient"}),
    "ros_gz_sim": frozenset({"gz_sim", "gz_server"}),
}
"""What such packages have a launch file for, ``gazebo.launch.py``, and no program."""


_WITHOUT_NODE: Mapping[str, frozenset[str]] = {
    "micro_ros_agent": frozenset({"micro_ros_agent"}),
    "xacro": frozenset({"xacro", "xacro.py"}),
}
"""Programs that initialise no ROS: what stands behind ``--ros-args``, parameter files included, nobody reads."""


def is_without_node(package: str | None, name: str | None) -> bool:
    """Whether a program of a well-known package initialises no ROS, so that it takes no parameter file."""
    return package is not None and name in _WITHOUT_NODE.get(package, ())


def launch_file_instead(package: str, name: str) -> str | None:
    """The launch file of a package of ROS that starts what somebody takes for one of its programs."""
    return f"{name}.launch.py" if name in _LAUNCH_FILES.get(package, ()) else None


def programs_of(package: str) -> list[str]:
    """The programs of a package of ROS; none where they are not known."""
    return _PROGRAMS.get(package, "").split()


def owner_of_program(name: str) -> str | None:
    """The one well-known package of ROS that has a program of a name."""
    owners = [package for package, programs in _PROGRAMS.items() if name in programs.split()]
    return owners[0] if len(owners) == 1 else None


def programs_instead(package: str, name: str, since_humble: bool = False) -> list[str]:
    """The programs of a package which does not have one of a name; empty where it has, or may have it.  With
    ``since_humble`` it is the package as Humble and later distributions have it."""
    gone = _BEFORE_HUMBLE.get(package, frozenset()) if since_humble else frozenset()
    programs = [program for program in _PROGRAMS.get(package, "").split() if program not in gone]
    may_be = name in programs or (package in _MORE and _MORE[package].fullmatch(name) is not None)
    return [] if may_be else programs


__all__ = ["is_without_node", "owner_of_program", "programs_instead", "programs_of"]
