"""EXE001: callbacks that spin."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_humble_alone
from archlint.analysis.reach import (
    argument,
    creations_of,
    has_limit,
    judged_calls,
    one_for_each_place,
)
from archlint.analysis.source_code import source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import when_done
from archlint.execution import blocking
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.deadlock import judge_spin, threads_of
from archlint.execution.spin_flags import is_while_nobody_spins
from archlint.execution.spins import KEPT_IN_HUMBLE_SINCE, is_dropped_in_humble, is_left_to, is_spin_call, spun_node
from archlint.execution.stuck import nested_spins
from archlint.execution.waits import name_of_future
from archlint.finding import Finding, Severity
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Creation, Program
    from archlint.systems.model import System


@rule("EXE001", scope=Scope.CODE, by_program=True)
def spin_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Spins that a callback reaches; of a line where a service handler spins for an answer, SRV003 speaks."""
    reported = nested_spins(system, options.distros)
    yield from one_for_each_place(
        diagnostic
        for program, call in judged_calls(system)
        if is_spin_call(call) and runs_in_executor(call.context)
        if not is_while_nobody_spins(source_code(system), call)
        if reported.isdisjoint((call.place, *call.loops[-1:]))
        for diagnostic in _nested_spin(system, program, call, options)
    )


def _nested_spin(system: System, program: Program, call: ApiCall, options: Options) -> Iterator[Finding]:
    clients = creations_of(argument(call, "future"))
    client = clients[0] if clients else None
    spun = spun_node(call, program)
    limited = has_limit(call, "timeout_sec")
    verdict = replace(judge_spin(call, spun, client, program, limited, options.distros), limited=limited)
    if verdict.safe and set(verdict.outcomes.values()) == {blocking.Outcome.FINE} and spun is not call.context.node:
        return
    if is_dropped_in_humble(call, spun, program):
        verdict = verdict.stranding_before("humble", KEPT_IN_HUMBLE_SINCE)
    if verdict.unknown:
        return
    if verdict.outcomes.get("humble") is blocking.Outcome.FINE and is_for_humble_alone(system.workspace):
        return  # it works there, and what comes with another distribution nobody has asked for
    function = call.api.rpartition(".")[2]
    diagnostic = finding_in_callback(
        "EXE001",
        system,
        program,
        call,
        f"{callback_words(call.context)} calls {function}(), and {verdict.why}: this {verdict.words}",
        help=_instead_of_spinning(system, program, call, spun, client),
        client=client,
        identity=(function,),
        group=_cured_together(program, call, spun),
    )
    works_somewhere = verdict.safe or blocking.Outcome.FINE in verdict.outcomes.values()
    yield replace(diagnostic, severity=Severity.WARNING) if works_somewhere else diagnostic


def _cured_together(program: Program, call: ApiCall, spun: Blueprint | None) -> tuple[str, ...]:
    """What one change mends: an executor for the other node does so for all callbacks of a node that spin it."""
    callback = call.context
    if spun is not None and callback.node is not None and is_left_to(call, spun, program):
        return (callback.place.file, str(callback.node.place), str(spun.place))
    return (callback.place.file, str(callback.place.line), callback.name)


def _instead_of_spinning(
    system: System, program: Program, call: ApiCall, spun: Blueprint | None, client: Creation | None
) -> str:
    """What to do; whoever spins in a loop waits for something, and the answer of a handler must wait for it, too."""
    if is_left_to(call, spun, program):
        return OWN_EXECUTOR.format(call.api.rpartition(".")[2])
    if argument(call, "future") is not None:
        return when_done(call.context, call, client, name_of_future(source_code(system), call))
    several = threads_of(call.context.node, program) == blocking.SEVERAL
    if call.looped and call.context.role == Role.EXECUTE:
        return _PAUSE if several else f"spin the node with a MultiThreadedExecutor, and {_PAUSE}"
    if call.looped and call.context.role == Role.SERVICE:
        return _EVENT if several else f"spin the node with a MultiThreadedExecutor, and {_EVENT}"
    return "return instead: the executor runs the other callbacks once this one has returned"


OWN_EXECUTOR = "add the other node to a SingleThreadedExecutor() of its own, and call that executor's {}() here"
_PAUSE = "use time.sleep(…) instead: the executor's other threads keep running callbacks"
_EVENT = "wait for a threading.Event with a timeout; put the callback that sets it into another callback group"


@folds("EXE001", across_severities=True)
def _of_one_callback(findings: Sequence[Finding]) -> Finding:
    """The finding for all spins of one callback, which must do without any, or of another node, which needs an executor
    of its own.  The worst of them leads."""
    worst_first = sorted(findings, key=lambda finding: -finding.severity)
    return with_places(worst_first, "it spins here, too")
