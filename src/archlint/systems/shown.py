"""What of a system was asked for: its nodes, and at the other end of what they have, their neighbours."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace

from archlint.systems.graph import INTERFACE_OF
from archlint.systems.model import System
from archlint.systems.nodes import Endpoint, Node


def only(system: System, context: Set[str]) -> System:
    """The system with the nodes that are not of ``context`` files, which were read but not asked for.

    Of the other nodes those ends stay that are connected to one that is shown.
    """
    shown: list[Node] = []
    others: list[Node] = []
    for node in system.entries:
        (others if _is_context(node, context) else shown).append(node)
    if not others:
        return system
    names = {_interface(end) for node in shown for end in node.endpoints}
    neighbours = [_sharing(node, names) for node in others if node.is_node and not node.test]
    return replace(system, nodes=shown, unowned=[], neighbours=[node for node in neighbours if node.endpoints])


def _sharing(node: Node, names: Set[tuple[str, str | None]]) -> Node:
    """A node with those of its ends that have one of the names."""
    return replace(node, creations=tuple(e.named for e in node.endpoints if e.resolved and _interface(e) in names))


def _is_context(node: Node, context: Set[str]) -> bool:
    """Whether a node's source was not asked for; without a source, whether the launch file that starts it was not."""
    place = node.blueprint.place if node.blueprint is not None else node.launch_place
    return place is not None and place.file in context


def _interface(end: Endpoint) -> tuple[str, str | None]:
    """What an end is an end of."""
    return INTERFACE_OF[end.kind], end.name
