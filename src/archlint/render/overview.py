"""A workspace too large to draw each node: a box for each package or namespace, and what runs between."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.render import look
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    import networkx

Pair = tuple[str, str]


def box_sizes(graph: networkx.MultiDiGraph) -> dict[str, int]:
    """How many nodes each box stands for; nodes of no group have a box of their own, called ``""``."""
    groups = look.groups(graph)
    sizes = Counter(groups.get(key, "") for key, kind in graph.nodes(data="kind") if kind == NODE)
    return dict(sorted(sizes.items()))


def streams(graph: networkx.MultiDiGraph) -> dict[Pair, Counter[str]]:
    """From box to box: how many topics, services and actions.  What stays inside a box is left out."""
    groups = look.groups(graph)
    counts: dict[Pair, Counter[str]] = {}
    for key, kind in graph.nodes(data="kind"):
        if kind == NODE:
            continue
        tails = {groups.get(node, "") for node in graph.predecessors(key)}
        heads = {groups.get(node, "") for node in graph.successors(key)}
        for pair in ((tail, head) for tail in tails for head in heads if tail != head):
            counts.setdefault(pair, Counter())[kind] += 1
    return dict(sorted(counts.items()))


def words(kinds: Counter[str]) -> str:
    """``3 topics\\n1 service``."""
    return "\n".join(look.counted(kinds[kind], kind) for kind in ("topic", "service", "action") if kinds[kind])
