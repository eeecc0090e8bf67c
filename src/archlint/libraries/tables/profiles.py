"""Rows of what a create call is given: quality of service, durations, interfaces by name."""

from __future__ import annotations

from archlint.libraries.tables.api import Api

ROWS = (
    # ---- quality of service
    Api(
        "rclpy.qos.QoSProfile",
        "history depth reliability durability lifespan deadline liveliness liveliness_lease_duration "
        "avoid_ros_namespace_conventions",
        effect="qos_profile",
    ),
    Api("rclpy.qos.QoSPresetProfiles.get_from_short_key", "name", effect="qos_preset"),
    Api("rclpy.duration.Duration", "* seconds nanoseconds", effect="duration"),
    # ---- interfaces by name
    Api("rosidl_runtime_py.utilities.get_message", "identifier", effect="get_interface", makes="msg"),
    Api("rosidl_runtime_py.utilities.get_service", "identifier", effect="get_interface", makes="srv"),
    Api("rosidl_runtime_py.utilities.get_action", "identifier", effect="get_interface", makes="action"),
    Api("rosidl_runtime_py.utilities.get_interface", "identifier", effect="get_interface", makes="any"),
    Api("rosidl_runtime_py.get_interface", "identifier", effect="get_interface", makes="any"),
)

__all__ = ["ROWS"]
