"""EXE014: callbacks whose waits can take all threads of their executor, so that nobody is left to take an answer."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import (
    endpoint_words,
    node_name,
    one_for_each_place,
)
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.callback_roles import callback_words
from archlint.execution.crowded_executors import crowds
from archlint.execution.paces import Pace, pace_of
from archlint.execution.piling_events import PilingEvent, piling_events
from archlint.execution.piling_rates import PilingSleep, piling_sleeps
from archlint.execution.piling_waits import known_threads, piling_up
from archlint.execution.waits import Wait
from archlint.finding import Finding, Related
from archlint.model import Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ExecutorUse
    from archlint.systems.model import System

_OWN_GROUP = "give {} its own MutuallyExclusiveCallbackGroup(): it then takes one thread at most"
_CONTINUE_LATER = "send the request with call_async() and continue in a done callback, which blocks no thread"


@rule("EXE014", scope=Scope.CODE)
def thread_starvation(system: System, options: Options) -> Iterator[Finding]:
    """Timers that wait beside themselves, and executors with no more threads than callbacks that wait."""
    yield from one_for_each_place(_pile(system, wait) for wait in piling_up(system))
    yield from one_for_each_place(_pile_of_events(system, wait) for wait in piling_events(system))
    yield from one_for_each_place(_pile_of_sleeps(system, wait) for wait in piling_sleeps(system))
    yield from one_for_each_place(_crowd(system, use, here) for use, here in crowds(system))


def _pile(system: System, wait: Wait) -> Finding:
    call, callback = wait.call, wait.call.context
    threads = known_threads(wait)
    pace = pace_of(system, callback)
    assert pace is not None
    all_ = f"all {threads} threads wait" if threads is not None else "all threads wait"
    end = "every wait then times out" if wait.limited else "it then deadlocks"
    return finding_in_callback(
        "EXE014",
        system,
        wait.program,
        call,
        f"{callback_words(callback)} starts again every {pace.period:g} s while it still waits for "
        f"{endpoint_words(wait.client)}: if responses are late, {all_}, and no thread is left to process one: "
        f"{end}",
        help=_OWN_GROUP.format(callback.name) if callback.role == Role.SERVICE else _CONTINUE_LATER,
        client=wait.client,
        further=_sent(pace),
        identity=(wait.client.name.text or "", call.api),
    )


def _pile_of_events(system: System, wait: PilingEvent) -> Finding:
    callback, setter = wait.call.context, wait.setter
    all_ = f"all {wait.threads} threads wait" if wait.threads is not None else "all threads wait"
    end = "every wait then times out" if wait.limited else "it then deadlocks"
    return finding_in_callback(
        "EXE014",
        system,
        wait.program,
        wait.call,
        f"{callback_words(callback)} starts again every {wait.pace.period:g} s while it still waits for an event that "
        f"{setter.name} sets: if the event is late, {all_}, and no thread is left to run {setter.name}: {end}",
        help=_OWN_GROUP.format(callback.name),
        further=_sent(wait.pace),
        identity=(setter.name, "event"),
    )


def _pile_of_sleeps(system: System, wait: PilingSleep) -> Finding:
    callback = wait.call.context
    return finding_in_callback(
        "EXE014",
        system,
        wait.program,
        wait.call,
        f"{callback_words(callback)} starts again every {wait.pace.period:g} s while it still sleeps for up to "
        f"{wait.longest:g} s in Rate.sleep(): all {wait.threads} threads sleep, and no thread is left to run the "
        f"timer that wakes them: it then deadlocks",
        help=_OWN_GROUP.format(callback.name),
        further=_sent(wait.pace),
        identity=("Rate.sleep",),
    )


def _sent(pace: Pace) -> Iterator[Related]:
    """What brings a callback about that is no timer's."""
    if pace.sends is not None:
        words = {"send_goal_async": "a goal is sent", "call_async": "it is called"}
        sent = words.get(pace.sends.api.rpartition(".")[2], "it is published")
        yield Related(pace.sends.place, f"{sent} here every {pace.period:g} s")


def _crowd(system: System, use: ExecutorUse, waits: list[Wait]) -> Finding:
    place: Place | None = use.place
    assert place is not None and use.threads is not None
    names = " and ".join(dict.fromkeys(wait.call.context.name for wait in waits))
    limited = all(wait.limited for wait in waits)
    who = names if " and " in names else f"{len(waits)} runs of {names}"
    return finding(
        "EXE014",
        place,
        f"{who} {'' if limited else 'may '}wait at the same time, and this executor has {use.threads} threads: "
        f"none is left to process a response, and they {'time out' if limited else 'deadlock'}",
        help=f"num_threads={len(waits) + 1}: one more than there are waiting callbacks",
        related=tuple(
            Related(wait.call.place, f"{callback_words(wait.call.context)} waits for {endpoint_words(wait.client)}")
            for wait in waits
        ),
        node=node_name(system, waits[0].call.context.node),
        identity=(names,),
    )
