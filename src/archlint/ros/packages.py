"""Which ROS package an imported module belongs to, which packages there are, and what these bring along."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path

import msgspec

FILE = Path(__file__).with_suffix(".json")
RELEASED = Path(__file__).with_name("released_names.json")

_BY_MODULE = {
    "action_msgs": "action_msgs",
    "ament_index_python": "ament_index_python",
    "controller_manager": "controller_manager",
    "cv_bridge": "cv_bridge",
    "diagnostic_updater": "diagnostic_updater",
    "geometry_msgs": "geometry_msgs",
    "image_geometry": "image_geometry",
    "laser_geometry": "laser_geometry",
    "launch": "launch",
    "launch_pytest": "launch_pytest",
    "launch_ros": "launch_ros",
    "launch_testing": "launch_testing",
    "launch_testing_ros": "launch_testing_ros",
    "launch_xml": "launch_xml",
    "launch_yaml": "launch_yaml",
    "message_filters": "message_filters",
    "moveit_configs_utils": "moveit_configs_utils",
    "nav2_common": "nav2_common",
    "nav2_simple_commander": "nav2_simple_commander",
    "py_trees_ros": "py_trees_ros",
    "python_qt_binding": "python_qt_binding",
    "qt_gui": "qt_gui",
    "rclpy": "rclpy",
    "resource_retriever": "resource_retriever",
    "ros2_numpy": "ros2_numpy",
    "ros2cli": "ros2cli",
    "rosbag2_py": "rosbag2_py",
    "rosidl_adapter": "rosidl_adapter",
    "rosidl_cli": "rosidl_cli",
    "rosidl_cmake": "rosidl_cmake",
    "rosidl_parser": "rosidl_parser",
    "rosidl_pycommon": "rosidl_pycommon",
    "rosidl_runtime_py": "rosidl_runtime_py",
    "rqt_gui": "rqt_gui",
    "rqt_gui_py": "rqt_gui_py",
    "sensor_msgs_py": "sensor_msgs_py",
    "tf2_geometry_msgs": "tf2_geometry_msgs",
    "tf2_py": "tf2_py",
    "tf2_ros": "tf2_ros_py",
    "tf2_sensor_msgs": "tf2_sensor_msgs",
    "tf_transformations": "tf_transformations",
    "xacro": "xacro",
}
"""Modules of ROS that are no interfaces."""

_INTERFACES = (".msg", ".srv", ".action")


def package_of_module(module: str, names: Sequence[str], of_workspace: Callable[[str], bool]) -> str | None:
    """The ROS package that has to be there for an import; None for modules of anything else.

    ``of_workspace`` says whether a package of the workspace has a module of its own name."""
    top, _, rest = module.partition(".")
    if top in _BY_MODULE:
        return _BY_MODULE[top]
    if module.endswith(_INTERFACES) or any(f"{kind}." in f".{rest}" for kind in _INTERFACES):
        return top
    if not rest and {"msg", "srv", "action"} & set(names):
        return top
    return top if of_workspace(top) else None


class Table(msgspec.Struct):
    """The packages that rosdistro names: all their ``names``, and what those ``brings`` lists bring along when they
    are installed, each package's own needs only.  One that has no list may bring anything."""

    names: frozenset[str]
    brings: dict[str, list[str]]
    ended: frozenset[str]
    """The packages of distributions of ROS 2 that have ended, as far as none that is maintained has them."""


@cache
def table() -> Table:
    """The table that ``scripts/generate_packages`` writes, read once."""
    return msgspec.json.decode(FILE.read_bytes(), type=Table)


@cache
def released_names() -> frozenset[str]:
    """The names of all packages that were ever released, for ROS 1 and for distributions that have ended, too:
    ``scripts/generate_released_names`` writes them.  Whether rosdep knows one today, :func:`table` says."""
    return msgspec.json.decode(RELEASED.read_bytes(), type=frozenset[str]) | table().names
