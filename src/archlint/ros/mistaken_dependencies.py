"""Names in a package.xml that rosdep does not find for ROS 2, of which it is known what they are.

Source: ``rosdep/python.yaml`` of rosdistro names Debian's ``python-…`` packages for the keys of that form, and there is
none of these from Ubuntu 22.04 on; the packages of ROS 1 by ``noetic/distribution.yaml``.
"""

from __future__ import annotations

import enum
import re
import sys
from collections.abc import Collection, Mapping

from archlint.records import dataclass
from archlint.ros import rosdep
from archlint.ros.python_modules import key_of


class Mistake(enum.Enum):
    """What a name is that rosdep does not find."""

    OF_ROS_1 = "a package of ROS 1"
    OF_PYTHON_2 = "the key of a package for Python 2"
    OF_PYTHON = "a module of Python itself"
    NO_NAME = "no name of a package"
    """One that no package of ROS may have: ``sensor_msgs.msg``, ``python3-keras``."""
    NOT_FILLED_IN = "an address, or a word that stands for a name"
    BY_ANOTHER_NAME = "what rosdep has under another name"


@dataclass(frozen=True)
class Mistaken:
    """What a name is, and the package or key to write; empty where there is none."""

    mistake: Mistake
    instead: str = ""


_OF_ROS_1: Mapping[str, str] = {
    "actionlib": "rclcpp_action",
    "amcl": "nav2_amcl",
    "base_local_planner": "",
    "carrot_planner": "",
    "catkin": "ament_cmake",
    "clear_costmap_recovery": "",
    "cmake_modules": "",
    "combined_robot_hw": "",
    "costmap_2d": "nav2_costmap_2d",
    "dwa_local_planner": "",
    "dynamic_reconfigure": "",
    "eigen_conversions": "tf2_eigen",
    "fake_localization": "",
    "gazebo_ros_control": "gazebo_ros2_control",
    "map_server": "nav2_map_server",
    "message_generation": "rosidl_default_generators",
    "message_runtime": "rosidl_default_runtime",
    "move_base": "",
    "move_base_msgs": "nav2_msgs",
    "move_slow_and_clear": "",
    "nav_core": "nav2_core",
    "nodelet": "rclcpp_components",
    "nodelet_topic_tools": "",
    "ros_control": "ros2_control",
    "rosbag_storage": "rosbag2_storage",
    "rosbash": "",
    "rosconsole": "",
    "roscpp": "rclcpp",
    "roscpp_serialization": "",
    "roscpp_tutorials": "",
    "rosgraph": "",
    "roslaunch": "launch_ros",
    "roslib": "",
    "roslint": "",
    "rosmaster": "",
    "rosmsg": "",
    "rosnode": "",
    "rosparam": "",
    "rospy": "rclpy",
    "rospy_tutorials": "",
    "rosservice": "",
    "rostest": "launch_testing",
    "rostime": "",
    "rostopic": "",
    "rosunit": "",
    "roswtf": "",
    "rotate_recovery": "",
    "tf": "tf2_ros",
    "tf_conversions": "tf2_geometry_msgs",
}
"""Packages that only ROS 1 has, with what took their place in ROS 2."""

