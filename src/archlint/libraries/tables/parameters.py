"""Rows of parameters."""

from __future__ import annotations

from archlint.libraries.tables.api import Api

ROWS = (
    Api(
        "rclpy.node.Node.declare_parameter",
        "name value descriptor ignore_override",
        effect="declare_parameter",
    ),
    Api(
        "rclpy.node.Node.declare_parameters",
        "namespace parameters ignore_override",
        effect="declare_parameters",
    ),
    Api("rclpy.node.Node.get_parameter", "name", effect="get_parameter", watched=True),
    Api("rclpy.node.Node.get_parameters", "names", effect="get_parameters", watched=True),
    Api("rclpy.node.Node.get_parameter_or", "name alternative_value", effect="get_parameter_or", watched=True),
    Api("rclpy.node.Node.get_parameters_by_prefix", "prefix", effect="get_parameters_by_prefix"),
    Api("rclpy.node.Node.has_parameter", "name", effect="has_parameter", watched=True),
    Api("rclpy.node.Node.undeclare_parameter", "name", watched=True),
    Api("rclpy.node.Node.set_parameters", "parameter_list", effect="set_parameters", watched=True),
    Api("rclpy.node.Node.set_parameters_atomically", "parameter_list", effect="set_parameters", watched=True),
    Api("rclpy.parameter.Parameter", "name type_ value", effect="parameter"),
)

__all__ = ["ROWS"]
