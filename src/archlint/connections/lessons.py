"""Workspaces that a lesson is about."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node

_NODES = 5
"""How many nodes a workspace has at most that a lesson is about: three, and two that are added to them."""


def is_lesson(system: System) -> bool:
    """Whether a workspace is so small that whoever wrote it may be learning.  There the habits that a lesson warns of
    are worth a word; in a large one they are how a robot is built, unless something shows what they cost.  A launch
    file that starts a few nodes of a large one makes it no smaller."""
    workspace = system.workspace
    return max(_kinds(system.nodes), 0 if workspace is None else _kinds_of_workspace(workspace)) <= _NODES


@once
def _kinds_of_workspace(workspace: WorkspaceIndex) -> int:
    return _kinds(node for system in workspace.systems for node in system.nodes)


def _kinds(nodes: Iterable[Node]) -> int:
    """How many different nodes there are."""
    return len({key_of(node.blueprint) for node in nodes if node.blueprint is not None and not node.external})


__all__ = ["is_lesson"]
