"""Flags that callbacks set before their work and clear behind it: on one thread, none finds one that is set, and on
several, the second one returns at once."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import blocks_of, statements_of

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
    and ``self.busy = True`` further down."""
    for at, statement in enumerate(body):
        match statement:
            case facts.If(test=facts.Attribute(attr=flag), body=[*_, facts.Return()]):
                if any(_sets(later, flag) for later in body[at + 1 :]):
                    return True
    return False


def _sets(statement: facts.Stmt, flag: str) -> bool:
    """Whether a statement is ``self.busy = True``, or the ``try`` or ``with`` that begins with it."""
    match statement:
        case facts.Assign(targets=[facts.Attribute(attr=attribute)], value=value):
            return attribute == flag and value.truth is True
        case facts.Try(body=[first, *_]) | facts.With(body=[first, *_]):
            return _sets(first, flag)
    return False


__all__ = ["returns_while_busy", "waits_for_busy_flag"]
