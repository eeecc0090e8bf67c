"""QOS001 and QOS002 of subscriptions to what PX4 and MAVROS publish."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from robot_package import node

PILOT = """\
import rclpy
from geometry_msgs.msg import PoseStamped
from px4_msgs.msg import VehicleStatus
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
from sensor_msgs.msg import Imu

BEST_EFFORT = QoSProfile(
    depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL
)


class Pilot(Node):
    def __init__(self):
        super().__init__('pilot')
        {}

    def on_message(self, message):
        self.get_logger().info(f'{{message}}')


def main():
    rclpy.init()
    rclpy.spin(Pilot())
"""
SUBSCRIBE = "self.create_subscription({}, self.on_message, {})"


def _told(findings, code: str, *lines: str, launch: str = ""):
    return findings(code, launch or node(), **{"robot/talker.py": PILOT.format("\n        ".join(lines))})


@pytest.mark.parametrize(
    ("code", "end", "profile", "message"),
    [
        (
            "QOS001",
            "VehicleStatus, '/fmu/out/vehicle_status'",
            "10",
            "/pilot requests reliable on '/fmu/out/vehicle_status', but PX4 offers best effort: no message arrives",
        ),
        (
            "QOS001",
            "VehicleStatus, '/px4_1/fmu/out/vehicle_status_v1'",
            "10",
            "/pilot requests reliable on '/px4_1/fmu/out/vehicle_status_v1', but PX4 offers best effort: no message "
            "arrives",
        ),
        (
            "QOS001",
            "PoseStamped, 'mavros/local_position/pose'",
            "10",
            "/pilot requests reliable on '/mavros/local_position/pose', but MAVROS offers best effort: no message "
            "arrives",
        ),
        (
            "QOS002",
            "Imu, '/mavros/imu/data'",
            "BEST_EFFORT",
            "/pilot requests transient local on '/mavros/imu/data', but MAVROS offers volatile: no message arrives",
        ),
    ],
)
def test_a_profile_that_the_flight_controller_does_not_serve(findings, code: str, end: str, profile: str, message: str):
    (told,) = _told(findings, code, SUBSCRIBE.format(end, profile))
    assert (told.message, told.severity) == (message, Severity.WARNING)


@pytest.mark.parametrize(
    ("end", "profile"),
    [
        ("VehicleStatus, '/fmu/out/vehicle_status'", "qos_profile_sensor_data"),
        ("VehicleStatus, '/fmu/out/vehicle_status'", "BEST_EFFORT"),  # PX4 keeps the last message
        ("VehicleStatus, '/status'", "10"),  # a node here may send it on
        ("PoseStamped, '/fmu/out/pose'", "10"),
        ("Imu, '/mavros/imu/data'", "qos_profile_sensor_data"),
        ("PoseStamped, '/mavros/imu/data'", "10"),
        ("PoseStamped, '/mavros/home_position/home'", "10"),
    ],
)
def test_a_profile_that_fits_or_a_topic_of_somebody_else(findings, end: str, profile: str):
    line = SUBSCRIBE.format(end, profile)
    assert _told(findings, "QOS001", line) + _told(findings, "QOS002", line) == []


def test_a_topic_that_a_node_of_the_workspace_publishes_too(findings):
    line = SUBSCRIBE.format("Imu, '/mavros/imu/data'", "10")
    assert _told(findings, "QOS001", line, "self.create_publisher(Imu, '/mavros/imu/data', 10)") == []
    assert _told(findings, "QOS001", line, "self.create_publisher(Imu, input(), 10)") == []
    assert len(_told(findings, "QOS001", line, "self.create_publisher(Imu, '/imu', 10)")) == 1


def test_a_topic_that_a_launch_file_gives_another_name(findings):
    line = SUBSCRIBE.format("Imu, 'imu'", "10")
    (told,) = _told(findings, "QOS001", line, launch=node('<remap from="imu" to="/mavros/imu/data"/>'))
    assert "'/mavros/imu/data'" in told.message
    assert _told(findings, "QOS001", line) == []


def test_the_subscriptions_of_a_file_are_one_finding(findings):
    topics = ("Imu, '/mavros/imu/data'", "Imu, '/mavros/imu/data_raw'", "PoseStamped, '/mavros/local_position/pose'")
    (told,) = _told(findings, "QOS001", *(SUBSCRIBE.format(topic, 10) for topic in topics))
    assert told.message == (
        "/pilot requests reliable on '/mavros/imu/data' and 2 more topics, but MAVROS offers best effort: no message "
        "arrives"
    )
    assert [row.message for row in told.related] == [
        "'/mavros/imu/data_raw' is one of them",
        "'/mavros/local_position/pose' is one of them",
    ]
