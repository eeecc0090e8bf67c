"""Reads that follow the making of something at once, so that nothing can have come in between."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.walk import called_name, calls_in, parts_of

if TYPE_CHECKING:
    from archlint.syntax.flow_blocks import Block
    from archlint.syntax.flow_graph import Graph

LOGS = frozenset({"get_logger", "debug", "info", "warn", "warning", "error", "print", "format", "str"})
"""Calls that only say something."""


def follows_at_once(
    graph: Graph, reads: Collection[Block], name: str, makes: Callable[[facts.Expr], bool], pastimes: frozenset[str]
) -> bool:
    """Whether every way to some blocks has put what ``makes`` says into a variable or attribute, and nothing since lets
    time pass: only ``pastimes`` are called, nothing is awaited, and no condition asks for it."""
    tests = {id(block.fact) for block in graph.blocks if isinstance(block.statement, facts.If)}

    def step(fresh: bool, fact: facts.Base) -> bool:
        match fact:
            case facts.Assign(value=value) if _binds(fact, name):
                return makes(value)
            case facts.Assign() | facts.Expression():
                # Whatever is awaited, the executor goes on meanwhile.
                return fresh and _idle(fact, pastimes) and not any(parts_of(fact, facts.Await))
        # A condition that asks for it, or anything by a call, may well have waited for it.
        return fresh and id(fact) in tests and not any(calls_in(fact)) and not _mentions(fact, name)

    states = graph.states(False, step)
    return bool(reads) and all(states.get(block) == frozenset({True}) for block in reads)


def _binds(statement: facts.Assign, name: str) -> bool:
    return any(target.dotted == name for target in statement.targets)


def _mentions(fact: facts.Base, name: str) -> bool:
    return any(part.dotted == name for part in parts_of(fact))


def _idle(fact: facts.Base, pastimes: frozenset[str]) -> bool:
    return all(called_name(call) in pastimes for call in calls_in(fact))


__all__ = ["LOGS", "follows_at_once"]
