"""The callback groups of a node, and who needs them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.left_over import is_kept_unused
from archlint.analysis.reach import judged_calls
from archlint.analysis.source_code import source_code
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.idle_nodes import SERVED
from archlint.execution.spins import awaits, spun_in_callbacks
from archlint.finding import Place
from archlint.model import (
    EntityKind,
    GroupKind,
)

if TYPE_CHECKING:
    from archlint.model import Blueprint, Creation, Group, Program
    from archlint.systems.model import System
WITH_WORK = frozenset({*SERVED, EntityKind.CLIENT, EntityKind.ACTION_CLIENT, EntityKind.GUARD_CONDITION})
"""Kinds of entities that an executor has work from."""


def all_nodes(system: System) -> Iterator[tuple[Program, Blueprint]]:
    """The nodes that one line may serve besides those that are judged: those of libraries, too."""
    for program in system.programs:
        if not system.roles.is_test(program.file):
            yield from ((program, node) for node in program.nodes if not node.test)


def needing_groups(system: System) -> set[int]:
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


def only_excludes(program: Program, node: Blueprint) -> bool:
    """Whether the one group of a node promises nothing but that its callbacks do not run at the same time, which
    one thread keeps: all of the node's work is in it, or it is made in a file that does not choose the executor."""
    groups = {creation.group for creation in node.creations if creation.kind in WITH_WORK}
    own = [group for group in groups if group.kind != GroupKind.DEFAULT]
    if len(own) != 1 or own[0].kind != GroupKind.MUTUALLY_EXCLUSIVE or own[0].key is None or own[0].place is None:
        return False
    uses = [use for use in program.executors if node in use.nodes]
    chosen_in = {place.file for use in uses for place in (use.place, use.spins_at(node)) if place is not None}
    return len(groups) == 1 or own[0].place.file not in chosen_in


def serializes_callbacks(node: Blueprint) -> bool:
    """Whether the one group that a node makes is exclusive and holds several callbacks: it may be there only to keep
    these apart, which one thread does anyway."""
    groups = [creation.group for creation in node.creations if creation.kind in SERVED]
    own = [group for group in groups if group.kind != GroupKind.DEFAULT]
    if len(own) <= 1 or len(set(own)) > 1 or own[0].key is None:
        return False
    return own[0].kind == GroupKind.MUTUALLY_EXCLUSIVE


def groups_in_use(node: Blueprint) -> Iterator[Group]:
    """The groups that something of a node is put into."""
    for creation in node.creations:
        if (
            creation.group.kind in (GroupKind.MUTUALLY_EXCLUSIVE, GroupKind.REENTRANT)
            and creation.group.key is not None
        ):
            yield creation.group


def groups_made(system: System, node: Blueprint) -> list[tuple[Place, str]]:
    """Where each group of a node is made, the node's own file first, and its kind in words.  Groups in which nothing is
    but clients that no code asks anything are left out: no callback of theirs ever runs."""
    at_work = {creation.group for creation in node.creations if not _is_idle_client(system, creation)}
    kinds = {
        group.place: group.kind.replace("_", " ")
        for group in groups_in_use(node)
        if group in at_work and group.place is not None and not system.roles.is_test(group.place.file)
    }
    return sorted(kinds.items(), key=lambda row: (row[0].file != node.place.file, row[0]))


def _is_idle_client(system: System, creation: Creation) -> bool:
    is_client = creation.kind in (EntityKind.CLIENT, EntityKind.ACTION_CLIENT)
    return is_client and system.workspace is not None and is_kept_unused(system.workspace, creation.place)
