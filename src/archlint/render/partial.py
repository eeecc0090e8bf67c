"""The part of a system that a view selects, for the formats that are made of systems."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.diagram.choosing import network_of
from archlint.render.diagram.parts import parts_of
from archlint.render.picture import graph_of
from archlint.render.selection import selected
from archlint.systems.graph import interface_key, node_keys

if TYPE_CHECKING:
    from archlint.render.view import View
    from archlint.systems.graph import Key
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


def part_of(system: System, view: View) -> System:
    """The nodes that are shown, with those of their ends that are."""
    return only(system, selected(network_of(parts_of(system, graph_of(system))), view))


def only(system: System, keys: Set[Key]) -> System:
    """A system with some nodes and interfaces, by the keys of :mod:`archlint.systems.graph`."""
    names = node_keys(system)

    def shown(nodes: tuple[Node, ...]) -> list[Node]:
        return [_with_ends(node, keys) for node in nodes if names[id(node)] in keys]

    return replace(
        system,
        nodes=shown(tuple(system.nodes)),
        unowned=shown(tuple(system.unowned)),
        neighbours=shown(tuple(system.neighbours)),
    )


def _with_ends(node: Node, keys: Set[Key]) -> Node:
    kept = tuple(end.named for end in node.endpoints if interface_key(end) in keys)
    return node if len(kept) == len(node.creations) else replace(node, creations=kept)


__all__ = ["only", "part_of"]
