"""Waits that follow each other: whether a later one may depend on what an earlier one has brought."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import names_in
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import Frame

_DECIDES = (facts.If, facts.While, facts.Match, facts.Assert, facts.Return, facts.Raise)


def build_on_answers(body: Sequence[facts.Stmt], lines: Collection[int]) -> bool:
    """Whether what a function does between the lines where it waits may decide about a later wait: a test, or a name
    that an answer got."""
    first, last = min(lines), max(lines)
    between = [
        statement
        for statement in statements_of(body)
        if not isinstance(statement, facts.Global) and first <= statement.span[0] <= last
    ]
    if any(isinstance(statement, _DECIDES) and first < statement.span[0] for statement in between):
        return True
    answers: set[str] = set()
    for statement in between:
        match statement:
            case facts.Assign(value=value):
                if not answers.isdisjoint(names_in(value)):
                    return True
                if _stands_in(statement, lines) or "result" in names_in(value):
                    answers.update(name for target in statement.targets for name in names_in(target) - {"self"})
            case _:
                if not answers.isdisjoint(names_in(statement)):
                    return True
    return False


def _stands_in(statement: facts.Assign, lines: Collection[int]) -> bool:
    return any(line in lines for line in range(statement.span[0], statement.span[2] + 1))


_BESIDE = frozenset({"as_completed", "create_task", "ensure_future", "gather", "run_coroutine_threadsafe"})


def runs_beside_others(code: SourceCode, chain: Sequence[Frame]) -> bool:
    """Whether the coroutine that a chain of calls leads to runs beside others:
    ``await asyncio.gather(self.ask(), self.look())``."""
    for frame in chain:
        statement = code.statement_at(frame.place)
        around = [] if statement is None else [call for call in calls_in(statement) if called_name(call) in _BESIDE]
        span = frame.place.span  # a coroutine that is itself called ``gather()`` does not run beside others
        if any(covers(call, span) and call.span[:2] < span[:2] for call in around):
            return True
    return False


__all__ = ["build_on_answers", "runs_beside_others"]
