"""Keywords that a constructor of launch or launch_ros does not have.

Source: the constructors, humble to rolling.  What an action takes with ``**kwargs`` it hands on to ``Action``, which
has ``condition`` alone.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.launch.mistakes import UnknownAttribute
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.objects import LaunchObject
    from archlint.launch.run import LaunchRun

_OF_PROCESSES = frozenset({"condition", "sigterm_timeout", "sigkill_timeout", "log_cmd"})
_REFUSED_AT_ONCE = frozenset(
    {
        LaunchClass.LAUNCH_CONFIGURATION,
        LaunchClass.ENVIRONMENT_VARIABLE,
        LaunchClass.TEXT_SUBSTITUTION,
        LaunchClass.FIND_PACKAGE_SHARE,
        LaunchClass.FIND_PACKAGE_PREFIX,
        LaunchClass.PATH_JOIN_SUBSTITUTION,
        LaunchClass.FIND_EXECUTABLE,
        LaunchClass.COMMAND,
        LaunchClass.PYTHON_EXPRESSION,
        LaunchClass.DECLARE_LAUNCH_ARGUMENT,
        LaunchClass.INCLUDE_LAUNCH_DESCRIPTION,
        LaunchClass.GROUP_ACTION,
        LaunchClass.SET_ENVIRONMENT_VARIABLE,
        LaunchClass.SET_LAUNCH_CONFIGURATION,
        LaunchClass.SET_PARAMETER,
        LaunchClass.SET_REMAP,
        LaunchClass.TIMER_ACTION,
        LaunchClass.REGISTER_EVENT_HANDLER,
        LaunchClass.OPAQUE_FUNCTION,
        LaunchClass.PUSH_ROS_NAMESPACE,
        LaunchClass.PYTHON_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.IF_CONDITION,
        LaunchClass.UNLESS_CONDITION,
        LaunchClass.PARAMETER_VALUE,
        LaunchClass.PARAMETER_FILE,
    }
)
"""The classes that start nothing by themselves and take the same in all distributions."""


def note_of_process(run: LaunchRun, entity: LaunchObject) -> None:
    """Note what an action that starts a process is given and does not have."""
    _note(run, entity, _OF_PROCESSES)


def note_of_constructor(run: LaunchRun, entity: LaunchObject) -> None:
    """Note it where an object is made: the launch file raises there, whether the object is used or not."""
    if entity.kind in _REFUSED_AT_ONCE:
        _note(run, entity, frozenset())


def _note(run: LaunchRun, entity: LaunchObject, others: frozenset[str]) -> None:
    known = entity.kind.signature.replace("*", "").split()
    places = entity.places
    for name in entity.arguments:
        if name not in known and name not in others and not name.isdigit() and name in places:
            given = frozenset(entity.arguments)
            run.note_unknown_attribute(UnknownAttribute(entity.kind, name, tuple(known), places[name], given=given))


__all__ = ["note_of_constructor", "note_of_process"]
