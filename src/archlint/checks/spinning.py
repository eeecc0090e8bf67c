"""EXE008 and CBG002: nodes that nobody spins, and callback groups that one thread cannot honour."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from archlint.analysis import blocking
from archlint.analysis.aside import import_that_fails, is_not_installed
from archlint.analysis.callback_roles import runs_in_executor
from archlint.analysis.deadlock import related_executor, threads_of
from archlint.analysis.object_uses import read_off
from archlint.analysis.reach import judged_calls, node_name, one_for_each_place
from archlint.analysis.source_code import source_code
from archlint.analysis.spins import awaits, spin_before, spins_if_asked, spun_by_several, spun_in_callbacks
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.libraries import tables
from archlint.model import (
    EntityKind,
    ExecutorKind,
    GroupKind,
    SpinDuration,
)

if TYPE_CHECKING:
    from archlint.model import Blueprint, Creation, Group, Program
    from archlint.systems.model import System

_SERVED = {
    EntityKind.SUBSCRIBER: "subscription",
    EntityKind.SERVICE: "service",
    EntityKind.TIMER: "timer",
    EntityKind.ACTION_SERVER: "action server",
}
_WORKING = frozenset({*_SERVED, EntityKind.CLIENT, EntityKind.ACTION_CLIENT, EntityKind.GUARD_CONDITION})
"""Kinds of entities that an executor has work from."""
_OWN_API = frozenset(
    row.path for row in tables.ROWS if row.path.startswith("rclpy.") and row.kind in _SERVED and row.callbacks
)


def _judged(system: System) -> Iterator[tuple[Program, Blueprint]]:
    """The nodes of programs that somebody starts, outside of test code."""
    for program in system.programs:
        if program.executable and not system.roles.is_test(program.file):
            yield from ((program, node) for node in program.nodes if not node.test and not node.caller_unknown)


# --------------------------------------------------------------------------------------------------- EXE008


@dataclass(frozen=True)
class _Idle:
    """Why a node that needs spinning (for what it has ``served``) is not spun: nothing does it, or (``spin``) only its
    constructor, for a moment, or (``behind``) only a call that stands behind one which never returns."""

    served: Sequence[Creation]
    spin: Place | None = None
    behind: Place | None = None


@rule("EXE008", scope=Scope.CODE)
def node_never_spun(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that wait for work which no executor ever gives them."""
    judged = [(program, node, _idle(system, program, node)) for program, node in _judged(system)]
    spun = {node.made_at or node.place for _, node, idle in judged if idle is None}
    yield from one_for_each_place(
        _never_spun(system, node, idle)
        for program, node, idle in judged
        if idle is not None and (node.made_at or node.place) not in spun and _all_is_seen(program, node)
    )


def _all_is_seen(program: Program, node: Blueprint) -> bool:
    unknown = any(
        use.kind == ExecutorKind.UNKNOWN or use.astray or (use.spun and not use.nodes) for use in program.executors
    )
    return not (program.exhausted or unknown or node.escapes) and node.complete


def _idle(system: System, program: Program, node: Blueprint) -> _Idle | None:
    """Why nothing serves what a node certainly offers; None where something may."""
    served = [c for c in node.creations if c.api in _OWN_API and not c.conditional and not c.destroyed]
    if node.executor == ExecutorKind.NONE:
        return _Idle(served) if served else None
    spells = [spell for use in program.executors if use.spun for spell in use.spells.get(node, ())]
    if not spells or any(node in use.nodes and node not in use.spells for use in program.executors):
        return None
    behind = [spin_before(source_code(system), program, spell.place) for spell in spells]
    if served and all(behind):
        return _Idle(served, behind=behind[0])
    if not all(spell.in_constructor and spell.lasting == SpinDuration.A_MOMENT for spell in spells):
        return None
    if not all(spell.for_answer for spell in spells):
        # It may be just for what was there by then that the constructor spins.
        last = max(spell.creations for spell in spells)
        served = [c for c in served if c in node.creations[last:]]
    return _Idle(served, spin=spells[0].place) if served else None


_SHOWN = 5
"""How many of the things that are never served are related."""


