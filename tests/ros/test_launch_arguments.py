"""What launch files of well-known packages take, held against what their documentation says."""

from __future__ import annotations

import pytest

from archlint.ros.launch_arguments import well_known


@pytest.mark.parametrize(
    ("package", "file", "takes", "not_taken"),
    [
        ("slam_toolbox", "online_async_launch.py", "slam_params_file", "params_file"),
        ("nav2_bringup", "navigation_launch.py", "params_file", "map_yaml_file"),
        ("nav2_bringup", "bringup_launch.py", "map", "map_file"),
        ("gazebo_ros", "gzserver.launch.py", "world", "gui"),
        ("gazebo_ros", "gazebo.launch.py", "gui", "headless"),
        ("realsense2_camera", "rs_launch.py", "align_depth.enable", "align_depth"),
    ],
)
def test_an_argument_of_a_launch_file(package: str, file: str, takes: str, not_taken: str):
    names = well_known().packages[package][file] or ()
    assert takes in names
    assert not_taken not in names


def test_a_file_that_includes_others_from_elsewhere_is_not_known():
    assert well_known().packages["turtlebot3_bringup"]["robot.launch.py"] is None
