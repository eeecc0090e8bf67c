"""EXE001, EXE002 and CBG001: callbacks that spin, or wait for what their own executor or group keeps out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis import blocking
from archlint.analysis.callback_roles import callback_words, related_to, runs_in_executor
from archlint.analysis.deadlock import Verdict, group_relation, judge_spin, threads_of
from archlint.analysis.early_results import EarlyResult, early_results
from archlint.analysis.event_waits import EventWait, event_waits
from archlint.analysis.reach import (
    argument,
    creations_of,
    endpoint_words,
    has_limit,
    judged_calls,
    node_name,
    one_for_each_place,
)
from archlint.analysis.spins import is_left_to, is_spin_call, spun_node
from archlint.analysis.stuck import is_spin, nested_spins, stuck_waits
from archlint.analysis.waits import Wait
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.model import ApiCall, Blueprint, Program
    from archlint.systems.model import System

_DONE = "send the request with call_async(), return, and continue in a done callback"
_GROUP_HELP = "give the client its own callback group (callback_group=MutuallyExclusiveCallbackGroup()), or " + _DONE


# --------------------------------------------------------------------------------------------------- EXE001


@rule("EXE001", scope=Scope.CODE)
def spin_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Spins that a callback reaches; of those of a service handler for an answer, SRV003 speaks."""
    reported = nested_spins(system, options.distros)
    yield from one_for_each_place(
        found
        for program, call in judged_calls(system)
        if is_spin_call(call) and runs_in_executor(call.context)
        if reported.isdisjoint((call.context.place, one) for one in (call.place, *call.loops[-1:]))
        for found in _nested_spin(system, program, call, options)
    )


def _nested_spin(system: System, program: Program, call: ApiCall, options: Options) -> Iterator[Finding]:
    clients = creations_of(argument(call, "future"))
    client = clients[0] if clients else None
    spun = spun_node(call, program)
    limited = has_limit(call, "timeout_sec")
    verdict = judge_spin(call, spun, client, program, limited, options.distros)
    if verdict.safe and set(verdict.outcomes.values()) == {blocking.FINE} and spun is not call.context.node:
        return
    if verdict.unknown:
        return
    function = call.api.rpartition(".")[2]
    found = finding(
        "EXE001",
        call.place,
        f"{callback_words(call.context)} calls {function}(), and {verdict.why}: this {verdict.words}",
        help=_instead_of_spinning(program, call, spun),
        related=tuple(related_to(call, program, client)),
        node=node_name(system, call.context.node),
        identity=(call.context.name, function),
        group=(call.context.place.file, str(call.context.place.line), call.context.name),
    )
    yield replace(found, severity=Severity.WARNING) if verdict.safe else found


def _instead_of_spinning(program: Program, call: ApiCall, spun: Blueprint | None) -> str:
    """What to do; whoever spins in a loop waits for something, and the answer of a handler must wait for it, too."""
    if is_left_to(call, spun, program):
        return _OWN_EXECUTOR.format(call.api.rpartition(".")[2])
    if argument(call, "future") is not None:
        return _DONE
    several = threads_of(call.context.node, program) == blocking.SEVERAL
    if call.looped and call.context.role == Role.EXECUTE:
        return _PAUSE if several else f"spin the node with a MultiThreadedExecutor, and {_PAUSE}"
    if call.looped and call.context.role == Role.SERVICE:
        return _EVENT if several else "make it an action: its execute callback may take long on a MultiThreadedExecutor"
    return "return instead: the executor runs the other callbacks once this one has returned"


_OWN_EXECUTOR = "add the other node to a SingleThreadedExecutor() of its own, and call that executor's {}() here"
_PAUSE = "use time.sleep(…) instead: the executor's other threads keep running callbacks"
_EVENT = "wait for a threading.Event with a timeout; put the callback that sets it into another callback group"


@folds("EXE001")
def _of_one_callback(findings: Sequence[Finding]) -> Finding:
    """The finding for all spins of one callback: it must do without any."""
    first, *others = findings
    return replace(first, related=(*first.related, *(Related(one.place, "it spins here, too") for one in others)))


# ------------------------------------------------------------------------------------------- EXE002, CBG001


@rule("EXE002", scope=Scope.CODE)
def blocking_call_in_callback(system: System, options: Options) -> Iterator[Finding]:
    """Waits of callbacks that can never get what they wait for."""
    yield from one_for_each_place(
        (
            *(
                _stuck("EXE002", system, wait, v, options)
                for wait, v in _judged(system, options)
                if not _by_group(wait)
            ),
            *(_no_answer_yet(system, early) for early in early_results(system)),
            *(_deaf(system, wait) for wait in event_waits(system)),
        )
    )


@rule("CBG001", scope=Scope.CODE)
def shared_exclusive_group(system: System, options: Options) -> Iterator[Finding]:
    """Waits of callbacks that several threads could serve, if they did not hold the client's group."""
    yield from one_for_each_place(
        _stuck("CBG001", system, wait, verdict, options)
        for wait, verdict in _judged(system, options)
        if _by_group(wait)
    )


def _judged(system: System, options: Options) -> Iterator[tuple[Wait, Verdict]]:
    """The waits of callbacks other than service handlers that do not end well, for certain."""
    return (row for row in stuck_waits(system, options.distros) if not is_spin(row[0]))


def _by_group(wait: Wait) -> bool:
    """Whether the callback group alone keeps the answer out, though there are threads."""
    callback = wait.call.context
    return (
        threads_of(callback.node, wait.program) == blocking.SEVERAL
        and wait.client.node is callback.node
        and group_relation(callback.group, wait.client.group) == blocking.SAME
    )


def _stuck(code: str, system: System, wait: Wait, verdict: Verdict, options: Options) -> Finding:
    call, callback = wait.call, wait.call.context
    several = threads_of(callback.node, wait.program) == blocking.SEVERAL
    one_group = group_relation(callback.group, wait.client.group) == blocking.SAME
    help_ = _GROUP_HELP if (wait.kind == blocking.AWAIT or several) and one_group else _DONE
    return finding(
        code,
        call.place,
        f"{callback_words(callback)} waits for {endpoint_words(wait.client)} and {verdict.words}: {verdict.why}",
        help=help_,
        related=tuple(related_to(call, wait.program, wait.client)),
        node=node_name(system, callback.node),
        identity=(callback.name, wait.client.name.text or "", call.api),
    )


def _no_answer_yet(system: System, early: EarlyResult) -> Finding:
    call, callback = early.call, early.call.context
    return finding(
        "EXE002",
        call.place,
        f"{callback_words(callback)} reads result() right after call_async(): {endpoint_words(early.client)} has "
        "not responded yet, so it is None",
        help="future.add_done_callback(...) and read the result there",
        related=tuple(related_to(call, early.program, early.client)),
        node=node_name(system, callback.node),
        identity=(callback.name, early.client.name.text or "", "result"),
    )


def _deaf(system: System, wait: EventWait) -> Finding:
    call, callback = wait.call, wait.call.context
    end = blocking.TIMES_OUT if wait.limited else blocking.HANGS
    return finding(
        "EXE002",
        call.place,
        f"{callback_words(callback)} waits for an event that {wait.setter.name} sets, and {end}: {wait.why}",
        help="store what arrives in an attribute and continue in the callback that receives it",
        related=tuple(related_to(call, wait.program)),
        node=node_name(system, callback.node),
        identity=(callback.name, wait.setter.name, "event"),
    )
