"""QoS profiles, as they should be and as they should not."""

from __future__ import annotations

import rclpy
from rclpy.node import Node
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    QoSPresetProfiles,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_sensor_data,
    qos_profile_system_default,
)
from std_msgs.msg import Empty
from std_srvs.srv import Trigger


def assigned(**policies):
    profile = QoSProfile(depth=1)
    for name, value in policies.items():
        setattr(profile, name, value)
    return profile


PROFILES = [
    lambda: QoSProfile(depth=3),
    lambda: QoSProfile(**{}),
    lambda: QoSProfile(history=HistoryPolicy.KEEP_LAST),
    lambda: QoSProfile(history=HistoryPolicy.KEEP_ALL),
    lambda: QoSProfile(history=HistoryPolicy.KEEP_ALL, depth=2),
    lambda: QoSProfile(history=HistoryPolicy.SYSTEM_DEFAULT),
    lambda: QoSProfile(history=1, depth=2, reliability=2, durability=1),
    lambda: QoSProfile(10),
    lambda: QoSProfile(depth="10"),
    lambda: QoSProfile(depth=10.0),
    lambda: QoSProfile(depth=0),
    lambda: QoSProfile(depth=-1),
    lambda: QoSProfile(depth=True),
    lambda: QoSProfile(depth=1, reliability="reliable"),
    lambda: QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL),
    lambda: QoSProfile(depth=1, reliability=DurabilityPolicy.VOLATILE),
    lambda: QoSProfile(depth=1, reliability=99),
    lambda: QoSProfile(depth=1, unheard_of=1),
    lambda: QoSProfile(depth=1, deadline=1.0),
    lambda: QoSProfile(depth=1, reliability=ReliabilityPolicy.SYSTEM_DEFAULT),
    lambda: QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_AVAILABLE),
    lambda: QoSProfile(depth=1, durability=DurabilityPolicy.BEST_AVAILABLE),
    lambda: QoSProfile(depth=1, reliability=ReliabilityPolicy.UNKNOWN),
    lambda: qos_profile_sensor_data,
    lambda: qos_profile_system_default,
    lambda: QoSPresetProfiles.SENSOR_DATA.value,
    lambda: QoSPresetProfiles.SYSTEM_DEFAULT.value,
    lambda: QoSPresetProfiles.PARAMETER_EVENTS.value,
    lambda: QoSPresetProfiles.SERVICES_DEFAULT.value,
    lambda: QoSPresetProfiles.ACTION_STATUS_DEFAULT.value,
    lambda: QoSPresetProfiles.BEST_AVAILABLE.value,
    lambda: QoSPresetProfiles.get_from_short_key("sensor_data"),
    lambda: QoSPresetProfiles.SENSOR_DATA,
    lambda: assigned(depth=7),
    lambda: assigned(reliability=ReliabilityPolicy.BEST_EFFORT),
    lambda: assigned(durability=1),
    lambda: assigned(depth="7"),
    lambda: ReliabilityPolicy.BEST_EFFORT,
    lambda: ReliabilityPolicy.get_from_short_key("best_effort"),
]


def main():
    rclpy.init()
    node = Node("profiles")
    for number, profile in enumerate(PROFILES):
        for create in (
            lambda name, qos: node.create_publisher(Empty, name, qos),
            lambda name, qos: node.create_subscription(Empty, name, print, qos),
            lambda name, qos: node.create_client(Trigger, name, qos_profile=qos),
            lambda name, qos: node.create_service(Trigger, name, print, qos_profile=qos),
        ):
            try:
                create(f"profile_{number}", profile())
            except Exception as error:
                node.create_publisher(Empty, f"profile_{number}/{type(error).__name__}", 1)


if __name__ == "__main__":
    main()