_SPELLINGS: Mapping[str, str] = {
    "beautifulsoup4": "python3-bs4",
    "ceres": "libceres-dev",
    "ceres-solver": "libceres-dev",
    "cv2": "python3-opencv",
    "eigen3": "eigen",
    "gflags": "libgflags-dev",
    "glfw": "libglfw3-dev",
    "glfw3": "libglfw3-dev",
    "glog": "libgoogle-glog-dev",
    "jsoncpp": "libjsoncpp-dev",
    "libserial": "libserial-dev",
    "libudev": "libudev-dev",
    "nlohmann-json": "nlohmann-json-dev",
    "nlohmann_json": "nlohmann-json-dev",
    "opencv-contrib-python": "python3-opencv",
    "opencv-python": "python3-opencv",
    "opencv-python-headless": "python3-opencv",
    "pcl": "libpcl-all-dev",
    "pillow": "python3-pil",
    "pyserial": "python3-serial",
    "pytest": "python3-pytest",
    "pyusb": "python3-usb",
    "pyyaml": "python3-yaml",
    "pyzmq": "python3-zmq",
    "qt5": "qtbase5-dev",
    "rclpy_action": "rclpy",
    "rmw_zenoh": "rmw_zenoh_cpp",
    "rpi.gpio": "python-rpi.gpio-pip",
    "scikit-image": "python3-skimage",
    "scikit-learn": "python3-sklearn",
    "static_transform_publisher": "tf2_ros",
    "tkinter": "python3-tk",
    "yamlcpp": "yaml-cpp",
}
"""Names of pip, of CMake and of modules, in lower case, with the package of ROS or the key that is meant."""
_OF_PIP_ALONE = frozenset(
    {
        "bluepy",
        "brping",
        "dronekit",
        "h3",
        "keras",
        "mavsdk",
        "pyquaternion",
        "pyttsx3",
        "stable_baselines3",
        "tensorflow",
    }
    | {"vosk", "webrtcvad"}
)
"""Packages of pip for which rosdep has no key, by the name of their module."""
_NAME = re.compile(r"[A-Za-z0-9][\w.+-]*")
_TO_FILL = frozenset({"FIXME", "TBD", "TODO", "XXX"})
_OPENCV = re.compile(r"opencv[234]?", re.IGNORECASE)
_DISTROS = "foxy|galactic|humble|iron|jazzy|kilted|lyrical|rolling"
_DEBIAN_OF_ROS = re.compile(rf"ros(?:-[a-z]+-|_(?:{_DISTROS})_)([a-z0-9_-]+)")
_NEVER_OF_ROS = re.compile(r"python3?-.+|lib.+-dev|gir1\.2-.+")
"""How names of Debian look that nobody gives to a package of ROS."""


def mistaken(name: str, packages: Collection[str], *, is_python: bool) -> Mistaken | None:
    """What an unknown name is; None where it may be somebody's package.

    ``packages`` are the known ones, ``is_python`` says whether a module of Python may be meant."""
    if name in _OF_ROS_1:
        return Mistaken(Mistake.OF_ROS_1, _OF_ROS_1[name])
    if _NAME.fullmatch(name) is None or name in _TO_FILL:
        return Mistaken(Mistake.NOT_FILLED_IN)
    instead = _by_another_name(name, packages, is_python=is_python)
    if instead is not None:
        return Mistaken(Mistake.BY_ANOTHER_NAME, instead)
    if is_python and name in sys.stdlib_module_names:
        return Mistaken(Mistake.OF_PYTHON)
    if is_python and name in _OF_PIP_ALONE:
        return Mistaken(Mistake.NO_NAME)
    head, dot, _ = name.partition(".")
    if dot and head in packages:
        return Mistaken(Mistake.NO_NAME, head)
    return Mistaken(Mistake.NO_NAME) if _NEVER_OF_ROS.fullmatch(name) else None


def _by_another_name(name: str, packages: Collection[str], *, is_python: bool) -> str | None:
    if _OPENCV.fullmatch(name):
        return "python3-opencv" if is_python else "libopencv-dev"
    debian = _DEBIAN_OF_ROS.fullmatch(name)
    if debian is not None and debian[1].replace("-", "_") in packages:
        return debian[1].replace("-", "_")
    key, plain = rosdep.key_of_debian(name), re.sub(r"^python3?-", "", name)
    written = _SPELLINGS.get(name.lower()) or _SPELLINGS.get(plain.lower())
    return key or written or (key_of(name) or key_of(plain) if is_python else None)


def modules_of_pip(name: str) -> set[str]:
    """What the module of a package of pip may be called: ``usb`` of ``pyusb``, ``simple_pid`` of ``simple-pid``."""
    plain = re.sub(r"^python3?-|-python$", "", name.lower())
    return {name, plain.replace("-", "_"), *({plain[2:]} if re.fullmatch(r"py[a-z0-9]{3,}", plain) else ())}


def of_python_2(key: str) -> Mistaken | None:
    """What a key of rosdep is whose package went with Python 2; None for any other one."""
    plain, known = key.removeprefix("python-"), rosdep.keys()
    newer = f"python3-{plain}"
    if plain == key or plain.endswith("-pip") or newer not in known:
        return None
    return Mistaken(Mistake.OF_PYTHON_2, newer)


__all__ = ["Mistake", "Mistaken", "mistaken", "modules_of_pip", "of_python_2"]
