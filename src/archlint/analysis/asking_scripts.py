"""Scripts that ask others for something and end: whoever runs one sees that it waits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.model import EntityKind, Role
from archlint.syntax.walk import called_name, calls_in
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Creation, Program
    from archlint.systems.model import System, WorkspaceIndex

_TAKES_IN = frozenset({EntityKind.SUBSCRIBER, EntityKind.SERVICE, EntityKind.TIMER, EntityKind.ACTION_SERVER})
_ASKS = frozenset({EntityKind.CLIENT, EntityKind.ACTION_CLIENT})
_REQUESTS = (".call", ".call_async", ".send_goal", ".send_goal_async")
_ON_ITS_WAY = frozenset({Role.MAIN, Role.MODULE, Role.INIT})


def is_step_of_asking_script(system: System, program: Program, call: ApiCall) -> bool:
    """Whether a call is on the way of a program whose nodes take in nothing while it waits, and which no launch file
    starts."""
    if call.context.role not in _ON_ITS_WAY or not program.executable or program.exhausted or not program.nodes:
        return False
    return all(_takes_in_nothing(node) and not is_launched(system.workspace, node) for node in program.nodes)


def is_seen_to_wait(system: System, program: Program, call: ApiCall, clients: Sequence[Creation]) -> bool:
    """Whether a script that somebody starts by hand says in each round of a loop that it waits for a server: all that
    it is there for is the request that comes next, and Ctrl-C ends it."""
    if not is_step_of_asking_script(system, program, call) or not _only_asks(program, clients):
        return False
    loop = source_code(system).loop(call)
    return loop is not None and any(called_name(inner) in _SAYS for inner in calls_in(loop.body))


_SAYS = frozenset({"info", "warn", "warning", "error", "print"})


def _only_asks(program: Program, clients: Sequence[Creation]) -> bool:
    """Whether a program has nothing but clients and sends one request, with one of these: if it is spun afterwards,
    nothing else comes of that."""
    if any(creation.kind not in _ASKS for node in program.nodes for creation in node.creations):
        return False
    asking = {call.place: call for call in program.calls if call.api.endswith(_REQUESTS)}
    return len(asking) == 1 and all(not call.looped and call.creation in clients for call in asking.values())


def _takes_in_nothing(node: Blueprint) -> bool:
    if not node.complete or node.escapes or node.caller_unknown:
        return False
    return not any(creation.kind in _TAKES_IN for creation in node.creations)


def is_launched(workspace: WorkspaceIndex | None, node: Blueprint) -> bool:
    """Whether a launch file starts a node."""
    return workspace is not None and key_of(node) in workspace.started_by_launch


__all__ = ["is_launched", "is_seen_to_wait", "is_step_of_asking_script"]
