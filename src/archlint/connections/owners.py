"""Nodes that run together and publish or serve the same name, each with something of its own to say."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.coexistence import (
    coexisting_pairs,
    in_source_order,
    known_to_coexist,
    launched_separately,
    named_by_library,
)
from archlint.analysis.left_over import is_left_over, is_left_unmade
from archlint.connections.arbitration import is_replaced, never_speaks, only_stops, speaks_once
from archlint.connections.in_sequence import run_in_sequence
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node


def several_owners(system: System, connection: Connection) -> Iterator[list[Endpoint]]:
    """Groups of endpoints of different nodes that meet; the last one in the source comes last."""
    groups: list[list[Endpoint]] = []
    if all(end.node is connection.providers[0].node for end in connection.providers):
        return  # as most are, and whether an endpoint owns takes longer to ask
    own = [end for end in connection.providers if _owns(system, end)]
    for owner, other in coexisting_pairs(system, own):
        if (
            owner.node is other.node
            or launched_separately(system, owner.node, other.node)
            or _left_out(owner.node, other.node)
            or run_in_sequence(system, owner, other)
        ):
            continue
        group = next((group for group in groups if owner in group or other in group), None)
        if group is None:
            groups.append([owner, other])
        else:
            group.extend(endpoint for endpoint in (owner, other) if endpoint not in group)
    for group in groups:
        yield in_source_order(group)


def _owns(system: System, end: Endpoint) -> bool:
    """Whether a publisher or server says something of its own, in code that is in use."""
    if end.external:
        return True
    idle = named_by_library(end) or is_left_over(system.workspace, end) or speaks_once(system, end)
    idle = idle or only_stops(system, end) or is_replaced(system, end)
    if end.node.blueprint is not None:
        blueprint = end.node.blueprint
        idle = idle or is_left_unmade(system.workspace, blueprint.place.file, blueprint.class_name)
    if system.name is not None and end.kind == EntityKind.PUBLISHER:
        idle = idle or never_speaks(end)  # a launch file says which program it is
    return not idle and (system.name is not None or not is_aside(system.workspace, end.place.file))


def _left_out(node: Node, other: Node) -> bool:
    """Whether a script starts the one of two nodes that it defines, and leaves the other out."""
    if node.blueprint is None or other.blueprint is None or node.program is None or other.program is None:
        return False
    one_file = node.blueprint.place.file == other.blueprint.place.file
    return one_file and node.program.executable != other.program.executable


def some_coexist(system: System, owners: list[Endpoint]) -> bool:
    """Whether something is seen to start two of them together."""
    return system.closed or any(known_to_coexist(system, a.node, b.node) for a, b in combinations(owners, 2))
