"""The names that arguments of nodes had before Galactic: ``Node(node_executable=…)``.

Source: launch_ros of Eloquent, which has these alone, and of Foxy, which has both.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from archlint.finding import Place
    from archlint.launch.objects import LaunchObject

_OLD = {
    "executable": "node_executable",
    "name": "node_name",
    "namespace": "node_namespace",
    "plugin": "node_plugin",
}


def under_present_names(entity: LaunchObject) -> LaunchObject:
    """A node or component with what it is given, and the places of that, also under the names that they have now."""
    old = {name: before for name, before in _OLD.items() if before in entity.arguments and name not in entity.arguments}
    if not old:
        return entity
    arguments = {name: entity.arguments[before] for name, before in old.items()}
    places = {name: entity.places[before] for name, before in old.items() if before in entity.places}
    return replace(entity, arguments={**entity.arguments, **arguments}, places={**entity.places, **places})


def has_old_executable(places: Mapping[str, Place]) -> bool:
    """Whether that is how an action names its executable, by the places of its arguments."""
    return _OLD["executable"] in places


__all__ = ["has_old_executable", "under_present_names"]
