"""What is done next with an object of whose attributes a statement sets one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in

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


__all__ = ["is_next_use"]
