"""The robot of ``fixtures/lesson`` as a system: what sensor, control and motor say to each other."""

from __future__ import annotations

from archlint.systems.model import System
from systems.builders import client, node, parameter, publisher, service, subscriber, system, timer

READING = "my_robot_interfaces/msg/SensorReading"
GET_DATA = "my_robot_interfaces/srv/GetSensorData"
SET_SPEED = "my_robot_interfaces/srv/SetMotorSpeed"


def lesson() -> System:
    package = "my_first_package"
    return system(
        node(
            "/control_node",
            subscriber("sensor_data", READING, callback="sensor_callback"),
            client("query_sensor", GET_DATA),
            client("set_motor", SET_SPEED),
            timer(2.0, callback="control_loop"),
            package=package,
        ),
        node("/motor_node", service("set_motor", SET_SPEED, callback="motor_callback"), package=package),
        node(
            "/sensor_node",
            publisher("sensor_data", READING),
            service("query_sensor", GET_DATA, callback="query_callback"),
            timer(1.0, callback="publish_sensor"),
            parameter("rate", 1.0, "double"),
            package=package,
        ),
    )
