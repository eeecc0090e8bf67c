"""The control flow graph of a function, or of any other piece of code.

It is built from the back: each statement is given the block that comes after it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache

from archlint.syntax import facts
from archlint.syntax.flow_blocks import Block, Edge, Kind, Loop, reach
from archlint.syntax.flow_graph import ExitBlocks, Graph
from archlint.syntax.parts import Itself

_Final = Callable[[Block], Block]
"""A ``finally``: where it begins if it is to lead on to a block."""
_EXITS = frozenset({"sys.exit", "os._exit", "os.abort", "exit", "quit"})
"""Calls that end the program."""


def graph_of(body: Sequence[facts.Stmt]) -> Graph:
    """The control flow graph of the body of a function, or of any block of it."""
    return _graph_of(Itself(body))


@lru_cache(maxsize=4096)
def _graph_of(key: Itself[Sequence[facts.Stmt]]) -> Graph:
    return _build(key.fact)


def loop_of(statement: facts.While | facts.For) -> Loop:
    """A loop by itself, whatever is around it."""
    return _loop_of(Itself(statement))[1]


@lru_cache(maxsize=4096)
def _loop_of(key: Itself[facts.While | facts.For]) -> tuple[Graph, Loop]:
    graph = _build([key.fact])
    loop = graph.loop(key.fact)
    assert loop is not None, "what is first in a piece of code does run"
    return graph, loop


def always_raises(body: Sequence[facts.Stmt]) -> bool:
    """Whether every way through a block ends in an exception that leaves it."""
    graph = graph_of(body)
    return reach([graph.entry]).isdisjoint(block for block in graph.exits if block is not graph.raised)


def may_run_again(statement: facts.While | facts.For, inside: facts.Stmt) -> bool:
    """Whether a loop may repeat after a statement in it has run: not where ``break``, ``return`` or ``raise``
    always follows it."""
    if inside is statement or isinstance(inside, facts.Global):
        return True
    graph, loop = _loop_of(Itself(statement))
    return loop.repeats_after(graph.at(inside))


# ---------------------------------------------------------------------------------------------- building it


def _build(body: Sequence[facts.Stmt]) -> Graph:
    exit_blocks = ExitBlocks()
    builder = _Builder(exit_blocks)
    entry = builder.block(body, exit_blocks.end, _Around(exit_blocks.raised, exit_blocks.left, exit_blocks.left))
    blocks = _in_order(entry)
    for block in blocks:
        for loop in block.loops:
            loop.blocks.append(block)
    return Graph(entry, blocks, exit_blocks)


def _in_order(entry: Block) -> list[Block]:
    """The blocks that run at all, in reverse postorder: but for loops, each after all that come before it."""
    order: list[Block] = []
    seen = {entry}
    stack = [(entry, iter(entry.edges))]
    while stack:
        block, edges = stack[-1]
        edge = next(edges, None)
        if edge is None:
            stack.pop()
            order.append(block)
        elif edge.target not in seen:
            seen.add(edge.target)
            stack.append((edge.target, iter(edge.target.edges)))
    return order[::-1]


class _Around:
    """What is around a statement: where it leads to if it leaves it.

    ``finals`` are every ``finally`` around it, outermost first, each a copy that leads on to a block; so many of them
    as ``finals_of_loop`` are around its innermost loop, too.
    """

    __slots__ = ("breaks", "continues", "finals", "finals_of_loop", "loops", "raises")

    def __init__(
        self,
        raises: Block,
        breaks: Block,
        continues: Block,
        finals: tuple[_Final, ...] = (),
        finals_of_loop: int = 0,
        loops: tuple[Loop, ...] = (),
    ) -> None:
        self.raises = raises
        self.breaks = breaks
        self.continues = continues
        self.finals = finals
        self.finals_of_loop = finals_of_loop
        self.loops = loops

    def in_loop(self, head: Block, then: Block) -> _Around:
        """The same inside a loop."""
        return _Around(self.raises, then, head, self.finals, len(self.finals), head.loops)

    def in_try(self, raises: Block, *final: _Final) -> _Around:
        """The same where an exception leads elsewhere, and perhaps every way out through a ``finally``."""
        finals = (*self.finals, *final)
        return _Around(raises, self.breaks, self.continues, finals, self.finals_of_loop, self.loops)

    def leaving_loop(self, target: Block) -> Block:
        """Where ``break`` or ``continue`` leads to: through every ``finally`` inside the loop."""
        return self._through(self.finals[self.finals_of_loop :], target)

    def leaving_function(self, target: Block) -> Block:
        return self._through(self.finals, target)

    @staticmethod
    def _through(finals: Sequence[_Final], target: Block) -> Block:
        for final in finals:
            target = final(target)
        return target


class _Builder:
    def __init__(self, exit_blocks: ExitBlocks) -> None:
        self.exit_blocks = exit_blocks

    def block(self, body: Sequence[facts.Stmt], then: Block, around: _Around) -> Block:
        """Where a block begins that leads on to ``then``."""
        for statement in reversed(body):
            then = self.statement(statement, then, around)
        return then

    def statement(self, s: facts.Stmt, then: Block, around: _Around) -> Block:
        match s:
            case facts.If():
                return self.choice(s, then, around)
            case facts.While():
                return self.repeat(s, then, around)
            case facts.For():
                return self.iteration(s, then, around)
            case facts.Try():
                return self.attempt(s, then, around)
            case facts.With():
                then = self.block(s.body, then, around)
                for item in reversed(s.items):
                    then = _link(_evaluating(item.value, s, around), then)
                return then
            case facts.Match():
                return self.match(s, then, around)
            case facts.Return():
                return self.exit(s, around)
            case facts.Jump(kind="break"):
                return _link(Block(None, s, around.loops), around.leaving_loop(around.breaks))
            case facts.Jump(kind="continue"):
                return _link(Block(None, s, around.loops), around.leaving_loop(around.continues))
            case facts.Jump() | facts.Function() | facts.Class() | facts.Import() | facts.ImportFrom() | facts.Global():
                return _link(Block(None, s, around.loops), then)
        block = _evaluating(s, s, around)
        block.leaves = _never_completes(s)
        return block if block.leaves else _link(block, then)

    def exit(self, s: facts.Return, around: _Around) -> Block:
        leaves = Block()
        self.exit_blocks.returns.append((s, leaves))
        block = Block(s, s, around.loops) if s.value is None else _evaluating(s, s, around)
        block.leaves = True
        return _link(block, around.leaving_function(leaves))

    def choice(self, s: facts.If, then: Block, around: _Around) -> Block:
        test = _evaluating(s.test, s, around)
        always = s.test.truth
        for holds, body in ((True, s.body), (False, s.orelse)):
            if always is None or always is holds:
                _link(test, self.block(body, then, around), s.test, holds)
        return test

    def repeat(self, s: facts.While, then: Block, around: _Around) -> Block:
        head = _evaluating(s.test, s, around)
        self.loop_body(s, head, then, around, s.test)
        if not s.is_endless:
            _link(head, self.block(s.orelse, then, around), s.test, False)
        return head

    def iteration(self, s: facts.For, then: Block, around: _Around) -> Block:
        """The iterable is evaluated once; the head takes the next item of it."""
        head = _evaluating(None, s, around)
        self.loop_body(s, head, then, around)
        _link(head, self.block(s.orelse, then, around))
        return _link(_evaluating(s.iterable, s, around), head)

    def loop_body(
        self, s: facts.While | facts.For, head: Block, then: Block, around: _Around, test: facts.Expr | None = None
    ) -> None:
        head.loops = (*around.loops, Loop(s, head))
        _link(head, self.block(s.body, head, around.in_loop(head, then)), test)

    def attempt(self, s: facts.Try, then: Block, around: _Around) -> Block:
        if s.final:
            final = self.copies_of(s.final, around)
            then = final(then)
            around = around.in_try(final(around.raises), final)
        raised = Block(None, None, around.loops)
        for handler in s.handlers:
            _link(raised, self.block(handler.body, then, around))
        if all(handler.type is not None for handler in s.handlers):
            raised.edges.append(Edge(raised, around.raises, Kind.RAISE))
        orelse = self.block(s.orelse, then, around)
        inside = around.in_try(raised)
        return _link(_evaluating(None, s, inside), self.block(s.body, orelse, inside))

    def copies_of(self, final: Sequence[facts.Stmt], around: _Around) -> _Final:
        """A ``finally``, once for each block that it leads on to."""
        copies: dict[Block, Block] = {}

        def leading_to(target: Block) -> Block:
            if target not in copies:
                copies[target] = self.block(final, target, around)
            return copies[target]

        return leading_to

    def match(self, s: facts.Match, then: Block, around: _Around) -> Block:
        subject = _evaluating(s.subject, s, around)
        entries = [then]
        for case in reversed(s.cases):
            always = case.pattern.kind == "capture"
            begins = self.block(case.body, then, around)
            if case.guard is not None:
                guard = _link(_evaluating(case.guard, s, around), begins, case.guard)
                for other in entries:
                    _link(guard, other, case.guard, False)
                begins = guard
            entries = [begins] if always else [begins, *entries]
        for entry in entries:
            _link(subject, entry)
        return subject


def _evaluating(fact: facts.Base | None, s: facts.Stmt | None, around: _Around) -> Block:
    """A block that may raise."""
    block = Block(fact, s, around.loops)
    block.edges.append(Edge(block, around.raises, Kind.RAISE))
    return block


def _link(block: Block, target: Block, test: facts.Expr | None = None, holds: bool = True) -> Block:
    back = any(target is loop.head for loop in block.loops)
    block.edges.append(Edge(block, target, Kind.BACK if back else Kind.NEXT, test, holds))
    return block


def _never_completes(s: facts.Stmt) -> bool:
    """``raise``, ``sys.exit()`` and ``assert False``."""
    match s:
        case facts.Raise():
            return True
        case facts.Assert(test):
            return test.truth is False
        case facts.Expression(value=facts.Call(func=called)):
            return called.dotted in _EXITS
    return False


__all__ = ["always_raises", "graph_of", "loop_of", "may_run_again"]
