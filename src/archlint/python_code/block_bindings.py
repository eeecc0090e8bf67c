"""What the blocks of a control flow graph bind and read."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_blocks import reach
from archlint.syntax.parts import Itself, everything_in, parts_of, targets_in

if TYPE_CHECKING:
    from collections.abc import Collection

    from archlint.syntax.flow_blocks import Block
    from archlint.syntax.flow_graph import Graph

_WITH_BODY = (facts.If, facts.While, facts.For, facts.With, facts.Try, facts.Match)
_SIMPLE = (facts.Assign, facts.Augmented, facts.Annotated)


def bound_at(block: Block) -> Iterator[facts.Base]:
    """Everything that is bound where a block runs: variables as names, imports, functions and classes themselves,
    attributes and items as they stand."""
    match block.statement:
        case facts.With(items=items):
            for item in items:
                yield from targets_in(item.target) if item.target is not None else ()
        case facts.For(target=target):
            yield from targets_in(target)
        case facts.Match(cases=cases):
            yield from (part for case in cases for part in everything_in([case.pattern], facts.Pattern))
        case facts.Try(handlers=handlers):
            yield from handlers
        case facts.Function() | facts.Class() | facts.Import() | facts.ImportFrom() as statement:
            yield statement
    if block.fact is not None:
        yield from _bound_in(block.fact)


def _bound_in(fact: facts.Base) -> Iterator[facts.Base]:
    for part in parts_of(fact):
        if isinstance(part, facts.Annotated) and part.value is None:
            continue
        for target in _assigned(part):
            yield from targets_in(target)


def _assigned(part: facts.Base) -> list[facts.Expr]:
    """The targets that a part of a statement sets, ``:=`` included."""
    return [part.target] if isinstance(part, facts.Assigned) else part.assigned


def read_at(block: Block) -> Iterator[tuple[facts.Base, bool]]:
    """Every name and attribute that a block reads, and whether it surely does: not behind ``and``, say.  What
    functions and classes inside it read, they read later."""
    if block.fact is None or isinstance(block.fact, facts.Delete):
        return
    written = {
        Itself(target)
        for part in parts_of(block.fact)
        if not isinstance(part, facts.Augmented)
        for each in _assigned(part)
        for target in targets_in(each)
    }
    stack: list[tuple[facts.Base, bool, frozenset[str]]] = [(block.fact, True, frozenset())]
    while stack:
        part, surely, hidden = stack.pop()
        match part:
            case facts.Lambda(params=params):
                stack += [(param.default, surely, hidden) for param in params if param.default is not None]
                continue
            case facts.Comprehension(generators=[first, *_] as generators):
                stack.append((first.iterable, surely, hidden))
                own = {name.id for each in generators for name in everything_in([each.target], facts.Name)}
                stack += [(child, False, hidden | own) for child in part.children() if child is not first.iterable]
                continue
            case facts.Annotated(target=target, value=value):
                if value is not None:  # a declaration alone reads nothing
                    stack += [(target, surely, hidden), (value, surely, hidden)]
                continue
            case facts.Boolean(values=[value, *others]):
                stack += [(value, surely, hidden), *((other, False, hidden) for other in others)]
                continue
            case facts.Conditional(test=test, body=body, orelse=orelse):
                stack += [(test, surely, hidden), (body, False, hidden), (orelse, False, hidden)]
                continue
            case facts.Name(id=name) if name not in hidden and Itself[facts.Base](part) not in written:
                yield part, surely
            case facts.Attribute() if Itself[facts.Base](part) not in written:
                yield part, surely
        stack += [(child, surely, hidden) for child in part.children()]


def is_plain(block: Block) -> bool:
    """Whether what a block binds is bound by its assignment alone, so that all that it reads is read before."""
    return isinstance(block.statement, _SIMPLE) and not any(parts_of(block.statement, facts.Assigned))


def after(blocks: Collection[Block]) -> set[Block]:
    """All that may run once some blocks have begun."""
    return reach([edge.target for block in blocks for edge in block.edges])


def run_before(graph: Graph, block: Block) -> list[Block]:
    """The blocks that may run before one, and that one."""
    return [block, *(graph.before([block]) - {block})]


__all__ = ["after", "bound_at", "is_plain", "read_at", "run_before"]
