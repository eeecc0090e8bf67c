"""What is done next with an object of whose attributes a statement sets one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.place import Place


def is_next_use(code: SourceCode, assigned: Place, used: Place) -> bool:
    """Whether ``used`` is in the first statement, below the assignment at ``assigned``, that mentions the variable of
    which that one sets something: ``msg.data = 1`` in front of ``publish(msg)``."""
    statement = code.statement_at(assigned)
    if statement is None or assigned.file != used.file or code.body_at(assigned) is not code.body_at(used):
        return False
    names = {name.id for name in everything_in(list(statement.assigned), facts.Name)} - {"self"}
    end = statement.span[2:]
    later = (each for each in everything_in(list(code.body_at(assigned)), facts.Statement) if each.span[:2] > end)
    following = min((each.span for each in later if not names.isdisjoint(names_in(each))), default=None)
    return following is not None and following[:2] <= used.span[:2] and used.span[2:] <= following[2:]


__all__ = ["is_next_use"]
