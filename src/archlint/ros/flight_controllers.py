"""What flight controllers publish, which run outside of every workspace: PX4, and MAVROS, which stands for one.

Sources: PX4 v1.14 and later, ``src/modules/uxrce_dds_client/utilities.hpp`` (``create_data_writer``): each topic
``fmu/out/…`` is best effort and transient local; MAVROS 2, ``mavros/src/plugins/*.cpp``: what is created with
``SensorDataQoS``.
"""

from __future__ import annotations

import re
from typing import Final

from archlint.records import dataclass
from archlint.ros.qos import SENSOR_DATA, Qos


@dataclass(frozen=True)
class FlightController:
    """Who publishes a topic, and with which profile."""

    name: str
    qos: Qos


_PX4: Final = FlightController("PX4", Qos(depth=1, reliability="best_effort", durability="transient_local"))
_MAVROS: Final = FlightController("MAVROS", SENSOR_DATA)
_OF_PX4 = re.compile(r"(?:/[\w/]+)?/fmu/out/\w+")
_OF_MAVROS = re.compile(r"(?:/[\w/]+)?/mavros/(?P<topic>\w+(?:/\w+)*)")

_SENSOR_DATA = {
    "altitude": "mavros_msgs/msg/Altitude",
    "battery": "sensor_msgs/msg/BatteryState",
    "global_position/compass_hdg": "std_msgs/msg/Float64",
    "global_position/global": "sensor_msgs/msg/NavSatFix",
    "global_position/gp_lp_offset": "geometry_msgs/msg/PoseStamped",
    "global_position/local": "nav_msgs/msg/Odometry",
    "global_position/raw/fix": "sensor_msgs/msg/NavSatFix",
    "global_position/raw/gps_vel": "geometry_msgs/msg/TwistStamped",
    "global_position/raw/satellites": "std_msgs/msg/UInt32",
    "global_position/rel_alt": "std_msgs/msg/Float64",
    "imu/data": "sensor_msgs/msg/Imu",
    "imu/data_raw": "sensor_msgs/msg/Imu",
    "imu/diff_pressure": "sensor_msgs/msg/FluidPressure",
    "imu/mag": "sensor_msgs/msg/MagneticField",
    "imu/static_pressure": "sensor_msgs/msg/FluidPressure",
    "imu/temperature_baro": "sensor_msgs/msg/Temperature",
    "imu/temperature_imu": "sensor_msgs/msg/Temperature",
    "local_position/accel": "geometry_msgs/msg/AccelWithCovarianceStamped",
    "local_position/odom": "nav_msgs/msg/Odometry",
    "local_position/pose": "geometry_msgs/msg/PoseStamped",
    "local_position/pose_cov": "geometry_msgs/msg/PoseWithCovarianceStamped",
    "local_position/velocity_body": "geometry_msgs/msg/TwistStamped",
    "local_position/velocity_body_cov": "geometry_msgs/msg/TwistWithCovarianceStamped",
    "local_position/velocity_local": "geometry_msgs/msg/TwistStamped",
    "setpoint_raw/target_attitude": "mavros_msgs/msg/AttitudeTarget",
    "setpoint_raw/target_global": "mavros_msgs/msg/GlobalPositionTarget",
    "setpoint_raw/target_local": "mavros_msgs/msg/PositionTarget",
    "status_event": "mavros_msgs/msg/StatusEvent",
    "statustext/recv": "mavros_msgs/msg/StatusText",
    "time_reference": "sensor_msgs/msg/TimeReference",
    "timesync_status": "mavros_msgs/msg/TimesyncStatus",
    "wind_estimation": "geometry_msgs/msg/TwistWithCovarianceStamped",
}


def publisher_of(topic: str, type_name: str) -> FlightController | None:
    """Who publishes a topic of a type, by the name that it has by default, in whichever namespace."""
    if type_name.startswith("px4_msgs/msg/"):
        return _PX4 if _OF_PX4.fullmatch(topic) else None
    match = _OF_MAVROS.fullmatch(topic)
    return _MAVROS if match is not None and _SENSOR_DATA.get(match["topic"]) == type_name else None


__all__ = ["FlightController", "publisher_of"]
