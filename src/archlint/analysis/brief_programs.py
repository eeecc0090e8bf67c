"""Programs that do one thing and end, such as one that asks a service to spawn a model."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.model import EntityKind, Role
from archlint.model.executors import SpinDuration

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

_ASKS = frozenset({EntityKind.CLIENT, EntityKind.ACTION_CLIENT})
_WAIT_FOR_A_SERVER = ("wait_for_service", "wait_for_server")
_TOOLS = frozenset(
    {
        ("controller_manager", "hardware_spawner"),
        ("controller_manager", "spawner"),
        ("controller_manager", "spawner.py"),
        ("controller_manager", "unspawner"),
        ("controller_manager", "unspawner.py"),
        ("gazebo_ros", "spawn_entity.py"),
        ("nav2_map_server", "map_saver_cli"),
        ("nav2_util", "lifecycle_bringup"),
        ("ros_gz_sim", "create"),
        ("ros_gz_sim", "remove"),
        ("ros_gz_sim", "set_entity_pose"),
        ("ros_ign_gazebo", "create"),
    }
)
"""Executables that do one thing and end: what they are called for those seconds makes no difference to anybody."""


def is_brief(system: System, node: Node) -> bool:
    """Whether a node is of such a tool, or all that it is there for is a request that its ``main()`` makes: it has
    nothing but clients, nothing spins it longer than until an answer is there, and no loop makes request after
    request."""
    started, blueprint = node.started, node.blueprint
    if started is not None and (started.package.text, started.executable.text) in _TOOLS:
        return True
    if blueprint is None or not blueprint.complete or blueprint.escapes or blueprint.caller_unknown:
        return False
    return any(_asks_and_ends(program, blueprint) for program in system.programs if blueprint in program.nodes)


def _asks_and_ends(program: Program, node: Blueprint) -> bool:
    if not node.creations or any(creation.kind not in _ASKS for creation in node.creations):
        return False
    if any(use.in_thread or use.lasts_for(node) > SpinDuration.A_MOMENT for use in program.executors_of(node)):
        return False
    calls = [call for call in program.calls if call.context.role == Role.MAIN]
    asks = any(_asks(call) and call.creation in node.creations for call in calls)
    return asks and not any(call.looped and not call.api.endswith(_WAIT_FOR_A_SERVER) for call in program.calls)


def _asks(call: ApiCall) -> bool:
    return call.api.endswith((".call", ".call_async", ".send_goal", ".send_goal_async"))


__all__ = ["is_brief"]
