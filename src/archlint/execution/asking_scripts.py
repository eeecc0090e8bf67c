"""Scripts that ask others for something and end: whoever runs one sees that it waits."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.execution.spins import is_spin_call
from archlint.model import EntityKind, Role
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System, WorkspaceIndex

_TAKES_IN = frozenset({EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.TIMER, EntityKind.ACTION_SERVER})
_ASKS = frozenset({EntityKind.CLIENT, EntityKind.ACTION_CLIENT})
_BLOCKING = frozenset({"rclpy.client.Client.call", "rclpy.action.client.ActionClient.send_goal"})
_REQUESTS = _BLOCKING | {f"{api}_async" for api in _BLOCKING}
_ON_ITS_WAY = frozenset({Role.MAIN, Role.MODULE, Role.INIT})


def is_step_of_asking_script(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a call is on the way of a program whose nodes take in nothing while it waits, and which no launch file
    starts."""
    if call.context.role not in _ON_ITS_WAY or not program.executable or program.exhausted or not program.nodes:
        return False
    return all(_takes_in_nothing(node) and not is_launched(system.workspace, node) for node in program.nodes)


def asks_once(system: System, program: Program, call: ApiCall) -> bool:
    """Whether such a program sends one request, in no loop, waits for what comes of it, and ends."""
    asks = [other for other in program.calls if other.api in _REQUESTS]
    spins = [other for other in program.calls if is_spin_call(other)]
    return (
        is_step_of_asking_script(system, program, call)
        and len({other.place for other in asks}) == 1
        and not any(other.looped or other.enclosing_loops for other in asks)
        and (bool(spins) or all(other.api in _BLOCKING for other in asks))
        and all(other.api.endswith("spin_until_future_complete") for other in spins)
    )


def has_only_clients(program: Program) -> bool:
    """Whether all that the nodes of a program create are clients: what they ask for is all that they are there for."""
    return all(creation.kind in _ASKS for node in program.nodes for creation in node.creations)


def _takes_in_nothing(node: Blueprint) -> bool:
    if not node.complete or node.escapes or node.caller_unknown:
        return False
    return not any(creation.kind in _TAKES_IN for creation in node.creations)


def is_launched(workspace: WorkspaceIndex | None, node: Blueprint) -> bool:
    """Whether a launch file starts a node."""
    return workspace is not None and key_of(node) in workspace.started_by_launch


__all__ = ["asks_once", "has_only_clients", "is_launched", "is_step_of_asking_script"]
