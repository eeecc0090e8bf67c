"""Waits of a loop over clients."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.execution.collection_sizes import most_items
from archlint.execution.polling import is_decided
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.parts import names_in, targets_in
from archlint.syntax.walk import calls_in, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.execution.waits import Wait
    from archlint.model import ApiCall


def is_for_each_client(code: SourceCode, call: ApiCall) -> bool:
    """Whether a ``for`` loop around the call goes through clients: each round waits for the server of another."""
    expression = code.expression(call)
    method = None if expression is None else expression.func
    if not isinstance(method, facts.Attribute) or not method.value.variable:
        return False
    loops = (loop for loop in code.loops(call) if isinstance(loop, facts.For))
    return any(target.variable == method.value.variable for loop in loops for target in targets_in(loop.target))


def clients_in_turn(code: SourceCode, wait: Wait) -> int:
    """How many clients a ``for`` loop asks, each round another one, and waits for before it asks the next; 0 where one
    answer may decide about a later request."""
    call = wait.call
    loop = code.loop(call)
    if not isinstance(loop, facts.For) or loop_of(loop).is_left_early or is_decided(loop.body, call.place) is not False:
        return 0
    if not _asks_its_target(loop) or _uses_last_answer(loop, call.place.line):
        return 0
    file = code.facts_at(call.file)
    made_there = sum(other.place == wait.client.place for other in wait.client.node.creations)
    return max(made_there, 0 if file is None else most_items(loop.head, file) or 0)


def _asks_its_target(loop: facts.For) -> bool:
    """``for name, client in clients.items(): client.call_async(request)``."""
    targets = {target.variable for target in targets_in(loop.target)} - {""}
    asked = (call.func for call in calls_in(loop.body))
    return any(
        isinstance(method, facts.Attribute) and method.attr in _ASKS and method.value.variable in targets
        for method in asked
    )


_ASKS = frozenset({"call", "call_async"})


def _uses_last_answer(loop: facts.For, line: int) -> bool:
    """Whether a round reads, before it waits, what the round before it has set after that."""
    set_later = {
        name
        for assignment in statements_of(loop.body, facts.Assign)
        if assignment.span[2] >= line
        for target in assignment.targets
        for name in names_in(target)
    }
    before = (statement for statement in statements_of(loop.body, facts.Assign) if statement.span[0] < line)
    read = {name for statement in before for name in names_in(statement.value)}
    return not set_later.isdisjoint(read - {"self"})


__all__ = ["clients_in_turn", "is_for_each_client"]
