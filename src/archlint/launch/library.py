"""Launch among the libraries: what a run learns where code uses its API, wherever that is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Value
from archlint.launch import calls, tables
from archlint.launch.objects import LaunchObject, argument, kind_of
from archlint.libraries.api_use import Offers
from archlint.libraries.library import RosLibrary
from archlint.libraries.rclpy import names

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.values import ClassValue
    from archlint.libraries.tables import Api


_ROS = RosLibrary.offers
_NODES = frozenset(
    {
        tables.LaunchClass.NODE,
        tables.LaunchClass.LIFECYCLE_NODE,
        tables.LaunchClass.COMPOSABLE_NODE_CONTAINER,
    }
)
_KEPT_BY_NODES = {
    "_Node__package": "package",
    "_Node__node_executable": "executable",
    "_Node__node_name": "name",
    "_Node__node_namespace": "namespace",
}
"""Arguments of a node by the attributes that have them: files that leave out nodes of others go by these.

Source: launch_ros/actions/node.py of humble, jazzy and kilted.
"""
_SUBSTITUTIONS = frozenset(f"launch.{name}" for name in tables.SUBSTITUTIONS)


def _row(path: str) -> Api | None:
    return _ROS.row(path) or tables.find(path)


class LaunchLibrary(RosLibrary):
    """What Python's own library, rclpy and launch are known to do in a run."""

    offers = Offers(
        _row,
        {**_ROS.effects, **calls.EFFECTS},
        {**_ROS.methods, **calls.METHODS},
        {**_ROS.plain, **calls.PLAIN},
        _ROS.bases | {"launch_object", "launch_description"},
    )

    def attribute_of_object(self, value: Instance, cls: External, name: str) -> Value:
        is_entities = name == "entities" and names.canonical(cls.path) == "launch.LaunchDescription"
        said = calls.entities(self.run, value) if is_entities else None
        if name == "name" and kind_of(value) in calls.DECLARES:
            said = argument(value, "name")
        if name in _KEPT_BY_NODES and kind_of(value) in _NODES and isinstance(value, LaunchObject):
            said = None if value.open else value.given(_KEPT_BY_NODES[name])
        return super().attribute_of_object(value, cls, name) if said is None else said

    def is_subclass(self, path: str, cls: Value) -> bool | None:
        row = tables.find(cls.path) if isinstance(cls, External) else None
        if row is None:
            return None
        return True if path == row.path or (row.path == "launch.Substitution" and path in _SUBSTITUTIONS) else None

    def speaks_for(self, path: str) -> bool:
        """nav2's sources may lie in the workspace.  What its substitutions make of a file is known here, and cannot
        be read off their code, which writes it when the launch runs."""
        return path.startswith("nav2_common.launch.") and tables.find(path) is not None

    def is_ordinary_class(self, path: str) -> bool:
        return super().is_ordinary_class(path) or tables.find(path) is not None

    def constructing(self, instance: Instance, cls: ClassValue, site: CallSite) -> None:
        calls.note_given(self.run, instance, cls, site)


__all__ = ["LaunchLibrary"]
