"""Nodes that never act at the same time: one is started, spun or activated when the other has come to its end."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.connections.arbitration import publishes_of
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.spins import is_spin_call, spun_node
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

_ON_THE_MAIN_THREAD = frozenset({Role.INIT, Role.MAIN, Role.MODULE})


def run_in_sequence(system: System, end: Endpoint, other: Endpoint) -> bool:
    """Whether of the nodes of two endpoints only one acts at a time, for certain."""
    if _follows(system, end.node, other.node) or _follows(system, other.node, end.node):
        return True
    if _are_activated_in_turn(system, end.node, other.node):
        return True
    return _are_spun_in_sequence(end.node, other.node) and all(
        call.context.role in _ON_THE_MAIN_THREAD | {Role.METHOD} or runs_in_executor(call.context)
        for owner in (end, other)
        for call in publishes_of(system, owner)
    )


def _are_activated_in_turn(system: System, node: Node, other: Node) -> bool:
    """Whether two nodes with a life cycle publish only while they are active, and code of the workspace also ends that:
    it chooses who is."""
    blueprints, workspace = (node.blueprint, other.blueprint), system.workspace
    managed = all(blueprint is not None and blueprint.lifecycle for blueprint in blueprints)
    return managed and workspace is not None and bool(workspace.code.files_that_mention("TRANSITION_DEACTIVATE"))


def _follows(system: System, node: Node, earlier: Node) -> bool:
    """Whether a launch file starts a node when the process of another one has ended (``OnProcessExit``), or that of
    one that was started so in its turn."""
    if node.started is None or earlier.started is None or not node.started.after:
        return False
    by_action = _by_action(system)
    waiting, ended = list(node.started.after), set[int]()
    while waiting:
        action = waiting.pop()
        if action not in ended:
            ended.add(action)
            started_by = by_action.get(action, [])
            waiting += frozenset.intersection(*(started.after for started in started_by)) if started_by else ()
    return earlier.started.action in ended


@once
def _by_action(system: System) -> dict[int | None, list[Started]]:
    """What a launch starts, by the action that does so."""
    by_action: dict[int | None, list[Started]] = {}
    for started in system.launched.started if system.launched is not None else ():
        by_action.setdefault(started.action, []).append(started)
    return by_action


def _are_spun_in_sequence(node: Node, other: Node) -> bool:
    """Whether the main thread of one process spins two nodes, one after the other, each alone."""
    program, first, second = node.program, node.blueprint, other.blueprint
    if program is None or first is None or second is None or first is second:
        return False
    if other.program is not program or node.started is not other.started or node.merged or other.merged:
        return False
    spins = [_lone_spins(program, blueprint) for blueprint in (first, second)]
    loops = [{loop for call in calls for loop in _loops(call)} for calls in spins]
    return all(spins) and loops[0].isdisjoint(loops[1])


def _lone_spins(program: Program, node: Blueprint) -> list[ApiCall]:
    """The spins on the main thread that a node is given to, by itself; none where anything else may spin it."""
    uses = [use for use in program.executors if node in use.nodes]
    if node.escapes or node.runs_elsewhere or any(use.in_thread or node not in use.spells for use in uses):
        return []
    calls = [call for call in program.calls if is_spin_call(call) and call.context.role != Role.METHOD]
    if any(spun_node(call, program) is None or call.context.role not in _ON_THE_MAIN_THREAD for call in calls):
        return []
    return [call for call in calls if spun_node(call, program) is node and call.api.startswith("rclpy.spin")]


def _loops(call: ApiCall) -> set[object]:
    """The loops around a spin, on any way that leads to it."""
    return {*call.enclosing_loops, *(loop for _, loops, _ in call.call_chains for loop in loops)}
