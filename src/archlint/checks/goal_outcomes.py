"""ACT003: execute callbacks with a path that leaves the goal without an outcome, or its client without a result."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.checks.folding import folds, with_others
from archlint.checks.handlers import related_handler
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.model import Role
from archlint.python_code.goal_outcomes import ends_without_outcome
from archlint.python_code.goal_results import ends_without_decision, ends_without_goal_result
from archlint.python_code.handler_ends import HandlerEnd

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("ACT003", scope=Scope.CODE)
def goal_without_outcome(system: System, options: Options) -> Iterator[Finding]:
    """Ends of execute callbacks that leave the goal without an outcome, or the client without a result."""
    undecided = [*ends_without_outcome(system)]
    yield from one_for_each_place(_undecided(system, end) for end in undecided)
    told = {end.callback.place for end in undecided}
    ends = (end for end in ends_without_goal_result(system) if end.callback.place not in told)
    yield from one_for_each_place(_no_result(system, end) for end in ends)
    yield from one_for_each_place(_no_decision(system, end) for end in ends_without_decision(system))


def _undecided(system: System, end: HandlerEnd) -> Finding:
    callback = end.callback
    what = "ends here" if end.how == "return" else "can reach its end"
    return finding(
        "ACT003",
        end.place,
        f"the execute callback of {endpoint_words(callback.creation)} {what} on a path without succeed(), abort() "
        "or canceled(): rclpy then aborts the goal",
        help="call succeed(), abort() or canceled() on every path",
        related=related_handler(end),
        node=node_name(system, callback.node),
        identity=(callback.name, end.how),
        group=(callback.place.file, str(callback.place.line), callback.name),
    )


def _no_result(system: System, end: HandlerEnd) -> Finding:
    callback = end.callback
    what = "can reach its end without a result" if end.how == "end" else f"returns {end.gives} here, which is no result"
    return finding(
        "ACT003",
        end.place,
        f"the execute callback of {endpoint_words(callback.creation)} {what}: the client never gets one",
        help="return the Result of the action on every path, also where the goal is aborted or canceled",
        related=related_handler(end),
        node=node_name(system, callback.node),
        identity=(callback.name, "result", end.how),
        group=(callback.place.file, str(callback.place.line), callback.name, "result"),
    )


def _no_decision(system: System, end: HandlerEnd) -> Finding:
    callback = end.callback
    word, what = _DECISIONS[callback.role]
    says = (
        f"can reach its end without a {word}" if end.how == "end" else f"returns {end.gives} here, which is no {word}"
    )
    return finding(
        "ACT003",
        end.place,
        f"the {callback.role} callback of {endpoint_words(callback.creation)} {says}: rclpy rejects the {what}",
        help=f"return {word}.ACCEPT or {word}.REJECT",
        related=related_handler(end),
        node=node_name(system, callback.node),
        identity=(callback.name, word, end.how),
        group=(callback.place.file, str(callback.place.line), callback.name, word),
    )


_DECISIONS = {Role.GOAL: ("GoalResponse", "goal"), Role.CANCEL: ("CancelResponse", "request to cancel")}
"""What these callbacks are to return, and what rclpy rejects otherwise."""


@folds("ACT003")
def _of_one_callback(findings: Sequence[Finding]) -> Finding:
    """One finding for all ends of an execute callback: they lack the same."""
    return with_others(findings, "another end of it does", "more ends of it do", "the same", "this end, too")
