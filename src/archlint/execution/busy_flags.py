"""Flags that callbacks set before their work and clear behind it: on one thread, none finds one that is set, and on
several, the second one returns at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import blocks_of, is_none, statements_of

_Leaving = (facts.Return, facts.Raise, facts.Jump)


def waits_for_busy_flag(loop: facts.While, attribute: str, code: facts.Facts) -> bool:
    """Whether a loop goes on while an attribute has a value that each function which sets it takes back further down,
    before it returns: ``while self.busy: pass``."""
    asked = loop.test if loop.test.negated is None else loop.test.negated
    if not isinstance(asked, facts.Attribute) or asked.attr != attribute:
        return False
    waits_for = loop.test.negated is not None
    blocks = [block for function in everything_in(code.body, facts.Function) for block in blocks_of(function.body)]
    return all(_is_taken_back(block, attribute, waits_for) for block in blocks)


def _is_taken_back(block: Sequence[facts.Stmt], attribute: str, wanted: bool) -> bool:
    """Whether a block that gives the attribute another value than the ``wanted`` one gives it that one further down."""
    left: facts.Stmt | None = None
    for statement in block:
        if any(isinstance(target, facts.Attribute) and target.attr == attribute for target in statement.assigned):
            value = statement.value.truth if isinstance(statement, facts.Assign) else None
            if value is None:
                return False
            left = None if value is wanted else statement
        elif left is not None and any(isinstance(each, _Leaving) for each in statements_of([statement])):
            return False
    return left is None


def returns_while_busy(body: Sequence[facts.Stmt]) -> bool:
    """Whether a callback returns at once while another run of it has set a flag: ``if self.busy: return response``,
    and ``self.busy = True`` further down; or has a lock for which it does not wait."""
    statements = [*_in_a_row(body)]
    for at, statement in enumerate(statements):
        match statement:
            case facts.If(test=test, body=[*_, facts.Return()]):
                if any(_is_lock_of_another(part) for part in _any_of(test)):
                    return True
                if any(_makes_true(later, part) for part in _any_of(test) for later in statements[at + 1 :]):
                    return True
    return False


def _in_a_row(body: Sequence[facts.Stmt]) -> Iterator[facts.Stmt]:
    """The statements of a block, with those of a ``with`` or a ``try`` in it."""
    for statement in body:
        match statement:
            case facts.With(body=inner) | facts.Try(body=inner):
                yield from _in_a_row(inner)
            case _:
                yield statement


def _any_of(test: facts.Expr) -> Sequence[facts.Expr]:
    """The conditions of which one suffices."""
    return test.values if isinstance(test, facts.Boolean) and test.op == "or" else [test]


def _is_lock_of_another(test: facts.Expr) -> bool:
    """``not self.lock.acquire(blocking=False)``"""
    match test:
        case facts.Unary(op="not", operand=facts.Call(func=facts.Attribute(attr="acquire"), args=[first, *_])):
            return first.keyword in (None, "blocking") and first.value.truth is False
    return False


def _makes_true(statement: facts.Stmt, test: facts.Expr) -> bool:
    """Whether a statement sets an attribute to what a test asks for."""
    if not isinstance(statement, facts.Assign):
        return False
    value, names = statement.value, {target.dotted for target in statement.targets if target.attribute}
    match test:
        case facts.Attribute():
            return test.dotted in names and value.truth is True
        case facts.Compare(left=facts.Attribute() as asked, ops=["==" | "is"], comparators=[wanted]):
            return asked.dotted in names and _are_alike(value, wanted)
        case facts.Compare(left=facts.Attribute() as asked, ops=["!=" | "is not"], comparators=[unwanted]):
            return asked.dotted in names and not _are_alike(value, unwanted) and not is_none(value)
    return False


def _are_alike(value: facts.Expr, other: facts.Expr) -> bool:
    """Whether both are the same literal or the same name, ``State.BUSY``."""
    if isinstance(value, facts.Literal) and isinstance(other, facts.Literal):
        return value.value == other.value
    return bool(value.dotted) and value.dotted == other.dotted


__all__ = ["returns_while_busy", "waits_for_busy_flag"]
