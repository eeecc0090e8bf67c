"""What Python's own library, rclpy and its kin offer, all together."""

from __future__ import annotations

from archlint.libraries import tables
from archlint.libraries.api_use import Offers
from archlint.libraries.python import argument_parsers, command_line, effects
from archlint.libraries.rclcpp import (
    collections,
    filled,
    filters,
    macros,
    node_options,
    parameter_libraries,
    profiles,
    sub_nodes,
    transports,
)
from archlint.libraries.rclpy import clocks
from archlint.libraries.rclpy.effects import EFFECTS
from archlint.libraries.setuptools import setup_run

OFFERS = Offers(
    tables.find,
    {**EFFECTS, **effects.EFFECTS},
    {**argument_parsers.METHODS, **clocks.METHODS}
    | {**profiles.METHODS, **transports.METHODS, **node_options.METHODS, **filters.METHODS, **sub_nodes.METHODS}
    | parameter_libraries.METHODS,
    {**effects.PLAIN, **setup_run.PLAIN, **command_line.PLAIN}
    | {**profiles.PLAIN, **transports.PLAIN, **node_options.PLAIN, **filters.PLAIN, **collections.PLAIN}
    | {**filled.PLAIN, **macros.PLAIN, **parameter_libraries.PLAIN},
    frozenset({"endpoint"}),
)

__all__ = ["OFFERS"]
