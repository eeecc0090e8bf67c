"""The control flow of a piece of source, asked by the names of what its statements call."""

from __future__ import annotations

import textwrap

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of, may_run_again
from archlint.syntax.flow_blocks import Block, any_edge, without_exceptions
from archlint.syntax.flow_graph import Graph
from archlint.syntax.python.lowering import lower
from archlint.syntax.walk import called_name, calls_in, statements_of


def body(source: str) -> list[facts.Stmt]:
    return lower(textwrap.dedent(source)).body


class Flow:
    """The graph of a piece of source, asked by the names of what its statements call."""

    def __init__(self, source: str) -> None:
        self.body = body(source)
        self.graph: Graph = graph_of(self.body)

    def blocks(self, name: str) -> list[Block]:
        return [block for block in self.graph.blocks if name in names_of(block)]

    def block(self, name: str) -> Block:
        [found] = self.blocks(name)
        return found

    def runs(self, name: str) -> bool:
        return bool(self.blocks(name))

    def dominates(self, first: str, second: str) -> bool:
        return self.graph.dominates([self.block(first)], self.block(second))

    def always_followed(self, first: str, second: str, *, though_it_raises: bool = False) -> bool:
        along = any_edge if though_it_raises else without_exceptions
        return self.graph.post_dominates([self.block(second)], self.block(first), along)

    def loops(self) -> list[facts.While | facts.For]:
        return [one for one in statements_of(self.body) if isinstance(one, (facts.While, facts.For))]

    def repeats_after(self, name: str) -> bool:
        """Whether the outermost loop may go round again after a statement."""
        loop = self.loops()[0]
        *_, statement = [one for one in statements_of(loop.body) if names_of_fact(one) == [name]]
        return may_run_again(loop, statement)


def names_of_fact(fact: object) -> list[str]:
    return [called_name(call) for call in calls_in(fact)]


def names_of(block: Block) -> list[str]:
    return [] if block.fact is None else names_of_fact(block.fact)
