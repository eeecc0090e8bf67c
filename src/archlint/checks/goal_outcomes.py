"""ACT003: execute callbacks with a path that leaves the goal without an outcome."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import endpoint_words, node_name, one_for_each_place
from archlint.checks.folding import folds, with_others
from archlint.checks.handlers import related_handler
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.python_code.goal_outcomes import ends_without_outcome
from archlint.python_code.handler_ends import HandlerEnd

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("ACT003", scope=Scope.CODE)
def goal_without_outcome(system: System, options: Options) -> Iterator[Finding]:
    """Ends of execute callbacks that leave the goal without an outcome."""
    yield from one_for_each_place(_undecided(system, end) for end in ends_without_outcome(system))


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


@folds("ACT003")
def _of_one_callback(findings: Sequence[Finding]) -> Finding:
    """One finding for all ends of an execute callback: they lack the same."""
    return with_others(findings, "another end of it does", "more ends of it do", "the same", "this end, too")
