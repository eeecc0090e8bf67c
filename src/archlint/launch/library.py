"""Launch among the libraries: what a run is told where code uses its API, in a launch file or anywhere else."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Value
from archlint.launch import effects, tables
from archlint.launch.substitutions import SUBSTITUTIONS
from archlint.libraries.api_use import Offers
from archlint.libraries.library import RosLibrary
from archlint.libraries.rclpy import names

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.values import ClassValue
    from archlint.libraries.tables import Api

_ROS = RosLibrary.offers
_SUBSTITUTIONS = frozenset(f"launch.{name}" for name in SUBSTITUTIONS)


def _row(path: str) -> Api | None:
    return _ROS.row(path) or tables.find(path)


class LaunchLibrary(RosLibrary):
    """What Python's own library, rclpy and launch are known to do in a run."""

    offers = Offers(
        _row,
        {**_ROS.effects, **effects.EFFECTS},
        {**_ROS.methods, **effects.METHODS},
        {**_ROS.plain, **effects.PLAIN},
        _ROS.bases | {"launch_object"},
    )

    def attribute_of_object(self, value: Instance, cls: External, name: str) -> Value:
        is_entities = name == "entities" and names.canonical(cls.path) == "launch.LaunchDescription"
        found = effects.entities(self.run, value) if is_entities else None
        return super().attribute_of_object(value, cls, name) if found is None else found

    def is_subclass(self, path: str, cls: Value) -> bool | None:
        row = tables.find(cls.path) if isinstance(cls, External) else None
        if row is None:
            return None
        return True if path == row.path or (row.path == "launch.Substitution" and path in _SUBSTITUTIONS) else None

    def is_ordinary_class(self, path: str) -> bool:
        return super().is_ordinary_class(path) or tables.find(path) is not None

    def constructing(self, made: Instance, cls: ClassValue, site: CallSite) -> None:
        effects.note_given(self.run, made, cls, site)


__all__ = ["LaunchLibrary"]
