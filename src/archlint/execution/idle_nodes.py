"""Nodes that wait for work which no executor ever gives them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.source_code import source_code
from archlint.execution.spins import spin_before
from archlint.execution.taken_nodes import Taken, taken
from archlint.execution.waits import asked_clients
from archlint.finding import Place
from archlint.libraries import tables
from archlint.model import (
    EntityKind,
    ExecutorKind,
    Role,
    SpinDuration,
)
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import Blueprint, Creation, Program
    from archlint.systems.model import System

SERVED = {
    EntityKind.SUBSCRIBER: "subscription",
    EntityKind.SERVICE: "service",
    EntityKind.TIMER: "timer",
    EntityKind.ACTION_SERVER: "action server",
}
_OWN_API = frozenset(
    row.path for row in tables.ROWS if row.path.startswith("rclpy.") and row.kind in SERVED and row.callbacks
)


def started_nodes(system: System) -> Iterator[tuple[Program, Blueprint]]:
    """The nodes of programs that somebody starts, outside of test code."""
    for program in system.programs:
        if program.executable and not system.roles.is_test(program.file):
            yield from ((program, node) for node in program.nodes if not node.test and not node.caller_unknown)


@dataclass(frozen=True)
class Idle:
    """Why a node that needs spinning (for what it has ``served``) is not spun: nothing does it, or (``spin``) only its
    constructor, for a moment, or (``behind``) only a call that stands behind one which never returns.  One that offers
    nothing may need it for the answers to its requests: ``asked`` is where it registers done callbacks for them."""

    served: Sequence[Creation]
    spin: Place | None = None
    behind: Place | None = None
    asked: Sequence[Place] = ()
    taken: Taken | None = None
    """The call that takes the node from its executor, after which nothing spins it."""


def _all_is_seen(program: Program, node: Blueprint) -> bool:
    unknown = any(
        use.kind == ExecutorKind.UNKNOWN or use.astray or (use.spun and not use.nodes and use.place is None)
        for use in program.executors
    )
    return not (program.exhausted or unknown or node.escapes or node.runs_elsewhere) and node.complete


def idle_of(system: System, program: Program, node: Blueprint) -> Idle | None:
    """Why nothing serves what a node certainly offers; None where something may."""
    served = [c for c in node.creations if c.api in _OWN_API and _is_certain(c)]
    if node.executor == ExecutorKind.NONE:
        asked = () if served else _done_callbacks(system, program, node)
        return Idle(served, asked=asked) if served or asked else None
    gone = taken(source_code(system), program, node) if served else None
    if gone is not None:
        return Idle(served, taken=gone)
    spells = [spell for use in program.executors if use.spun for spell in use.spells.get(node, ())]
    if not spells or any(node in use.nodes and node not in use.spells for use in program.executors):
        return None
    behind = [spin_before(source_code(system), program, spell.place) for spell in spells]
    if served and all(behind):
        return Idle(served, behind=behind[0])
    if not all(spell.in_constructor and spell.lasting == SpinDuration.A_MOMENT for spell in spells):
        return None
    if not all(spell.for_answer for spell in spells):
        # It may be just for what was there by then that the constructor spins.
        last = max(spell.creations for spell in spells)
        served = [c for c in served if c in node.creations[last:]]
    return Idle(served, spin=spells[0].place) if served else None


@once
def taking_calls(system: System) -> frozenset[Place]:
    """The spins that take nodes from their executors for good."""
    judged = ((program, node, idle_of(system, program, node)) for program, node in started_nodes(system))
    return frozenset(
        idle.taken.call
        for program, node, idle in judged
        if idle is not None and idle.taken is not None and _all_is_seen(program, node)
    )


def _done_callbacks(system: System, program: Program, node: Blueprint) -> list[Place]:
    """Where a program registers done callbacks for requests that it sends with clients of a node alone."""
    asked = asked_clients(system).items()
    return sorted(
        place
        for (run, place), clients in asked
        if run is program and clients and all(client.node is node for client in clients)
    )


def _is_certain(creation: Creation) -> bool:
    """Whether a program surely gets to a create call, and keeps what it creates: a method of a helper which is given
    the node creates nothing where nobody here calls it with a callback."""
    uncalled = creation.context is not None and creation.context.role == Role.METHOD
    is_given_none = all(callback.name == "?" for callback in creation.callbacks.values())
    return not (creation.conditional or creation.destroyed or (uncalled and is_given_none))
