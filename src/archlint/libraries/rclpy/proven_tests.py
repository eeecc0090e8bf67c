"""The conditions that lead to what runs now, and how they came out."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import Itself
from archlint.syntax.walk import parts_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.libraries.run import Run


def proven_of(run: Run) -> tuple[tuple[Place, bool], ...]:
    """The ``if`` statements that lead to what runs now and ask for names which are no function's own, with how their
    conditions came out."""
    return tuple(
        (activation.place(statement.span), truth)
        for activation in run.activations
        if activation.statement is not None
        for statement, truth in _proven(Itself(activation.body), Itself(activation.statement))
        if activation.scope.kind != "function" or not _asks(statement.test) & (activation.scope.bound or frozenset())
    )


def _asks(test: facts.Expr) -> set[str]:
    return {part.id for part in parts_of(test, facts.Name)}


@lru_cache(maxsize=4096)
def _proven(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> tuple[tuple[facts.If, bool], ...]:
    graph = graph_of(body.fact)
    edges = [(edge.source.statement, edge.holds) for edge in graph.outcomes(graph.of(wanted.fact))]
    return tuple((statement, holds) for statement, holds in edges if isinstance(statement, facts.If))
