"""Names in a package.xml that rosdep does not find for ROS 2."""

from __future__ import annotations

import pytest

from archlint.ros import rosdep
from archlint.ros.mistaken_dependencies import Mistake, Mistaken, mistaken, of_python_2

KNOWN = frozenset({"rclpy", "sensor_msgs", "nav2_msgs"})


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("rospy", Mistaken(Mistake.OF_ROS_1, "rclpy")),
        ("rosbash", Mistaken(Mistake.OF_ROS_1)),
        ("ros-humble-sensor-msgs", Mistaken(Mistake.BY_ANOTHER_NAME, "sensor_msgs")),
        ("PyYAML", Mistaken(Mistake.BY_ANOTHER_NAME, "python3-yaml")),
        ("OpenCV", Mistaken(Mistake.BY_ANOTHER_NAME, "libopencv-dev")),
        ("sensor_msgs.msg", Mistaken(Mistake.NO_NAME, "sensor_msgs")),
        ("libgripper-dev", Mistaken(Mistake.NO_NAME)),
        ("gripper_msgs", None),
        ("ros-humble-gripper", None),
        ("statistics", None),
    ],
)
def test_what_a_name_is(name: str, expected: Mistaken | None) -> None:
    assert mistaken(name, KNOWN, is_python=False) == expected


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("opencv", Mistaken(Mistake.BY_ANOTHER_NAME, "python3-opencv")),
        ("statistics", Mistaken(Mistake.OF_PYTHON)),
        ("serial", Mistaken(Mistake.BY_ANOTHER_NAME, "python3-serial")),
    ],
)
def test_what_a_name_is_that_python_code_has(name: str, expected: Mistaken) -> None:
    assert mistaken(name, KNOWN, is_python=True) == expected


@pytest.mark.parametrize("name", ["python-numpy", "python-opencv"])
def test_a_key_that_went_with_python_2(name: str) -> None:
    assert of_python_2(name) == Mistaken(Mistake.OF_PYTHON_2, name.replace("python", "python3"))


@pytest.mark.parametrize("name", ["python3-numpy", "python-rpi.gpio-pip", "python-unheard-of", "numpy"])
def test_a_key_that_did_not(name: str) -> None:
    assert of_python_2(name) is None


def test_what_is_to_be_written_instead_is_known_to_rosdep() -> None:
    names = ("eigen3", "pcl", "glfw", "jsoncpp", "ceres", "pillow", "scikit-learn", "beautifulsoup4", "pytest", "cv2")
    instead = [answer.instead for name in names if (answer := mistaken(name, KNOWN, is_python=False)) is not None]
    assert len(instead) == len(names)
    assert rosdep.keys().issuperset(instead)
