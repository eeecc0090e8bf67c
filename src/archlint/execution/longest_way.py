"""How long the longest way through a callback takes: of branches that exclude each other, one is taken."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.syntax.control_flow import graph_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.syntax.flow_blocks import Block
    from archlint.syntax.flow_graph import Graph

Stretch = tuple[Sequence["Place"], float]
"""The calls that lead to what takes time, it last, and the seconds."""


def longest_way(code: SourceCode, stretches: Sequence[Stretch]) -> float:
    """The seconds on the longest way through the functions that some calls are in, the rounds of loops left out: who
    asks has counted them in."""
    by_function: dict[int, dict[Place, list[Stretch]]] = defaultdict(dict)
    for path, seconds in stretches:
        here = by_function[id(code.body_at(path[0]))]
        here.setdefault(path[0], []).append((path[1:], seconds))
    return sum(_through(code, here) for here in by_function.values())


def _through(code: SourceCode, at: dict[Place, list[Stretch]]) -> float:
    """The same in one function, of what its calls lead to."""
    graph = graph_of(code.body_at(next(iter(at))))
    takes: defaultdict[Block, float] = defaultdict(float)
    unplaced = 0.0
    for place, stretches in at.items():
        seconds = sum(seconds for rest, seconds in stretches if not rest)
        seconds += longest_way(code, [stretch for stretch in stretches if stretch[0]])
        blocks = graph.evaluating(place.span)
        for block in blocks:
            takes[block] += seconds
        unplaced += 0.0 if blocks else seconds
    return unplaced + _longest(graph, takes)


def _longest(graph: Graph, takes: dict[Block, float]) -> float:
    """The greatest sum on a way from the entry that goes back to no earlier block."""
    order = {block: number for number, block in enumerate(graph.blocks)}
    until = dict.fromkeys(graph.blocks, 0.0)
    for block in graph.blocks:
        until[block] += takes.get(block, 0.0)
        for edge in block.edges:
            if order.get(edge.target, -1) > order[block]:
                until[edge.target] = max(until[edge.target], until[block])
    return max(until.values(), default=0.0)


__all__ = ["longest_way"]
