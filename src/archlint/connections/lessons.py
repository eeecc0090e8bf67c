"""Workspaces that a lesson is about."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.systems.model import System

_NODES = 5
"""How many nodes a workspace has at most that a lesson is about: three, and two that are added to them."""


def is_lesson(system: System) -> bool:
    """Whether a workspace is so small that whoever wrote it may be learning.  There the habits that a lesson warns of
    are worth a word; in a large one they are how a robot is built, unless something shows what they cost."""
    nodes = {key_of(node.blueprint) for node in system.nodes if node.blueprint is not None and not node.external}
    return len(nodes) <= _NODES


__all__ = ["is_lesson"]
