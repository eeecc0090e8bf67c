"""Scoped groups that set something for what is not in them.

Source: launch's ``GroupAction``, which brings back configurations and environment at its end; launch_ros keeps the
namespace, and the first remapping or parameter for all nodes, among the configurations.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known
from archlint.launch.mistakes import IdleGroup
from archlint.launch.objects import LaunchObject
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.context import Context
    from archlint.launch.run import LaunchRun

_SETTINGS = frozenset(
    {
        LaunchClass.SET_ENVIRONMENT_VARIABLE,
        LaunchClass.APPEND_ENVIRONMENT_VARIABLE,
        LaunchClass.UNSET_ENVIRONMENT_VARIABLE,
        LaunchClass.SET_LAUNCH_CONFIGURATION,
        LaunchClass.PUSH_ROS_NAMESPACE,
    }
)
_OF_LISTS = frozenset({LaunchClass.SET_PARAMETER, LaunchClass.SET_USE_SIM_TIME, LaunchClass.SET_REMAP})
"""What goes into lists that groups share with what is around them, if that has such lists already."""


def note_idle_group(run: LaunchRun, group: LaunchObject, before: Context) -> None:
    """Note a group of nothing but settings, which nobody sees; ``before`` is the context in front of it."""
    actions = group.argument("actions")
    if actions is None or run.is_open(actions) or group.argument("scoped") not in (None, Known(True)):
        return
    kept_in_lists = before.remaps is not None or before.parameters is not None
    settings = _SETTINGS if kept_in_lists else _SETTINGS | _OF_LISTS
    kinds = [action.kind if isinstance(action, LaunchObject) else None for action in run.items(actions)]
    if kinds and settings.issuperset(kinds) and group.place is not None:
        names = dict.fromkeys(kind.value for kind in kinds if kind is not None)
        run.note_idle_group(IdleGroup(tuple(names), group.place))


__all__ = ["note_idle_group"]
