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


FILE = """\
- ros_topic_name: scan
  gz_topic_name: /lidar
  ros_type_name: {ros}
  gz_type_name: {gz}
{rest}
- topic_name: clock
  ros_type_name: rosgraph_msgs/msg/Clock
  gz_type_name: gz.msgs.Clock
"""
BRIDGE = (
    '<node pkg="ros_gz_bridge" exec="parameter_bridge">'
    '<param name="config_file" value="$(find-pkg-share robot)/config/bridge.yaml"/></node>'
)


def _told_of_file(findings, ros: str, gz: str, rest: str = ""):
    return findings("LCH013", BRIDGE, **{"config/bridge.yaml": FILE.format(ros=ros, gz=gz, rest=rest)})


@pytest.mark.parametrize(
    ("ros", "gz", "rest", "line", "wrong", "help"),
    [
        (
            "sensor_msgs/msg/LaserScan",
            "gz.msgs.LaserScan",
            "  direction: GZ_TO_ROSS",
            5,
            "'GZ_TO_ROSS' is no direction",
            "write GZ_TO_ROS",
        ),
        ("sensor_msgs/msg/LaserScan", "''", "", 1, "it has no gz_type_name", "add gz_type_name to this entry"),
        (
            "sensor_msgs/msg/LaserScan",
            "gz.msgs.Image",
            "",
            4,
            "the bridge does not know 'sensor_msgs/msg/LaserScan' and 'Image' as each other",
            "write 'gz_type_name: gz.msgs.LaserScan'",
        ),
        (
            "sensor_msgs/LaserScan",
            "ignition.msgs.LaserScan",
            "",
            3,
            "the bridge knows no type 'sensor_msgs/LaserScan'",
            "write 'ros_type_name: sensor_msgs/msg/LaserScan'",
        ),
    ],
)
def test_an_entry_that_bridges_nothing(findings, ros, gz, rest, line, wrong, help):
    (told,) = _told_of_file(findings, ros, gz, rest)
    assert (told.place.file, told.place.line) == ("config/bridge.yaml", line)
    assert told.message == f"'scan' is no bridge, for {wrong}: nothing is bridged there"
    assert told.help == help


@pytest.mark.parametrize(
    ("ros", "gz", "rest"),
    [
        ("sensor_msgs/msg/LaserScan", "gz.msgs.LaserScan", ""),
        ("sensor_msgs/msg/LaserScan", "gz.msgs.LaserScan", "  direction: BIDIRECTIONAL\n  lazy: true"),
        ("my_msgs/msg/Scan", "gz.msgs.Scan", ""),  # a bridge of the team's own may know them
    ],
)
def test_an_entry_that_is_a_bridge(findings, ros, gz, rest):
    assert _told_of_file(findings, ros, gz, rest) == []


def test_entries_of_the_bridge_of_ignition_and_of_services(findings):
    text = (
        "- ros_topic_name: a\n  ros_type_name: std_msgs/msg/Bool\n"
        "  ign_type_name: ignition.msgs.Boolean\n  direction: IGN_TO_ROS\n"
        "- service_name: b\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld\n"
        "- c\n"
    )
    assert findings("LCH013", BRIDGE, **{"config/bridge.yaml": text}) == []
