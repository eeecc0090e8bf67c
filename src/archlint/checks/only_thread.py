"""EXE004: callbacks that sleep on the thread that should wake them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import calls_of, one_for_each_place
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.execution import blocking
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.deadlock import threads_of
from archlint.execution.piling_rates import RATE_SLEEP
from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System


@rule("EXE004", scope=Scope.CODE)
def rate_sleep_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Rates that sleep on the only thread that could wake them."""
    yield from one_for_each_place(
        finding_in_callback(
            "EXE004",
            system,
            program,
            call,
            f"{callback_words(call.context)} calls Rate.sleep() and {verdict.words}: the timer that wakes it needs "
            f"the thread that is sleeping{_unless_it_ran(call)}",
            help="do the work step by step in a timer callback, or spin the node with a MultiThreadedExecutor",
            identity=("Rate.sleep",),
        )
        for program, call in calls_of(system, (RATE_SLEEP,))
        if runs_in_executor(call.context)
        for verdict in [_rate_verdict(call, program, options)]
        if not verdict.safe and not verdict.unknown
    )


def _unless_it_ran(call: ApiCall) -> str:
    """A Rate remembers that its timer ran while nobody slept: the first sleep after that ends at once."""
    return "" if call.looped else "; if the timer has already fired, it does not sleep at all"


def _rate_verdict(call: ApiCall, program: Program, options: Options) -> blocking.Verdict:
    threads = threads_of(call.context.node, program)
    return blocking.look_up(blocking.RATE, threads, blocking.OTHER, "", options.distros)
