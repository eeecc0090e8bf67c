"""EXE002 and CBG001: callbacks that wait for what their own executor or group keeps out."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    endpoint_words,
    one_for_each_place,
)
from archlint.analysis.source_code import source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.joins import vain_joins
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.checks.wait_words import CONTINUE_WHEN_DONE, when_done
from archlint.execution import blocking
from archlint.execution.callback_roles import callback_words, runs_in_executor
from archlint.execution.deadlock import Verdict, group_relation, threads_of
from archlint.execution.early_results import EarlyResult, early_results, is_discarded
from archlint.execution.event_waits import EventWait, event_waits
from archlint.execution.stuck import is_spin, stuck_waits
from archlint.execution.waits import Wait
from archlint.finding import Finding
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.systems.model import System

_GROUP_HELP = (
    "give the client its own callback group (callback_group=MutuallyExclusiveCallbackGroup()), or " + CONTINUE_WHEN_DONE
)

_STORE = "continue in the callback that sets the event"
_OWN_GROUP = "give the callback that sets the event its own callback group, and wait here with a timeout"


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
            *map(partial(_no_answer_yet, system), _read_too_early(system)),
            *(_deaf(system, wait) for wait in event_waits(system)),
            *vain_joins(system, options),
        )
    )


@rule("CBG001", scope=Scope.CODE, by_program=True)
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
    same_group = (wait.kind == blocking.AWAIT or several) and one_group
    help_ = _GROUP_HELP if same_group else when_done(callback, call, wait.client)
    return finding_in_callback(
        code,
        system,
        wait.program,
        call,
        f"{callback_words(callback)} waits for {endpoint_words(wait.client)} and {verdict.words}: {verdict.why}",
        help=help_,
        client=wait.client,
        identity=(wait.client.name.text or "", call.api),
    )


def _read_too_early(system: System) -> Iterator[EarlyResult]:
    """The results that callbacks read before they are there, and that something uses."""
    for early in early_results(system):
        if runs_in_executor(early.call.context) and not is_discarded(source_code(system), early):
            yield early


def _no_answer_yet(system: System, early: EarlyResult) -> Finding:
    return finding_in_callback(
        "EXE002",
        system,
        early.program,
        early.call,
        f"{callback_words(early.call.context)} {_reads(early)}",
        help="future.add_done_callback(...) and read the result there",
        client=early.client,
        identity=(early.client.name.text or "", "result"),
    )


def _reads(early: EarlyResult) -> str:
    asked = endpoint_words(early.client)
    if early.slept:
        return f"sleeps and then reads result(): no response from {asked} is taken meanwhile, so it is None"
    return f"reads result() right after call_async(): {asked} has not responded yet, so it is None"


def _deaf(system: System, wait: EventWait) -> Finding:
    end = blocking.Outcome.TIMES_OUT if wait.limited else blocking.Outcome.HANGS
    return finding_in_callback(
        "EXE002",
        system,
        wait.program,
        wait.call,
        f"{callback_words(wait.call.context)} waits for an event that {wait.setter.name} sets, and {end}: {wait.why}",
        help=_to_hear(wait),
        identity=(wait.setter.name, "event"),
    )


def _to_hear(wait: EventWait) -> str:
    """What to do: who answers a request or a goal must have heard before it returns."""
    callback = wait.call.context
    if callback.role not in (Role.SERVICE, Role.EXECUTE):
        return _STORE
    several = threads_of(callback.node, wait.program) == blocking.SEVERAL
    return _OWN_GROUP if several else f"spin the node with a MultiThreadedExecutor, {_OWN_GROUP}"
