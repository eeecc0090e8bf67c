"""EXE008 and CBG002: nodes that nobody spins, and callback groups that one thread cannot honour."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks import blocking
from archlint.checks.callback_roles import runs_in_executor
from archlint.checks.deadlock import related_executor, threads_of
from archlint.checks.reach import judged_calls, node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.facts import model as facts
from archlint.facts.walk import parts_of
from archlint.finding import Finding, Place, Related
from archlint.program.model import ACTION_SERVER, SERVICE, SUBSCRIBER, TIMER
from archlint.workspace.test_code import is_test_file

if TYPE_CHECKING:
    from archlint.program.model import Blueprint, Callback, Creation, Program
    from archlint.system.model import System

_SERVED = {SUBSCRIBER: "subscription", SERVICE: "service", TIMER: "timer", ACTION_SERVER: "action server"}
_OWN_API = frozenset(
    {
        "rclpy.node.Node.create_subscription",
        "rclpy.node.Node.create_service",
        "rclpy.node.Node.create_timer",
        "rclpy.action.server.ActionServer",
    }
)


def _judged(system: System) -> Iterator[tuple[Program, Blueprint]]:
    """The nodes of programs that somebody starts, outside of test code."""
    for program in system.programs:
        if program.executable and not is_test_file(program.file):
            yield from ((program, node) for node in program.nodes if not node.test and not node.held)


# --------------------------------------------------------------------------------------------------- EXE008


@rule("EXE008")
def node_never_spun(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that wait for work which no executor ever gives them."""
    spun = {node.place for _, node in _judged(system) if node.executor != "none"}
    yield from one_for_each_place(
        _never_spun(system, node, creation)
        for program, node in _judged(system)
        if node.executor == "none" and node.place not in spun and _all_is_seen(program, node)
        for creation in [_first_served(node)]
        if creation is not None
    )


def _all_is_seen(program: Program, node: Blueprint) -> bool:
    unknown = any(use.kind == "unknown" or (use.spun and not use.nodes) for use in program.executors)
    return not (program.exhausted or unknown or node.handed_out) and node.complete


def _first_served(node: Blueprint) -> Creation | None:
    """What of a node needs spinning, certainly."""
    served = [c for c in node.creations if c.api in _OWN_API and not c.conditional and not c.destroyed]
    return min(served, key=lambda c: c.place, default=None)


def _never_spun(system: System, node: Blueprint, creation: Creation) -> Finding:
    what = _SERVED[creation.kind]
    return finding(
        "EXE008",
        node.made_at or node.place,
        f"nothing spins this node, so its {what} never runs a callback",
        help="rclpy.spin(node), or add it to the executor that spins",
        related=[Related(creation.place, f"the {what} is created here")],
        node=node_name(system, node),
        identity=(node.class_name,),
    )


# --------------------------------------------------------------------------------------------------- CBG002


@rule("CBG002")
def groups_without_threads(system: System, options: Options) -> Iterator[Finding]:
    """Callback groups of nodes that one thread spins."""
    threaded = {
        node.place
        for program, node in _judged(system)
        if threads_of(node, program) not in (blocking.ONE, blocking.NOBODY)
    }
    awaiting = {
        id(call.context.node)
        for _, call in judged_calls(system)
        if call.api.endswith(".await") and runs_in_executor(call.context)
    }
    # A coroutine that awaits any other future (its own, say) keeps its group for as long.
    awaiting |= {
        id(callback.node)
        for program in system.programs
        for callback in program.callbacks
        if callback.is_async and runs_in_executor(callback) and _awaits(callback)
    }
    yield from one_for_each_place(
        _useless(system, program, node, groups)
        for program, node in _judged(system)
        if threads_of(node, program) == blocking.ONE and node.place not in threaded and id(node) not in awaiting
        for groups in [_groups(node)]
        if groups
    )


def _awaits(callback: Callback) -> bool:
    return any(isinstance(part, facts.Await) for part in parts_of(callback.function))


def _groups(node: Blueprint) -> list[tuple[Place, str]]:
    """The groups that something of a node is put into: where each is made, the node's own file first, and its
    kind in words."""
    found = {
        group.place: group.kind.replace("_", " ")
        for group in (creation.group for creation in node.creations)
        if group.kind in ("mutually_exclusive", "reentrant") and group.key is not None
        if group.place is not None and not is_test_file(group.place.file)
    }
    return sorted(found.items(), key=lambda one: (one[0].file != node.place.file, one[0]))


def _useless(system: System, program: Program, node: Blueprint, groups: list[tuple[Place, str]]) -> Finding:
    """One finding a node: it is the executor that is wrong, or all of its groups."""
    (place, kind), *others = groups
    what = f"{len(groups)} callback groups" if others else f"a {kind} callback group"
    return finding(
        "CBG002",
        place,
        f"{what} in a node that one thread spins: nothing runs at the same time there",
        help=f"spin the node with a MultiThreadedExecutor, or leave the group{'s' if others else ''} out",
        related=[
            *(Related(other, f"a {kind} group is made here") for other, kind in others),
            *related_executor(node, program),
        ],
        node=node_name(system, node),
        identity=(node.class_name,),
    )
