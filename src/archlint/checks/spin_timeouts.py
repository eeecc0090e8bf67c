"""TMO003: spins for a future without a limit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.left_over import is_dead, is_never_made
from archlint.analysis.limit_sites import sites_of_spin
from archlint.analysis.own_futures import spins_for_a_message, spins_for_own_future
from archlint.analysis.reach import (
    argument,
    calls_of,
    creations_of,
    endpoint_words,
    node_name,
    one_for_each_place,
    waits_for_ever,
)
from archlint.analysis.source_code import source_code
from archlint.analysis.stuck import spoken_of
from archlint.checks.folding import folds, of_one_function
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import (
    is_at_its_default,
    name_of,
    related_path,
)
from archlint.finding import Finding
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System
_SPIN = "rclpy.spin_until_future_complete"
_EXECUTOR_SPIN = "rclpy.executors.Executor.spin_until_future_complete"


@rule("TMO003", scope=Scope.CODE, taste=True)
def spin_without_timeout(system: System, options: Options) -> Iterator[Finding]:
    """Spins until a future is complete that nothing limits.  Of a method that nothing calls, and of a client that
    nothing is seen to make, nobody knows whether it is ever there; a trial is ended by whoever runs it."""
    reported = spoken_of(system, options.distros)
    yield from one_for_each_place(
        _limitless_spin(system, call)
        for program, call in calls_of(system, (_SPIN, _EXECUTOR_SPIN))
        if waits_for_ever(source_code(system), call, "timeout_sec") and call.place not in reported
        if not is_dead(system.workspace, program, call) and not is_never_made(system.workspace, call)
        if not spins_for_own_future(call) or spins_for_a_message(system, call)
        if call.context.role != Role.METHOD or creations_of(argument(call, "future"))
    )


def _limitless_spin(system: System, call: ApiCall) -> Finding:
    clients = creations_of(argument(call, "future"))
    client = clients[0] if len({creation.place for creation in clients}) == 1 else None
    awaited = f"the response from {endpoint_words(client)}" if client else "the future"
    if spins_for_own_future(call):
        awaited = "the message that completes the future"
    return finding(
        "TMO003",
        call.place,
        f"spins until {awaited} arrives, without a timeout: if it never does, the next line never runs",
        help=_help_for_spin(call),
        related=related_path(call, client),
        node=node_name(system, call.context.node),
        identity=(call.function, name_of(client), "spin_until_future_complete"),
        group=(call.file, call.function),
        sites=sites_of_spin(system.workspace, call.place),
    )


def _help_for_spin(call: ApiCall) -> str:
    """What to write; where the limit is an argument of the function, its callers or its default leave it out."""
    if is_at_its_default(call):
        return (
            f"pass {call.function.rpartition('.')[2]}() a timeout where it is called, or give the parameter a "
            "default other than None"
        )
    return "set timeout_sec, and check future.done() afterwards"


@folds("TMO003")
def _of_one_function(findings: Sequence[Finding]) -> Finding:
    """The finding for all such spins of a function: an action's goal is sent, and then its result awaited."""
    return of_one_function(findings, "line", "it spins without a timeout here, too")
