"""CBG002: callback groups that one thread cannot honour."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.slow_callbacks import held_up_by_goals
from archlint.execution import blocking
from archlint.execution.callback_groups import (
    all_nodes,
    groups_in_use,
    groups_made,
    needing_groups,
    only_excludes,
    serializes_callbacks,
)
from archlint.execution.deadlock import related_executor, threads_of
from archlint.execution.idle_nodes import started_nodes
from archlint.execution.spins import spins_if_asked, spun_by_several
from archlint.finding import Finding, Place, Related, Severity

if TYPE_CHECKING:
    from archlint.model import Blueprint, Program
    from archlint.systems.model import System


@rule("CBG002", scope=Scope.CODE, by_program=True, taste=True)
def groups_without_threads(system: System, options: Options) -> Iterator[Finding]:
    """Callback groups of nodes that one thread spins."""
    kept = needing_groups(system) | spun_by_several(system)
    told = held_up_by_goals(system)  # EXE003 says that they want more threads
    effective = {
        group.place
        for program, node in all_nodes(system)
        if id(node) in kept or threads_of(node, program) not in (blocking.ONE, blocking.NOBODY)
        for group in groups_in_use(node)
    }
    yield from one_for_each_place(
        _useless(system, program, node, groups)
        for program, node in started_nodes(system)
        if threads_of(node, program) == blocking.ONE
        and id(node) not in kept | told
        and not only_excludes(program, node)
        for groups in [
            [
                (place, kind)
                for place, kind in groups_made(system, node)
                if place not in effective and not spins_if_asked(system, program, node, place)
            ]
        ]
        if groups
    )


def _useless(system: System, program: Program, node: Blueprint, groups: list[tuple[Place, str]]) -> Finding:
    """One finding a node: it is the executor that is wrong, or all of its groups."""
    (place, kind), *others = groups
    what = f"{len(groups)} callback groups" if others else f"a {kind} callback group"
    diagnostic = finding(
        "CBG002",
        place,
        f"{what} in a node that a single thread spins has no effect: callbacks never run in parallel",
        help=f"spin the node with a MultiThreadedExecutor, or remove the group{'s' if others else ''}",
        related=[
            *(Related(other, f"a {kind} group is created here") for other, kind in others),
            *related_executor(node, program),
        ],
        node=node_name(system, node),
        identity=(node.class_name,),
    )
    return replace(diagnostic, severity=Severity.INFO) if serializes_callbacks(node) else diagnostic
