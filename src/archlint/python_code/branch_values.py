"""Local variables that one branch of an ``if`` leaves without a value, and that are read behind it whichever was taken.

Only a branch that is written down counts: whoever writes ``else:`` says that it may be taken.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.python_code.block_bindings import after
from archlint.syntax import facts
from archlint.syntax.flow_blocks import Block, reach, without_exceptions
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.syntax.flow_graph import Graph

Reading = tuple[Block, facts.Name, bool]
"""Where a variable is read, and whether that block surely does."""
_LEAVING = frozenset(
    {
        *("abort", "bail", "die", "error", "execl", "execv", "execve", "execvp", "exit", "fail", "halt", "panic"),
        *("quit", "skip", "terminate", "usage"),
    }
)
"""What functions are called that may never come back, such as ``parser.error()``; those of loggers do."""


def past_branch(
    graph: Graph, function: facts.Function, bound: Sequence[Block], reads: Sequence[Reading]
) -> tuple[facts.Name, facts.Span] | None:
    """The read of a variable to which a branch surely leads that gives it no value, as other branches do, and where
    that branch begins."""
    reading = {block: name for block, name, surely in reversed(reads) if surely and block not in bound}
    later = after(bound) if reading else set[Block]()
    for chain in _chains(function.body) if reading else ():
        blocks = [graph.inside(branch) for branch in chain.branches]
        if all(block not in each for block in bound for each in blocks) or _is_asked_before(function, chain):
            continue
        for branch, inside in zip(chain.branches, blocks, strict=True):
            first = branch[0] if branch else None
            if first is None or isinstance(first, facts.Global) or any(block in inside for block in bound):
                continue
            if all(map(_is_pass, branch)) and all(_is_of_self(test) for test in chain.tests):
                continue  # what the object sets itself is nothing else, as the branch has nothing to say of it
            starts = _starts(graph, first)
            read = None if later.intersection(starts) else _surely_read(graph, starts, bound, reading)
            if read is not None and read not in inside and not any(map(_may_leave, branch)):
                return reading[read], first.span
    return None


def _is_pass(statement: facts.Stmt) -> bool:
    return isinstance(statement, facts.Jump) and statement.kind == "pass"


def _is_of_self(test: facts.Expr) -> bool:
    """Whether a condition asks for nothing but the object's own attributes: ``self.mode``."""
    return all(name.startswith("self.") for name in _asked_for(test))


class _Chain:
    """An ``if`` with all of its ``elif`` and its ``else``: the conditions, and the branches that are written."""

    def __init__(self, first: facts.If) -> None:
        self.first = first
        self.tests: list[facts.Expr] = [first.test]
        self.branches: list[Sequence[facts.Stmt]] = [first.body]
        rest = first.orelse
        while len(rest) == 1 and isinstance(rest[0], facts.If):
            self.tests.append(rest[0].test)
            self.branches.append(rest[0].body)
            rest = rest[0].orelse
        self.branches.append(rest)


def _chains(body: Sequence[facts.Stmt]) -> Iterator[_Chain]:
    further = set[Itself[facts.If]]()
    for statement in parts_of(body, facts.If):
        match statement.orelse:
            case [facts.If() as other]:
                further.add(Itself(other))
        if Itself(statement) not in further:
            yield _Chain(statement)


def _starts(graph: Graph, statement: facts.Stmt) -> list[Block]:
    """The blocks of a statement with which it begins; a ``finally`` has several."""
    return graph.of(statement) or graph.at(statement)[:1]


def _surely_read(
    graph: Graph, starts: Collection[Block], bound: Collection[Block], reading: Mapping[Block, facts.Name]
) -> Block | None:
    """The block, of some, that every way from others on comes to, with no assignment before."""
    if not starts:
        return None
    clear = reach(starts, without_exceptions, avoiding=reading)
    if not clear.isdisjoint(graph.exits) or not clear.isdisjoint(bound):
        return None
    edges = (edge for block in clear for edge in block.edges if without_exceptions(edge))
    reads = [edge.target for edge in edges if edge.target in reading]
    return min(reads, key=lambda block: reading[block].span, default=None)


def _is_asked_before(function: facts.Function, chain: _Chain) -> bool:
    """Whether something above asks for what the conditions ask, so that the branch may be for what cannot be."""
    asked = {name for test in chain.tests for name in _asked_for(test)}
    askers = (part for part in parts_of(function.body) if isinstance(part, (facts.If, facts.While, facts.Assert)))
    tests = (part.test for part in askers if part.span < chain.first.span)
    return any(not asked.isdisjoint(_asked_for(test)) for test in tests)


def _asked_for(test: facts.Expr) -> set[str]:
    """The variables and attributes that a condition asks for, as they are written: ``self.mode``."""
    parts = (part for part in everything_in([test]) if isinstance(part, (facts.Name, facts.Attribute)))
    called = {call.func.dotted for call in everything_in([test], facts.Call)}
    names = {part.dotted for part in parts} - called - {"", "self"}
    return {name for name in names if not any(other.startswith(f"{name}.") for other in names)}


def _may_leave(statement: facts.Stmt) -> bool:
    """Whether a statement calls what may end the program, by its name."""
    for call in everything_in([statement], facts.Call):
        words = call.func.last_name.strip("_").lower()
        is_of_logger = isinstance(call.func, facts.Attribute) and "log" in _receiver(call.func.value)
        if not is_of_logger and (words in _LEAVING or not _LEAVING.isdisjoint(words.split("_"))):
            return True
    return False


def _receiver(value: facts.Expr) -> str:
    """What a method is called on, in small letters: ``self.get_logger().error()`` on ``get_logger``."""
    return (value.func.last_name if isinstance(value, facts.Call) else value.last_name).lower()


__all__ = ["Reading", "past_branch"]
