"""Walking facts: the statements and calls inside a piece of source; functions inside it are left out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import overload

from archlint.syntax import facts
from archlint.syntax.parts import Kind, Source, parts_of


@overload
def statements_of(body: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]: ...


@overload
def statements_of(body: Sequence[facts.Stmt], kind: type[Kind]) -> Iterator[Kind]: ...


def statements_of(body: Sequence[facts.Stmt], kind: type[facts.Base] = facts.Base) -> Iterator[facts.Base]:
    """Every statement of a body (of a kind), those of its blocks included, in the order of the source."""
    for statement in body:
        if isinstance(statement, kind):
            yield statement
        for block in statement.blocks:
            yield from statements_of(block, kind)


def blocks_of(body: Sequence[facts.Stmt]) -> Iterator[Sequence[facts.Stmt]]:
    """A body and each block inside it, outer ones first."""
    yield body
    for statement in statements_of(body):
        yield from statement.blocks


def calls_in(fact: Source) -> Iterator[facts.Call]:
    """The calls inside a statement or expression."""
    return parts_of(fact, facts.Call)


def called_name(call: facts.Call) -> str:
    """The last name of what is called: ``publish`` for ``self.pub.publish()``; empty where it has none."""
    return call.func.last_name


def given_to(call: facts.Call, name: str, position: int | None) -> facts.Expr | None:
    """What a call gives for a parameter, by keyword or by position; stars are not looked into."""
    named = next((argument.value for argument in call.args if argument.keyword == name), None)
    in_order = [argument.value for argument in call.args if argument.keyword is None]
    return in_order[position] if named is None and position is not None and position < len(in_order) else named


def is_none(expression: facts.Base) -> bool:
    """Whether an expression is the literal ``None``."""
    return isinstance(expression, facts.Literal) and expression.value is None


def main_guard(code: facts.Facts) -> facts.If | None:
    """``if __name__ == '__main__':`` at the top level of a file."""
    for statement in code.body:
        match statement:
            case facts.If(facts.Compare(left, ["=="], [right])):
                if {left.variable, right.variable} == {"__name__", ""} and "__main__" in (left.text, right.text):
                    return statement
    return None


def calls_on_import(code: facts.Facts, function: str) -> bool:
    """Whether a file calls a function of its own when it is imported, as in ``asyncio.run(main())``: a console script
    that calls an ``async def`` again only makes a coroutine."""
    guard = main_guard(code)
    calls = calls_in([statement for statement in code.body if statement is not guard])
    return any(call.func.variable == function for call in calls)


__all__ = [
    "blocks_of",
    "called_name",
    "calls_in",
    "calls_on_import",
    "given_to",
    "is_none",
    "main_guard",
    "parts_of",
    "statements_of",
]
