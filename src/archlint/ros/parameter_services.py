"""The services by which every node lets others read and set its parameters.

Source: rclpy, ``parameter_service.py``.
"""

from __future__ import annotations

from typing import Final

PARAMETER_SERVICES: Final = (
    ("describe_parameters", "rcl_interfaces/srv/DescribeParameters"),
    ("get_parameter_types", "rcl_interfaces/srv/GetParameterTypes"),
    ("get_parameters", "rcl_interfaces/srv/GetParameters"),
    ("list_parameters", "rcl_interfaces/srv/ListParameters"),
    ("set_parameters", "rcl_interfaces/srv/SetParameters"),
    ("set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically"),
)
"""The name of each, below that of the node, and its type."""
