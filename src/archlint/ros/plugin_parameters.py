"""The types of the parameters that well-known plugins and nodes declare: those of Nav2 and of ros2_controllers.

The table is what ``scripts/generate_plugin_parameters`` reads in their sources, all branches since humble: a parameter
stands in it if it has one type in all of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

import msgspec

from archlint.ros.parameter_types import ParameterType

FILE = Path(__file__).with_suffix(".json")

Types = Mapping[str, ParameterType]
"""The type of each parameter by its name, in which ``*`` stands for a word that the user chooses."""


class PluginParameters(msgspec.Struct, frozen=True):
    """The table: plugins by their class, nodes by the names that the launch files of Nav2 give them."""

    plugins: Mapping[str, Types]
    nodes: Mapping[str, Types]


@cache
def well_known() -> PluginParameters:
    """Read the table, once."""
    return msgspec.json.decode(FILE.read_bytes(), type=PluginParameters)


def spelt(plugin: str) -> str:
    """A class in one spelling: ``nav2_navfn_planner/NavfnPlanner`` is how older files name it."""
    return plugin.replace("/", "::")


def type_in(types: Types, name: str) -> ParameterType | None:
    """The type of a parameter; None where the table does not have it."""
    if name in types:
        return types[name]
    words = name.split(".")
    for pattern, kind in types.items():
        parts = pattern.split(".")
        if len(parts) == len(words) and all(part in ("*", word) for part, word in zip(parts, words, strict=True)):
            return kind
    return None


__all__ = ["FILE", "PluginParameters", "Types", "spelt", "type_in", "well_known"]
