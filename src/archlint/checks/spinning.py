"""EXE008: nodes that nobody spins."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import import_that_fails, is_not_installed, starts_ros
from archlint.analysis.object_uses import read_off
from archlint.analysis.reach import node_name, one_for_each_place
from archlint.analysis.source_code import source_code
from archlint.checks.rate_sleeps import asleep
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.called_by_hand import left_to_executor
from archlint.execution.idle_nodes import SERVED, Idle, _all_is_seen, idle_of, started_nodes
from archlint.execution.second_inits import initialises_again
from archlint.execution.unfollowed_spins import may_be_spun_later
from archlint.finding import Finding, Related
from archlint.model import ExecutorKind

if TYPE_CHECKING:
    from archlint.model import Blueprint, Program
    from archlint.systems.model import System


@rule("EXE008", scope=Scope.CODE, by_program=True, in_use=True)
def node_never_spun(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that wait for work which no executor ever gives them."""
    judged = [(program, node, _idle(system, program, node)) for program, node in started_nodes(system)]
    spun = {node.made_at or node.place for _, node, idle in judged if idle is None}
    sleeping = asleep(system)  # EXE009 says where these hang
    yield from one_for_each_place(
        _never_spun(system, node, idle)
        for program, node, idle in judged
        if idle is not None
        and id(node) not in sleeping
        and (node.made_at or node.place) not in spun
        and _all_is_seen(program, node)
        and not _never_gets_there(system, program, node)
        and not may_be_spun_later(system, program, node)
    )


def _never_gets_there(system: System, program: Program, node: Blueprint) -> bool:
    """Whether a node is never made: its program does not call ``rclpy.init()``, or its constructor does so once more,
    so that rclpy raises, or it is a script that no package installs and that stops at its first imports."""
    workspace, file = system.workspace, (node.made_at or node.place).file
    if workspace is None:
        return False
    if initialises_again(workspace, program, node):
        return True
    stops = is_not_installed(workspace, file) and import_that_fails(workspace, file) is not None
    return stops or not starts_ros(workspace, program.file)


def _idle(system: System, program: Program, node: Blueprint) -> Idle | None:
    """Why nothing serves what a node offers, without what the program does by hand; a script that no package installs
    may do so with one callback to measure or to try it."""
    idle = idle_of(system, program, node)
    if idle is None or idle.asked:
        return idle
    left = left_to_executor(source_code(system), node, idle.served)
    by_hand = len(left) < len(idle.served)
    if not left or (by_hand and is_not_installed(system.workspace, (node.made_at or node.place).file)):
        return None
    return replace(idle, served=left)


_SHOWN = 5
"""How many of the things that are never served are related."""


def _never_spun(system: System, node: Blueprint, idle: Idle) -> Finding:
    if idle.asked:
        return _never_answered(system, node, idle)
    served = list(
        {creation.place: creation for creation in sorted(idle.served, key=lambda creation: creation.place)}.values()
    )
    what = SERVED[served[0].kind] + (f" and {len(served) - 1} more" if len(served) > 1 else "")
    callbacks, runs = ("callbacks", "run") if len(served) > 1 else ("callback", "runs")
    message = f"nothing spins this node, so the {callbacks} of its {what} never {runs}"
    help_ = "rclpy.spin(node), or add it to the executor that spins"
    related = [Related(creation.place, f"the {SERVED[creation.kind]} is created here") for creation in served[:_SHOWN]]
    if node.executor == ExecutorKind.NONE:
        if node.never_starting is not None:
            help_ = "start the thread: call its start()"
            related.append(Related(node.never_starting, "this thread would spin it, but is never started"))
        elif node.removed_at is not None:
            related.append(Related(node.removed_at, "it is removed from its executor here"))
    if idle.spin is not None:
        message = f"nothing spins this node after its constructor, so the {callbacks} of its {what} no longer {runs}"
        related.append(Related(idle.spin, "the constructor spins only briefly"))
    if idle.taken is not None:
        name = idle.taken.api.rpartition(".")[2]
        message = f"{name}() takes the node from its executor, so the {callbacks} of its {what} no longer {runs}"
        help_ = "leave the spinning to the executor: wait for the future with an event that its done callback sets"
        if name == "spin_once":
            help_ = "leave the spinning to the executor, or spin that: executor.spin_once()"
        related.append(Related(idle.taken.executor, "this executor has the node until then"))
    if idle.behind is not None:
        message = f"nothing spins this node before ROS shuts down, so the {callbacks} of its {what} never {runs}"
        help_ = "add both nodes to one executor: executor.add_node(…) for each, then executor.spin()"
        related.append(Related(idle.behind, "this spin returns only at shutdown, so the next one comes too late"))
    attributes = read_off(system.workspace, node) if idle.taken is None and idle.spin is idle.behind is None else []
    if attributes:
        names = " and ".join(f"'{name}'" for name in attributes)
        help_ = f"do not create a node for this: move {names} out of the class"
    return finding(
        "EXE008",
        (node.made_at or node.place) if idle.taken is None else idle.taken.call,
        message,
        help=help_,
        related=related,
        node=node_name(system, node),
        identity=(node.class_name,),
    )


def _never_answered(system: System, node: Blueprint, idle: Idle) -> Finding:
    """The finding about a node that only sends requests, and that takes the responses in done callbacks."""
    first, *others = idle.asked
    whose = "done callbacks of its requests never run" if others else "done callback of its request never runs"
    return finding(
        "EXE008",
        node.made_at or node.place,
        f"nothing spins this node, so the {whose}",
        help="rclpy.spin(node), or add it to the executor that spins",
        related=[Related(place, "the done callback is registered here") for place in (first, *others)[:_SHOWN]],
        node=node_name(system, node),
        identity=(node.class_name, "answers"),
    )
