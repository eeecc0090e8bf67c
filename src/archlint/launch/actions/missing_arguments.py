"""Arguments that actions of a launch file in Python need and are not given.

Source: the constructors of launch and launch_ros, humble to rolling: what has no default there.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.launch.mistakes import MissingArguments
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.launch.objects import LaunchObject
    from archlint.launch.run import LaunchRun

_NEEDED: Mapping[LaunchClass, tuple[str, ...]] = {
    LaunchClass.NODE: ("executable",),
    LaunchClass.LIFECYCLE_NODE: ("executable", "name", "namespace"),
    LaunchClass.COMPOSABLE_NODE_CONTAINER: ("executable", "name", "namespace"),
    LaunchClass.LOAD_COMPOSABLE_NODES: ("composable_node_descriptions", "target_container"),
    LaunchClass.COMPOSABLE_NODE: ("package", "plugin"),
    LaunchClass.TIMER_ACTION: ("period", "actions"),
    LaunchClass.GROUP_ACTION: ("actions",),
    LaunchClass.INCLUDE_LAUNCH_DESCRIPTION: ("launch_description_source",),
    LaunchClass.DECLARE_LAUNCH_ARGUMENT: ("name",),
    LaunchClass.SET_LAUNCH_CONFIGURATION: ("name", "value"),
    LaunchClass.SET_ENVIRONMENT_VARIABLE: ("name", "value"),
    LaunchClass.SET_PARAMETER: ("name", "value"),
    LaunchClass.SET_REMAP: ("src", "dst"),
    LaunchClass.PUSH_ROS_NAMESPACE: ("namespace",),
    LaunchClass.EXECUTE_PROCESS: ("cmd",),
    LaunchClass.OPAQUE_FUNCTION: ("function",),
    LaunchClass.REGISTER_EVENT_HANDLER: ("event_handler",),
    LaunchClass.LOG_INFO: ("msg",),
}


def note_missing_arguments(run: LaunchRun, action: LaunchObject) -> None:
    """Note that a call fails for want of an argument; where it has one that the action does not know, that is what
    was meant for it."""
    known = {*action.kind.signature.split(), "condition"}
    if action.open or action.rest or action.place is None or not run.file.endswith(".py"):
        return
    missing = tuple(name for name in _NEEDED.get(action.kind, ()) if name not in action.arguments)
    if missing and known.issuperset(action.arguments):
        run.note_incomplete(MissingArguments(action.kind, missing, action.place))


__all__ = ["note_missing_arguments"]
