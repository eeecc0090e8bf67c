"""Walking facts: the statements, blocks and calls inside a piece of source; functions inside it are left out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeVar, overload

from archlint.syntax import facts

_OWN_SCOPE = (facts.Function, facts.Class, facts.Lambda)
Kind = TypeVar("Kind", bound=facts.Base)


def blocks_of(body: Sequence[facts.Stmt]) -> Iterator[Sequence[facts.Stmt]]:
    """A body and every block inside it."""
    yield body
    for statement in body:
        for block in blocks_in(statement):
            yield from blocks_of(block)


def blocks_in(statement: facts.Stmt) -> list[list[facts.Stmt]]:
    """The blocks that a statement holds."""
    if isinstance(statement, (facts.If, facts.For, facts.While)):
        return [statement.body, statement.orelse]
    if isinstance(statement, facts.With):
        return [statement.body]
    if isinstance(statement, facts.Try):
        return [statement.body, *(handler.body for handler in statement.handlers), statement.orelse, statement.final]
    if isinstance(statement, facts.Match):
        return [case.body for case in statement.cases]
    return []


@overload
def statements_of(body: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]: ...


@overload
def statements_of(body: Sequence[facts.Stmt], kind: type[Kind]) -> Iterator[Kind]: ...


def statements_of(body: Sequence[facts.Stmt], kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every statement of a body (of a kind), those of its blocks included, in the order of the source."""
    for statement in body:
        if isinstance(statement, kind):
            yield statement
        for block in blocks_in(statement):
            yield from statements_of(block, kind)


@overload
def parts_of(fact: object) -> Iterator[facts.Base]: ...


@overload
def parts_of(fact: object, kind: type[Kind]) -> Iterator[Kind]: ...


def parts_of(fact: object, kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every fact (of a kind) inside another, that one first, outermost first."""
    stack: list[object] = [fact]
    while stack:
        item = stack.pop()
        if isinstance(item, (list, tuple)):
            stack.extend(reversed(item))
        elif isinstance(item, facts.Base):
            if isinstance(item, kind):
                yield item
            if item is fact or not isinstance(item, _OWN_SCOPE):
                stack.extend(getattr(item, name) for name in reversed(item.__struct_fields__))


def calls_in(fact: object) -> Iterator[facts.Call]:
    """The calls inside a statement or expression."""
    return parts_of(fact, facts.Call)


def called_name(call: facts.Call) -> str:
    """The last name of what is called: ``publish`` for ``self.pub.publish()``; empty where it has none."""
    return call.func.last_name


def has_literal_true(test: facts.Expr) -> bool:
    """Whether a condition is written as true: ``while True``, ``while 1``."""
    return isinstance(test, facts.Literal) and bool(test.value)
