"""Ways that code goes to bring something up again that has failed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.order import is_in_branch
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall

_AGAIN = re.compile(r"(?<![a-z])(?:auto_?)?re_?(?:connect|cover|spawn|launch|start|open|boot)", re.IGNORECASE)
"""``_reconnect``, ``restart_stack``, ``Restarting …``"""


def brings_up_again(code: SourceCode, call: ApiCall) -> bool:
    """Whether a callback comes to a call only where something has failed, to bring it up again: a helper that is named
    so holds it, under a condition, or the branch around it calls one or says so."""
    helpers = (frame.callee.rpartition(".")[2] for frame in call.chain)
    places = (*(frame.place for frame in call.chain), call.place)
    if any(map(_AGAIN.search, helpers)) and any(is_in_branch(code, place) for place in places):
        return True
    return any(_is_in_such_a_branch(code, place) for place in places)


def _is_in_such_a_branch(code: SourceCode, place: Place) -> bool:
    return any(_AGAIN.search(words) for words in _words(_branch_around(code.body_at(place), place.span)))


def _branch_around(body: Sequence[facts.Stmt], span: facts.Span) -> Sequence[facts.Stmt]:
    """The innermost branch that holds a place: what follows an ``if``, a ``case`` or an ``except``."""
    for statement in body:
        if covers(statement, span):
            blocks: Sequence[Sequence[facts.Stmt]] = getattr(statement, "blocks", ())
            inside = next((block for block in blocks if any(covers(inner, span) for inner in block)), ())
            is_branch = isinstance(statement, (facts.If, facts.Match)) or (
                isinstance(statement, facts.Try) and inside is not statement.body
            )
            return _branch_around(inside, span) or (inside if is_branch else ())
    return ()


def _words(branch: Sequence[facts.Stmt]) -> Iterator[str]:
    """The names of what a branch calls in lines of its own, and the texts there."""
    for line in branch:
        if isinstance(line, (facts.Expression, facts.Assign)):
            yield from filter(None, map(called_name, calls_in(line)))
            yield from (literal.text for literal in everything_in([line], facts.Literal) if literal.text)


__all__ = ["brings_up_again"]
