"""The parts of a control flow graph: blocks, the edges that lead on from them, loops."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from enum import Enum, auto

from archlint.syntax import facts
from archlint.syntax.flow_facts import sufficient


class Kind(Enum):
    """How an edge leads on."""

    NEXT = auto()
    BACK = auto()
    """To the head of a loop around it."""
    RAISE = auto()
    """Where an exception goes."""


class Block:
    """One statement or the head of one; ``fact`` is what it evaluates, ``loops`` are those that it is in, outermost
    first.

    With ``leaves`` it is ``return``, ``raise`` or an end of the program: where that raises, it has not had its effect.
    """

    __slots__ = ("edges", "fact", "leaves", "loops", "statement")

    def __init__(
        self, fact: facts.Base | None = None, statement: facts.Stmt | None = None, loops: tuple[Loop, ...] = ()
    ) -> None:
        self.fact = fact
        self.statement = statement
        self.loops = loops
        self.leaves = False
        self.edges: list[Edge] = []


class Edge:
    """A way from one block to another, taken where ``test`` comes out as ``holds``."""

    __slots__ = ("holds", "kind", "source", "target", "test")

    def __init__(
        self, source: Block, target: Block, kind: Kind, test: facts.Expr | None = None, holds: bool = True
    ) -> None:
        self.source = source
        self.target = target
        self.kind = kind
        self.test = test
        self.holds = holds

    @property
    def sufficient(self) -> list[tuple[facts.Expr, bool]]:
        """The conditions each of which is enough that it is taken, with how they come out."""
        return [] if self.test is None else list(sufficient(self.test, self.holds))


Along = Callable[[Edge], bool]
"""Which edges count."""


def any_edge(edge: Edge) -> bool:
    """Every edge."""
    return True


def without_exceptions(edge: Edge) -> bool:
    """The edges that code takes as long as nothing raises but ``raise`` itself, or what ends the program."""
    return edge.kind is not Kind.RAISE or len(edge.source.edges) == 1


def reach(starts: Collection[Block], along: Along = any_edge, avoiding: Collection[Block] = ()) -> set[Block]:
    """The blocks that may run from some blocks on, these included, on ways that keep clear of others."""
    waiting = [block for block in starts if block not in avoiding]
    reached = set(waiting)
    while waiting:
        for edge in waiting.pop().edges:
            if edge.target not in reached and edge.target not in avoiding and along(edge):
                reached.add(edge.target)
                waiting.append(edge.target)
    return reached


class Loop:
    """A loop: its ``head`` decides about each round; ``blocks`` are those of its head and its body that run at all."""

    __slots__ = ("blocks", "head", "statement")

    def __init__(self, statement: facts.While | facts.For, head: Block) -> None:
        self.statement = statement
        self.head = head
        self.blocks: list[Block] = []

    @property
    def exits(self) -> Iterator[Edge]:
        """The edges that leave it, exceptions among them."""
        return (edge for block in self.blocks for edge in block.edges if self not in edge.target.loops)

    @property
    def is_left_early(self) -> bool:
        """Whether ``break``, ``return`` or ``raise`` in its body may end it."""
        return self.is_left_by_jump or any(edge.kind is Kind.RAISE and edge.source.leaves for edge in self.exits)

    @property
    def is_left_by_jump(self) -> bool:
        """Whether ``break`` or ``return`` in its body may end it."""
        return any(edge.source is not self.head and edge.kind is not Kind.RAISE for edge in self.exits)

    @property
    def repeats(self) -> bool:
        """Whether it may repeat at all."""
        return self.repeats_after([self.head])

    def repeats_after(self, blocks: Sequence[Block]) -> bool:
        """Whether it may repeat once some of its blocks have run."""
        own = [block for block in blocks if self in block.loops]
        after = [edge for block in own for edge in block.edges if edge.kind is not Kind.RAISE or not block.leaves]
        inside = reach([edge.target for edge in after if self._stays_within(edge)], along=self._stays_within)
        after += [edge for block in inside for edge in block.edges]
        return any(edge.target is self.head for edge in after)

    @property
    def endings(self) -> list[Edge]:
        """The edges that end it for certain when they are taken, of conditions that are asked in every round."""
        return [
            edge
            for block in self.blocks
            for edge in block.edges
            if edge.test is not None and self._ends_it(edge) and self.is_in_every_round(block)
        ]

    @property
    def is_left_otherwise(self) -> bool:
        """Whether ``break``, ``return`` or ``raise`` in its body may end it where none of its ``endings`` is taken."""
        endings = self.endings
        blocks = reach([self.head], lambda edge: edge not in endings and self in edge.target.loops)
        leaving = (edge for block in blocks - {self.head} for edge in block.edges if self not in edge.target.loops)
        return any(edge not in endings and (edge.kind is not Kind.RAISE or edge.source.leaves) for edge in leaving)

    def _ends_it(self, edge: Edge) -> bool:
        inside = reach([edge.target] if self._stays_within(edge) else [], self._stays_within)
        onward = [edge, *(later for block in inside for later in block.edges)]
        return all(later.target is not self.head for later in onward)

    def is_in_every_round(self, *blocks: Block) -> bool:
        """Whether no round that leads to another one goes past all of some blocks."""
        if self.head in blocks:
            return True
        begins = [edge.target for edge in self.head.edges if self._stays_within(edge)]
        others = reach(begins, self._stays_within, avoiding=blocks)
        return all(edge.target is not self.head for other in others for edge in other.edges)

    def _stays_within(self, edge: Edge) -> bool:
        return edge.target is not self.head and self in edge.target.loops


__all__ = ["Along", "Block", "Edge", "Kind", "Loop", "any_edge", "reach", "without_exceptions"]
