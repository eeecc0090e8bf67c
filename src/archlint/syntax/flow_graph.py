"""A control flow graph and what can be asked of it: what may run after what.

A block holds one statement, or the head of one (a condition, what a ``with`` enters), since each may raise.  Edges lead
on: to what runs next, back to the head of a loop, or to where an exception goes.  A ``finally`` is there once for each
place that it may lead on to, so that a way through the graph is a way through the code.

All questions come down to reaching blocks: one dominates another if nothing reaches the other without it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Hashable, Sequence
from functools import cached_property
from typing import Any, Generic, TypeVar

from archlint.syntax import facts
from archlint.syntax.flow_blocks import Along, Block, Edge, Kind, Loop, any_edge, reach, without_exceptions
from archlint.syntax.flow_deciders import Deciders
from archlint.syntax.flow_facts import covers, ends_of, is_within, lines_of
from archlint.syntax.flow_outcomes import Outcomes

State = TypeVar("State", bound=Hashable)
Answer = TypeVar("Answer")


FEW = 2000
"""With fewer blocks, all copies of a block are looked at together."""


class Ends(Generic[State]):
    """The ends of a body: each ``return`` with the states that reach it, and those that run off the end."""

    def __init__(
        self, returns: list[tuple[facts.Return, frozenset[State]]], falls: frozenset[State] = frozenset()
    ) -> None:
        self.returns = returns
        self.falls = falls


class ExitBlocks:
    """How a piece of code can be left: off its ``end``, by an exception (``raised``), by ``break`` or ``continue`` of a
    loop that is around all of it (``left``), and by each ``return``, with what comes after it and after all that
    ``finally`` still does."""

    def __init__(self) -> None:
        self.end, self.raised, self.left = Block(), Block(), Block()
        self.returns: list[tuple[facts.Return, Block]] = []


class Graph:
    """The control flow of a piece of code, from ``entry`` on; ``blocks`` are all that may run, in an order in which
    what comes first stands first."""

    def __init__(self, entry: Block, blocks: list[Block], exit_blocks: ExitBlocks) -> None:
        self.entry = entry
        self.blocks = blocks
        self.end = exit_blocks.end
        self.raised = exit_blocks.raised
        self.left = exit_blocks.left
        reached = set(blocks)
        self.returns = [(statement, exit_) for statement, exit_ in exit_blocks.returns if exit_ in reached]
        self._answers: dict[tuple[object, frozenset[Block]], list[Any]] = {}
        self._inside: dict[tuple[int, ...], frozenset[Block]] = {}
        self._decided: dict[tuple[frozenset[Block], frozenset[Block]], set[Block]] = {}

    @property
    def exits(self) -> list[Block]:
        """Every way out."""
        return [self.end, self.raised, self.left, *(block for _, block in self.returns)]

    def at(self, statement: facts.Stmt) -> list[Block]:
        """The blocks of a statement and of what is inside it, as far as they run."""
        first, last = ends_of(statement)
        return [
            block for block in self.blocks if block.statement is not None and is_within(block.statement, first, last)
        ]

    def inside(self, statements: Sequence[facts.Stmt]) -> frozenset[Block]:
        """The blocks of statements and of what is inside them, as far as they run; kept, for it is asked of a branch
        once for each variable."""
        key = tuple(map(id, statements))  # of facts that the graph keeps alive
        known = self._inside.get(key)
        if known is None:
            known = self._inside[key] = frozenset(block for each in statements for block in self.at(each))
        return known

    def loop(self, statement: facts.While | facts.For) -> Loop | None:
        """The loop that a statement is; None where it never runs."""
        loops = (loop for block in self.blocks for loop in block.loops)
        return next((loop for loop in loops if loop.statement is statement), None)

    def of(self, statement: facts.Stmt) -> list[Block]:
        """The blocks of a statement itself, without those of what is inside it: of an ``if`` its condition."""
        return list(self._of_statements.get(id(statement), ()))

    @cached_property
    def _of_statements(self) -> dict[int, list[Block]]:
        blocks: dict[int, list[Block]] = {}
        for block in self.blocks:
            if block.statement is not None:
                blocks.setdefault(id(block.statement), []).append(block)
        return blocks

    @cached_property
    def without_exceptions(self) -> set[Block]:
        """The blocks that run as long as nothing raises."""
        return reach([self.entry], without_exceptions)

    def evaluating(self, span: facts.Span) -> list[Block]:
        """The blocks that evaluate what stands at a place; a ``finally`` has several."""
        on_line = self._on_lines.get(span[0], ())
        return [block for block in on_line if block.fact is not None and covers(block.fact, span)]

    @cached_property
    def _on_lines(self) -> dict[int, list[Block]]:
        """The blocks that evaluate something that stands on a line, or around it."""
        blocks: dict[int, list[Block]] = {}
        for block in self.blocks:
            if block.fact is not None:
                for line in lines_of(block.fact):
                    blocks.setdefault(line, []).append(block)
        return blocks

    def dominates(self, first: Collection[Block], block: Block, along: Along = any_edge) -> bool:
        """Whether every way from the start to a block goes through one of others first."""
        return block not in reach([self.entry], along, avoiding=first)

    def post_dominates(self, last: Collection[Block], block: Block, along: Along = any_edge) -> bool:
        """Whether every way from a block to an end goes through one of others."""
        return reach([block], along, avoiding=last).isdisjoint(self.exits)

    def before(
        self, targets: Collection[Block], along: Along = any_edge, avoiding: Collection[Block] = ()
    ) -> set[Block]:
        """The blocks from which some block may be reached on a way that keeps clear of others; of these blocks those
        that come round to one again."""
        waiting, sources = list(targets), set[Block]()
        while waiting:
            for edge in self._edges_to.get(waiting.pop(), ()):
                if edge.source not in sources and edge.source not in avoiding and along(edge):
                    sources.add(edge.source)
                    waiting.append(edge.source)
        return sources

    def between(self, first: Collection[Block], last: Collection[Block], along: Along = any_edge) -> set[Block]:
        """The blocks that may run after one block and before another, on ways that come to neither again."""
        after = reach([edge.target for block in first for edge in block.edges if along(edge)], along, avoiding=first)
        return after & self.before(last, along, avoiding=[*first, *last])

    def _once(self, ask: Callable[[Collection[Block]], list[Answer]], targets: Collection[Block]) -> list[Answer]:
        """The answer to a question about blocks, the same for all that run whenever these do."""
        key = ask, frozenset(self._begins.get(block, block) for block in targets)
        if key not in self._answers:
            self._answers[key] = ask(key[1])
        return list(self._answers[key])

    @cached_property
    def _begins(self) -> dict[Block, Block]:
        """For a block in a row of those that run one after the other unless one raises, the first of them."""
        begins: dict[Block, Block] = {}
        for block in self.blocks:
            match self._edges_to.get(block):
                case [Edge(kind=Kind.NEXT, test=None, source=before)] if before.loops == block.loops:
                    if sum(edge.kind is not Kind.RAISE for edge in before.edges) == 1:
                        begins[block] = begins.get(before, before)
        return begins

    def outcomes(self, targets: Collection[Block]) -> list[Edge]:
        """How conditions have come out on every way to some blocks: around them, and in front of them where the other
        outcome leaves.  One edge stands for all copies of a condition."""
        return self._once(self._outcomes.at, targets)

    @cached_property
    def _outcomes(self) -> Outcomes:
        return Outcomes(self.entry, self.blocks)

    def deciders(self, targets: Collection[Block]) -> list[Block]:
        """The blocks that decide whether some blocks are reached, as long as nothing raises, and those that decide
        about these: one way on leads there for certain, another may not.  Inside a loop each round counts by itself.
        """
        return self._once(self._deciders_of, targets)

    def _deciders_of(self, targets: Collection[Block]) -> list[Block]:
        if self._has_copies and len(self.blocks) < FEW:
            deciders = self._deciders_with_copies(targets)
        else:
            deciders = set[Block]().union(*(self._deciders.of(block) for block in targets))
        return sorted(deciders, key=self._order.__getitem__)

    @cached_property
    def _order(self) -> dict[Block, int]:
        return {block: number for number, block in enumerate(self.blocks)}

    @cached_property
    def _deciders(self) -> Deciders:
        return Deciders(self.blocks)

    @cached_property
    def _has_copies(self) -> bool:
        """Whether a block is there several times: for each way out of a ``finally``."""
        rows = [(id(block.statement), id(block.fact)) for block in self.blocks if block.statement is not None]
        return len(rows) > len(set(rows))

    def _deciders_with_copies(self, targets: Collection[Block]) -> set[Block]:
        """What decides whether one of some copies is reached, each time held against the whole graph."""
        heads = {loop.head for block in targets for loop in block.loops}
        deciders: set[Block] = set()
        waiting = [set(targets)]
        while waiting:
            key = frozenset(waiting.pop()), frozenset(heads)
            if key not in self._decided:
                self._decided[key] = self._decide_about(set(key[0]), heads)
            for block in self._decided[key] - deciders:
                deciders.add(block)
                siblings = (
                    {row for row in self.of(block.statement) if row.fact is block.fact} if block.statement else ()
                )
                waiting.append(siblings or {block})
        return deciders

    def _decide_about(self, targets: set[Block], heads: set[Block]) -> set[Block]:
        def goes_on(edge: Edge) -> bool:
            return without_exceptions(edge) and not (edge.kind is Kind.BACK and edge.target in heads)

        repeating = [edge.source for head in heads for edge in self._edges_to.get(head, ()) if edge.kind is Kind.BACK]
        ends = [block for block in (*self.exits, *repeating) if block not in targets]
        missing = self.before(ends, goes_on, avoiding=targets).union(ends)
        certain = (self.before(targets, goes_on) | targets) - missing
        return {edge.source for block in certain for edge in self._edges_to.get(block, ()) if goes_on(edge)} & missing

    @cached_property
    def _edges_to(self) -> dict[Block, list[Edge]]:
        incoming: dict[Block, list[Edge]] = {}
        for block in self.blocks:
            for edge in block.edges:
                incoming.setdefault(edge.target, []).append(edge)
        return incoming

    def states(
        self,
        start: State,
        step: Callable[[State, facts.Base], State],
        branch: Callable[[State, facts.Expr, bool], State | None] | None = None,
        raises: Callable[[facts.Base], bool] | None = None,
    ) -> dict[Block, frozenset[State]]:
        """The states in which each block may begin: a forward analysis to its fixed point.

        ``step`` gives the state after what a block evaluates, ``branch`` that after a condition which has come out so,
        None where it cannot in that state.  What raises may have had its effect or not; ``raises`` says whether what a
        block evaluates can, anything by default.
        """
        entry_states: dict[Block, frozenset[State]] = {self.entry: frozenset({start})}
        waiting = deque([self.entry])
        while waiting:
            block = waiting.popleft()
            before = entry_states[block]
            fact = block.fact
            after = before if fact is None else frozenset(step(state, fact) for state in before)
            for edge in block.edges:
                if edge.kind is Kind.RAISE and raises is not None and not _may_raise(block, raises):
                    continue
                if edge.kind is Kind.RAISE:
                    states = before if block.leaves else before | after
                else:
                    states = _entering(after, edge, branch)
                known = entry_states.get(edge.target, frozenset())
                if not states <= known:
                    entry_states[edge.target] = known | states
                    waiting.append(edge.target)
        return entry_states

    def ends(
        self,
        start: State,
        step: Callable[[State, facts.Base], State],
        branch: Callable[[State, facts.Expr, bool], State | None] | None = None,
        raises: Callable[[facts.Base], bool] | None = None,
    ) -> Ends[State]:
        """The states in which it can end, other than by an exception; as :meth:`states`."""
        entry_states = self.states(start, step, branch, raises)
        returns = [(end, entry_states[block]) for end, block in self.returns if block in entry_states]
        return Ends(returns, entry_states.get(self.end, frozenset()))


def _may_raise(block: Block, raises: Callable[[facts.Base], bool]) -> bool:
    """Whether something of a block may raise: a ``try`` that only begins evaluates nothing."""
    return not isinstance(block.statement, facts.Try) if block.fact is None else raises(block.fact)


def _entering(
    states: frozenset[State], edge: Edge, branch: Callable[[State, facts.Expr, bool], State | None] | None
) -> frozenset[State]:
    if branch is None or edge.test is None:
        return states
    entered = (branch(state, edge.test, edge.holds) for state in states)
    return frozenset(state for state in entered if state is not None)
