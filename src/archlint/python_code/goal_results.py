"""The ends of an action server's callbacks that return no answer: no result, or neither yes nor no.

Source: rclpy/action/server.py.  ``_execute_goal`` puts what the execute callback returns into the answer that the
client asks for; what is no ``Result`` of the action cannot be put there, and the client never gets an answer.
``_execute_goal_request`` rejects a goal, and ``_execute_cancel_request`` a cancel request, of which the callback does
not return ``ACCEPT``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.model import Role
from archlint.python_code.goal_outcomes import never_runs, says_it_is_down
from archlint.python_code.handler_ends import HandlerEnd, ends_of, handlers_of, is_stub
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import System


def ends_without_goal_result(system: System) -> Iterator[HandlerEnd]:
    """The ends of execute callbacks that some way reaches while ROS is up, and that return nothing, or what can be no
    result."""
    for callback, function in handlers_of(system, Role.EXECUTE):
        if not is_stub(function.body) and not never_runs(system, callback):
            yield from ends_of(system, callback, function, says_it_is_down)


def ends_without_decision(system: System) -> Iterator[HandlerEnd]:
    """The ends of goal callbacks that return no ``GoalResponse``, and those of cancel callbacks that never return a
    ``CancelResponse``: one that accepts elsewhere may mean to reject."""
    for role in (Role.GOAL, Role.CANCEL):
        for callback, function in handlers_of(system, role):
            ends = [] if is_stub(function.body) else [*ends_of(system, callback, function)]
            if role is Role.GOAL or len({end.place for end in ends if end.how == "return"}) == _returns(function):
                yield from ends


def _returns(function: facts.Function) -> int:
    return sum(1 for _ in statements_of(function.body, facts.Return))


__all__ = ["ends_without_decision", "ends_without_goal_result"]
