"""What is done next with an object of whose attributes a statement sets one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in, parts_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.place import Place


def is_next_use(code: SourceCode, assigned: Place, used: Place) -> bool:
    """Whether ``used``, a call, has the first mention of the variable below the assignment at ``assigned`` that sets
    something of it: ``msg.data = 1`` in front of ``publish(msg)``."""
    statement, body = code.statement_at(assigned), code.body_at(assigned)
    if not isinstance(statement, facts.Assign) or assigned.file != used.file or body is not code.body_at(used):
        return False
    names = {name.id for name in everything_in(statement.targets, facts.Name)} - {"self"}
    later = (name.span for name in everything_in(body, facts.Name) if name.id in names)
    following = min((span for span in later if span[:2] >= statement.span[2:]), default=None)
    return following is not None and used.span[:2] <= following[:2] and following[2:] <= used.span[2:]


def is_straight_behind(code: SourceCode, first: Place, later: Place) -> bool:
    """Whether a place comes behind a simple statement in its block, or in a block that follows there: it is reached in
    no run in which the statement raises an exception."""
    statement, body = code.statement_at(first), code.body_at(first)
    if statement is None or statement.blocks or first.file != later.file or body is not code.body_at(later):
        return False
    blocks = [body, *(block for part in parts_of(body, facts.Statement) for block in part.blocks)]
    for block in blocks:
        following = block[next((n for n, each in enumerate(block, 1) if each is statement), len(block)) :]
        if any(covers(each, later.span) for each in following):
            return True
    return False


__all__ = ["is_next_use", "is_straight_behind"]
