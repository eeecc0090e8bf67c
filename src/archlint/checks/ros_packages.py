"""Which ROS package an imported module belongs to."""

from __future__ import annotations

from collections.abc import Container, Sequence

_BY_MODULE = {
    "action_msgs": "action_msgs",
    "ament_index_python": "ament_index_python",
    "cv_bridge": "cv_bridge",
    "diagnostic_updater": "diagnostic_updater",
    "geometry_msgs": "geometry_msgs",
    "image_geometry": "image_geometry",
    "laser_geometry": "laser_geometry",
    "launch": "launch",
    "launch_ros": "launch_ros",
    "message_filters": "message_filters",
    "nav2_simple_commander": "nav2_simple_commander",
    "py_trees_ros": "py_trees_ros",
    "rclpy": "rclpy",
    "ros2_numpy": "ros2_numpy",
    "rosbag2_py": "rosbag2_py",
    "rosidl_runtime_py": "rosidl_runtime_py",
    "sensor_msgs_py": "sensor_msgs_py",
    "tf2_geometry_msgs": "tf2_geometry_msgs",
    "tf2_ros": "tf2_ros",
    "tf2_sensor_msgs": "tf2_sensor_msgs",
    "tf_transformations": "tf_transformations",
}
"""Modules of ROS that are no interfaces."""

_INTERFACES = (".msg", ".srv", ".action")


def package_of_module(module: str, names: Sequence[str], workspace: Container[str]) -> str | None:
    """The ROS package that has to be there for an import; None for modules of anything else."""
    top, _, rest = module.partition(".")
    if top in _BY_MODULE:
        return _BY_MODULE[top]
    if module.endswith(_INTERFACES) or any(f"{kind}." in f".{rest}" for kind in _INTERFACES):
        return top
    if not rest and {"msg", "srv", "action"} & set(names):
        return top
    return top if top in workspace else None


_INTERFACE_BASE = frozenset({"builtin_interfaces"})
_STANDARD = _INTERFACE_BASE | {"std_msgs"}
_GEOMETRY = _STANDARD | {"geometry_msgs"}
_NODE = _INTERFACE_BASE | {"ament_index_python", "rcl_interfaces", "rosgraph_msgs"}
_LAUNCH = frozenset({"launch", "ament_index_python", "osrf_pycommon"})
_ROS_LAUNCH = _LAUNCH | _NODE | {"rclpy", "composition_interfaces", "lifecycle_msgs"}

BROUGHT: dict[str, frozenset[str]] = {
    "std_msgs": _INTERFACE_BASE,
    "rcl_interfaces": _INTERFACE_BASE,
    "geometry_msgs": _STANDARD,
    "sensor_msgs": _GEOMETRY,
    "nav_msgs": _GEOMETRY,
    "visualization_msgs": _GEOMETRY | {"sensor_msgs"},
    "trajectory_msgs": _GEOMETRY,
    "diagnostic_msgs": _GEOMETRY,
    "stereo_msgs": _GEOMETRY | {"sensor_msgs"},
    "shape_msgs": _GEOMETRY,
    "nav2_msgs": _GEOMETRY | {"nav_msgs", "action_msgs"},
    "common_interfaces": _GEOMETRY
    | {"sensor_msgs", "nav_msgs", "visualization_msgs", "trajectory_msgs", "diagnostic_msgs", "stereo_msgs"}
    | {"shape_msgs", "std_srvs", "actionlib_msgs"},
    "rclpy": _NODE,
    "tf2_ros_py": _GEOMETRY | _NODE | {"sensor_msgs", "rclpy", "tf2_msgs"},
    "sensor_msgs_py": _GEOMETRY | {"sensor_msgs"},
    "launch": _LAUNCH,
    "launch_ros": _ROS_LAUNCH,
    "launch_xml": _LAUNCH,
    "launch_yaml": _LAUNCH,
    "ros2launch": _ROS_LAUNCH | {"launch_ros", "launch_xml", "launch_yaml"},
    "nav2_common": _ROS_LAUNCH | {"launch_ros"},
}
"""What well-known packages of ROS name in their own manifests as needed at run time: whoever declares the one
gets the others installed."""
