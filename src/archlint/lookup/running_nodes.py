"""The nodes of a workspace as they run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.lookup.index import Index

if TYPE_CHECKING:
    from archlint.systems.nodes import Node


def running_nodes(index: Index) -> list[Node]:
    """The nodes as they run: as a launch file starts them, or else as the code alone has them."""
    best: dict[object, int] = {}
    for system, rank in index.systems:
        for node in system.nodes:
            best[_class(node)] = min(rank, best.get(_class(node), rank))
    rows = [(node, rank) for system, rank in index.systems for node in system.nodes]
    nodes = {(n.name, n.launched_by, _class(n)): n for n, rank in rows if best[_class(n)] == rank}
    return sorted(nodes.values(), key=lambda node: (node.name or "", node.launched_by or ""))


def _class(node: Node) -> object:
    return (
        (node.package, node.executable) if node.blueprint is None else (node.blueprint.place, node.blueprint.class_name)
    )


__all__ = ["running_nodes"]
