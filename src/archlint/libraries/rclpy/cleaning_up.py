"""Code that is there because something failed."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.control_flow import always_raises, graph_of
from archlint.syntax.flow_blocks import Block, without_exceptions
from archlint.syntax.parts import Itself
from archlint.syntax.walk import called_name, calls_in, statements_of

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def is_cleaning_up(run: Run) -> bool:
    """Whether what runs now is there because something failed, and runs once: on the way to it is an ``except``, and no
    loop that tries again; or an ``except`` that always raises, or that (or ``finally``) shuts the node down; or every
    way on raises, and no ``try`` is around."""
    caught = any(activation.tries for activation in run.activations)
    recovers = any(
        id(activation.statement) in _in_handlers(Itself(activation.body))
        for activation in run.activations
        if activation.statement is not None
    )
    return (recovers and not run.enclosing_loops()) or any(
        _cleans_up(Itself(activation.body), Itself(activation.statement))
        or (not caught and _raises_next(Itself(activation.body), Itself(activation.statement)))
        for activation in run.activations
        if activation.statement is not None
    )


def _cleans_up(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> bool:
    return id(wanted.fact) in _in_clean_up(body)


@lru_cache(maxsize=1024)
def _in_clean_up(body: Itself[Sequence[facts.Stmt]]) -> frozenset[int]:
    return frozenset(
        id(inner)
        for statement in statements_of(body.fact, facts.Try)
        for block, handles in ((statement.final, False), *((handler.body, True) for handler in statement.handlers))
        if (handles and always_raises(block)) or any(called_name(call) in _ENDS for call in calls_in(block))
        for inner in statements_of(block)
    )


@lru_cache(maxsize=1024)
def _in_handlers(body: Itself[Sequence[facts.Stmt]]) -> frozenset[int]:
    return frozenset(
        id(inner)
        for statement in statements_of(body.fact, facts.Try)
        for handler in statement.handlers
        for inner in statements_of(handler.body)
    )


def _raises_next(body: Itself[Sequence[facts.Stmt]], wanted: Itself[facts.Stmt]) -> bool:
    blocks = graph_of(body.fact).of(wanted.fact)
    return bool(blocks) and _raising(body).issuperset(blocks)


@lru_cache(maxsize=1024)
def _raising(body: Itself[Sequence[facts.Stmt]]) -> frozenset[Block]:
    """The blocks from which every way leads to a ``raise``."""
    graph = graph_of(body.fact)
    raising = [block for block in graph.blocks if isinstance(block.fact, facts.Raise)]
    others = graph.before(graph.exits, without_exceptions, avoiding=raising).union(graph.exits) if raising else ()
    return frozenset(graph.blocks).difference(others) if raising else frozenset()


_ENDS = frozenset({"shutdown", "try_shutdown", "destroy_node"})
