"""What a flow graph asks of facts: where they stand, and what of a condition is enough."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from archlint.syntax import facts


def sufficient(test: facts.Expr, holds: bool) -> Iterator[tuple[facts.Expr, bool]]:
    """The conditions each of which is enough that a test comes out so, with how they come out."""
    match test:
        case facts.Unary(op="not", operand=operand):
            yield from sufficient(operand, not holds)
        case facts.Boolean(op=op, values=values) if (op == "or") == holds:
            for value in values:
                yield from sufficient(value, holds)
        case _:
            yield test, holds


def outcome(test: facts.Expr, of_rest: Callable[[facts.Expr], bool | None]) -> bool | None:
    """How a condition comes out; ``of_rest`` tells it of what ``not``, ``and`` and ``or`` join. None where that does
    not decide it."""
    match test:
        case facts.Unary(op="not", operand=operand):
            inner = outcome(operand, of_rest)
            return None if inner is None else not inner
        case facts.Boolean(op=op, values=values):
            outcomes = [outcome(value, of_rest) for value in values]
            decides = op == "or"
            if decides in outcomes:
                return decides
            return None if None in outcomes else not decides
    return of_rest(test)


def conditions_of(test: facts.Expr) -> Iterator[facts.Expr]:
    """The conditions that a test asks for, whatever ``not``, ``and`` and ``or`` make of them."""
    match test:
        case facts.Unary(op="not", operand=operand):
            yield from conditions_of(operand)
        case facts.Boolean(values=values):
            for value in values:
                yield from conditions_of(value)
        case _:
            yield test


def covers(fact: facts.Base, span: facts.Span) -> bool:
    """Whether a place is inside of what a fact is written in."""
    return holds(getattr(fact, "span", (0, 0, 0, 0)), span)


def holds(around: facts.Span, span: facts.Span) -> bool:
    """Whether a place is inside of another one, or the same."""
    return around[:2] <= span[:2] and span[2:] <= around[2:]


def is_unreachable(body: Sequence[facts.Stmt], span: facts.Span) -> bool:
    """Whether what stands at a place comes after a ``return``, ``raise``, ``break`` or ``continue`` of the same block,
    so that no line leads there."""
    ended = False
    for statement in body:
        if covers(statement, span):
            return ended or any(is_unreachable(block, span) for block in statement.blocks)
        ended = ended or _ends(statement)
    return False


def _ends(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Return() | facts.Raise() | facts.Jump(kind="break" | "continue"):
            return True
        case facts.If(body=body, orelse=orelse):
            return any(map(_ends, body)) and any(map(_ends, orelse))
    return False


def lines_of(fact: facts.Base) -> range:
    """The lines that a fact is written on."""
    span: facts.Span = getattr(fact, "span", (0, 0, 0, 0))
    return range(span[0], span[2] + 1)


def ends_of(statement: facts.Stmt) -> tuple[tuple[int, int], tuple[int, int]]:
    span: facts.Span = getattr(statement, "span", (0, 0, 0, 0))
    return span[:2], span[2:]


def is_within(statement: facts.Stmt, first: tuple[int, int], last: tuple[int, int]) -> bool:
    begins, ends = ends_of(statement)
    return first <= begins and ends <= last


__all__ = ["covers", "ends_of", "holds", "is_unreachable", "is_within", "lines_of", "outcome", "sufficient"]