def _never_spun(system: System, node: Blueprint, idle: _Idle) -> Finding:
    served = list({one.place: one for one in sorted(idle.served, key=lambda one: one.place)}.values())
    what = _SERVED[served[0].kind] + (f" and {len(served) - 1} more" if len(served) > 1 else "")
    callbacks, runs = ("callbacks", "run") if len(served) > 1 else ("callback", "runs")
    message = f"nothing spins this node, so the {callbacks} of its {what} never {runs}"
    help_ = "rclpy.spin(node), or add it to the executor that spins"
    related = [Related(one.place, f"the {_SERVED[one.kind]} is created here") for one in served[:_SHOWN]]
    if idle.spin is not None:
        message = f"nothing spins this node after its constructor, so the {callbacks} of its {what} no longer {runs}"
        related.append(Related(idle.spin, "the constructor spins only briefly"))
    if idle.behind is not None:
        message = f"nothing spins this node before ROS shuts down, so the {callbacks} of its {what} never {runs}"
        help_ = "add both nodes to one executor: executor.add_node(…) for each, then executor.spin()"
        related.append(Related(idle.behind, "this spin returns only at shutdown, so the next one comes too late"))
    attributes = read_off(system.workspace, node) if idle.spin is idle.behind is None else []
    if attributes:
        names = " and ".join(f"'{name}'" for name in attributes)
        help_ = f"do not create a node for this: move {names} out of the class"
    found = finding(
        "EXE008",
        node.made_at or node.place,
        message,
        help=help_,
        related=related,
        node=node_name(system, node),
        identity=(node.class_name,),
    )
    file = found.place.file
    fails = import_that_fails(system.workspace, file) if is_not_installed(system.workspace, file) else None
    if fails is None:
        return found
    unused = f"no package installs this file, and its import of '{fails}' fails"
    return replace(found, message=f"{message}; {unused}", severity=Severity.INFO)


# --------------------------------------------------------------------------------------------------- CBG002


@rule("CBG002", scope=Scope.CODE, taste=True)
def groups_without_threads(system: System, options: Options) -> Iterator[Finding]:
    """Callback groups of nodes that one thread spins."""
    kept = _needing(system) | spun_by_several(system)
    effective = {
        group.place
        for program, node in _all(system)
        if id(node) in kept or threads_of(node, program) not in (blocking.ONE, blocking.NOBODY)
        for group in _grouped(node)
    }
    yield from one_for_each_place(
        _useless(system, program, node, groups)
        for program, node in _judged(system)
        if threads_of(node, program) == blocking.ONE and id(node) not in kept and not _only_excludes(program, node)
        for groups in [
            [
                (place, kind)
                for place, kind in _groups(system, node)
                if place not in effective and not spins_if_asked(system, program, node, place)
            ]
        ]
        if groups
    )


def _all(system: System) -> Iterator[tuple[Program, Blueprint]]:
    """The nodes that one line may serve besides those that are judged: those of libraries, too."""
    for program in system.programs:
        if not system.roles.is_test(program.file):
            yield from ((program, node) for node in program.nodes if not node.test)


def _needing(system: System) -> set[int]:
    """The nodes (their ``id``) whose groups let something in on one thread, too: the answer that a callback awaits,
    or what a callback that spins waits for."""
    code = source_code(system)
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
        if callback.is_async and runs_in_executor(callback) and awaits(code, callback)
    }
    return awaiting | spun_in_callbacks(system)


def _only_excludes(program: Program, node: Blueprint) -> bool:
    """Whether the one group of a node promises nothing but that its callbacks do not run at the same time, which
    one thread keeps: all of the node's work is in it, or it is made in a file that does not choose the executor."""
    groups = {creation.group for creation in node.creations if creation.kind in _WORKING}
    own = [group for group in groups if group.kind != GroupKind.DEFAULT]
    if len(own) != 1 or own[0].kind != GroupKind.MUTUALLY_EXCLUSIVE or own[0].key is None or own[0].place is None:
        return False
    uses = [use for use in program.executors if node in use.nodes]
    chosen_in = {place.file for use in uses for place in (use.place, use.spins_at(node)) if place is not None}
    return len(groups) == 1 or own[0].place.file not in chosen_in


def _grouped(node: Blueprint) -> Iterator[Group]:
    """The groups that something of a node is put into."""
    for creation in node.creations:
        if (
            creation.group.kind in (GroupKind.MUTUALLY_EXCLUSIVE, GroupKind.REENTRANT)
            and creation.group.key is not None
        ):
            yield creation.group


def _groups(system: System, node: Blueprint) -> list[tuple[Place, str]]:
    """Where each group of a node is made, the node's own file first, and its kind in words."""
    found = {
        group.place: group.kind.replace("_", " ")
        for group in _grouped(node)
        if group.place is not None and not system.roles.is_test(group.place.file)
    }
    return sorted(found.items(), key=lambda one: (one[0].file != node.place.file, one[0]))


def _useless(system: System, program: Program, node: Blueprint, groups: list[tuple[Place, str]]) -> Finding:
    """One finding a node: it is the executor that is wrong, or all of its groups."""
    (place, kind), *others = groups
    what = f"{len(groups)} callback groups" if others else f"a {kind} callback group"
    return finding(
        "CBG002",
        place,
        f"{what} in a node that a single thread spins has no effect: callbacks never run in parallel",
        help=f"spin the node with a MultiThreadedExecutor, or remove the group{'s' if others else ''}",
        related=[
            *(Related(other, f"a {kind} group is made here") for other, kind in others),
            *related_executor(node, program),
        ],
        node=node_name(system, node),
        identity=(node.class_name,),
    )
