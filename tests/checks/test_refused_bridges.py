"""LCH013: arguments of the bridge between ROS and Gazebo."""

from __future__ import annotations

import pytest

from archlint.ros.bridged_types import pairs


def _told(findings, *words: str, package: str = "ros_gz_bridge", **files: str):
    args = " ".join(words)
    return findings("LCH013", f'<node pkg="{package}" exec="parameter_bridge" args="{args}"/>', **files)


@pytest.mark.parametrize(
    ("word", "wrong", "help"),
    [
        (
            "/scan@gz.msgs.LaserScan[sensor_msgs/msg/LaserScan",
            "the type of ROS comes first, then that of Gazebo: nothing is bridged there",
            "write '/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan'",
        ),
        (
            "/scan@sensor_msgs/LaserScan[gz.msgs.LaserScan",
            "the bridge knows no type 'sensor_msgs/LaserScan': nothing is bridged there",
            "write '/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan'",
        ),
        (
            "/imu@sensor_msgs/msg/IMU[ignition.msgs.IMU",
            "the bridge knows no type 'sensor_msgs/msg/IMU': nothing is bridged there",
            "write '/imu@sensor_msgs/msg/Imu[ignition.msgs.IMU'",
        ),
        (
            "/odom@nav_msgs/msg/Odometry[gz.msgs.Odomety",
            "the bridge does not know 'nav_msgs/msg/Odometry' and 'Odomety' as each other: nothing is bridged there",
            "write '/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry'",
        ),
        (
            "/points@sensor_msgs/msg/PointCloud2[gz.msgs.LaserScan",
            "the bridge does not know 'sensor_msgs/msg/PointCloud2' and 'LaserScan' as each other: nothing is bridged "
            "there",
            "write '/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked'",
        ),
        (
            "/clock",
            "it names no types: the bridge prints how it is used, and ends",
            "write topic@type/of/ROS[type.of.Gazebo",
        ),
    ],
)
def test_an_argument_that_bridges_nothing(findings, word: str, wrong: str, help: str):
    (told,) = _told(findings, word, "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock")
    assert (told.message, told.help) == (f"'{word}' is no bridge, for {wrong}", help)


@pytest.mark.parametrize(
    "word",
    [
        "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
        "/cmd_vel@geometry_msgs/msg/Twist]ignition.msgs.Twist",
        "/cmd_vel@geometry_msgs/msg/Twist@gz.msgs.Twist",
        "/odom@nav_msgs/msg/Odometry@gz.msgs.Odometry@/model/robot/odometry",
        "/world/w/control@ros_gz_interfaces/srv/ControlWorld",
        "/world/w/set_pose@ros_gz_interfaces/srv/SetEntityPose@gz.msgs.Pose@gz.msgs.Boolean",
        "/range@sensor_msgs/msg/Range[gz.msgs.Sonar",  # a later version may know both
        "/team@team_msgs/msg/Thing[gz.msgs.Pose",
        "/$(env TOPIC)@gz.msgs.Pose[geometry_msgs/msg/Pose",
        "--ros-args -r /clock:=/sim/clock -p lazy:=true",
    ],
)
def test_an_argument_that_the_bridge_understands_or_may(findings, word: str):
    assert _told(findings, word) == []


def test_another_program_has_other_arguments(findings):
    assert _told(findings, "/clock", package="team_bridge") == []


def test_foxy_wrote_types_otherwise(findings):
    word = "/scan@sensor_msgs/LaserScan[ignition.msgs.LaserScan"
    assert len(_told(findings, word, package="ros_ign_bridge")) == 1
    assert _told(findings, word, package="ros_ign_bridge", **{"README.md": "For ROS 2 Foxy."}) == []


def test_the_table_has_each_type_of_ros_as_it_is_written():
    assert pairs()["nav_msgs/msg/Odometry"] == {"Odometry", "OdometryWithCovariance"}
    assert all(name.count("/") == 2 for name in pairs())
