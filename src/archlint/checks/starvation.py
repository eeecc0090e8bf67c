"""EXE014: callbacks whose waits can take all threads of their executor, so that nobody is left to take an answer."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.blocking import CALL
from archlint.analysis.callback_roles import callback_words, related_to, runs_in_executor
from archlint.analysis.deadlock import judge_wait
from archlint.analysis.kept import once
from archlint.analysis.polling import is_unguarded, notes_that_it_ran
from archlint.analysis.reach import (
    argument,
    calls_of,
    endpoint_words,
    node_name,
    one_for_each_place,
)
from archlint.analysis.sleeps import longest, stay_of
from archlint.analysis.source_code import SourceCode, source_code
from archlint.analysis.waits import DONE, Wait, waits
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import ExecutorKind, GroupKind, Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import ApiCall, ExecutorUse, Program
    from archlint.systems.model import System

_OFTEN_S = 1.0
"""The longest period of a timer whose ticks are said to come often."""
_ENDS_TIMER = ("rclpy.timer.Timer.cancel", "rclpy.node.Node.destroy_timer")

_Slot = tuple[int, str]
"""What lets one of its callbacks run at a time: a node's (its ``id``) default group, or a group by its key."""


@rule("EXE014", scope=Scope.CODE)
def thread_starvation(system: System, options: Options) -> Iterator[Finding]:
    """Timers that wait beside themselves, and executors with no more threads than callbacks that wait."""
    yield from one_for_each_place(_pile(system, wait) for wait in piling_up(system))
    yield from one_for_each_place(_crowd(system, use, here) for use, here in _crowds(system))


# ------------------------------------------------------------------------------------------ one timer


@once
def piling_up(system: System) -> list[Wait]:
    """The waits of timers in reentrant groups that a late answer multiplies, a thread a tick, until none is left."""
    code = source_code(system)
    stopped = {call.context.place for _, call in calls_of(system, _ENDS_TIMER)}
    return [wait for wait in _threaded(system) if wait.call.context.place not in stopped and _outruns(code, wait)]


def _outruns(code: SourceCode, wait: Wait) -> bool:
    """Whether enough ticks come, for certain, while the first still waits."""
    callback, creation = wait.call.context, wait.call.context.creation
    reentrant = callback.group is not None and callback.group.kind == GroupKind.REENTRANT
    period = None if creation is None else creation.period
    if callback.role != Role.TIMER or not reentrant or period is None or not 0 < period <= _OFTEN_S:
        return False
    if not is_unguarded(code, _outside_of_its_loop(wait.call)) or notes_that_it_ran(code, wait.call):
        return False
    if not wait.limited:
        return True
    limit, threads = _limit(wait), _threads(wait)
    # The first tick has a thread at once, the last thread is taken so many periods later.
    return limit is not None and threads is not None and limit > period * (threads - 1)


def _outside_of_its_loop(call: ApiCall) -> ApiCall:
    """The wait as a whole: ``while not future.done()`` is one, where the loop stands."""
    return replace(call, loops=call.loops[:-1]) if call.api == DONE else call


def _limit(wait: Wait) -> float | None:
    if wait.call.api == DONE:
        return wait.call.limits[-1] if wait.call.limits else None
    given = (argument(wait.call, name) for name in ("timeout_sec", "timeout"))
    return next((longest(value) for value in given if value is not None), None)


def _threads(wait: Wait) -> int | None:
    """How many threads there are, at least by what is written; None where the machine decides."""
    node = wait.call.context.node
    uses = [] if node is None else wait.program.executors_of(node)
    numbers = [use.threads for use in uses if use.kind == ExecutorKind.MULTI_THREADED]
    known = [number for number in numbers if number is not None]
    return max(known) if known and len(known) == len(numbers) else None


def _pile(system: System, wait: Wait) -> Finding:
    call, callback = wait.call, wait.call.context
    threads = _threads(wait)
    assert callback.creation is not None
    all_ = f"all {threads} threads wait" if threads is not None else "all threads wait"
    end = "every wait then times out" if wait.limited else "it then deadlocks"
    return finding(
        "EXE014",
        call.place,
        f"{callback_words(callback)} starts again every {callback.creation.period:g} s while it still waits for "
        f"{endpoint_words(wait.client)}: if responses are late, {all_}, and no thread is left to process one: "
        f"{end}",
        help="send the request with call_async() and continue in a done callback, which blocks no thread",
        related=tuple(related_to(call, wait.program, wait.client)),
        node=node_name(system, callback.node),
        identity=(callback.name, wait.client.name.text or "", call.api),
    )


# ------------------------------------------------------------------------------------------ one executor


def _crowds(system: System) -> Iterator[tuple[ExecutorUse, list[Wait]]]:
    """The executors with as few threads as there are callbacks that may wait at the same time, one wait for each."""
    code = source_code(system)
    by_program: dict[int, tuple[Program, list[Wait]]] = {}
    for wait in _threaded(system):
        by_program.setdefault(id(wait.program), (wait.program, []))[1].append(wait)
    for program, here in by_program.values():
        for use in program.executors:
            if (
                use.kind == ExecutorKind.MULTI_THREADED
                and use.threads is not None
                and use.place is not None
                and not use.astray
            ):
                slots = _slots(use, [wait for wait in here if not wait.limited])
                if not slots:
                    slots = _slots(use, [wait for wait in here if _period(code, wait) is not None])
                if 1 < use.threads <= len(slots) and _coincide(code, slots.values()):
                    yield use, list(slots.values())


def _coincide(code: SourceCode, found: Collection[Wait]) -> bool:
    """Whether waits that end by themselves come at the same time, and again and again: timers of one period that a
    function makes one after the other."""
    if not any(wait.limited for wait in found):
        return True
    timers = [wait.call.context.creation for wait in found if wait.call.context.creation is not None]
    made = {(timer.period, timer.place.file, timer.function, id(timer.node), timer.conditional) for timer in timers}
    first, last = min(timer.place for timer in timers), max(timer.place for timer in timers)
    between = (
        call
        for call in next(iter(found)).program.calls
        if call.function == timers[0].function and first < call.place < last
    )
    return len(made) == 1 and not any(stay_of(code, call) for call in between)


def _period(code: SourceCode, wait: Wait) -> float | None:
    """The period of a timer that waits each time, one wait for each tick."""
    creation = wait.call.context.creation
    if (
        wait.call.context.role != Role.TIMER
        or creation is None
        or not is_unguarded(code, _outside_of_its_loop(wait.call))
    ):
        return None
    return creation.period


def _slots(use: ExecutorUse, found: list[Wait]) -> dict[_Slot, Wait]:
    slots: dict[_Slot, Wait] = {}
    for wait in found:
        callback = wait.call.context
        node, group = callback.node, callback.group
        if node is None or group is None or node not in use.nodes or _spun_elsewhere(wait, use):
            continue
        if group.kind == GroupKind.DEFAULT:
            slots.setdefault((id(node), ""), wait)
        elif group.kind == GroupKind.MUTUALLY_EXCLUSIVE and group.key is not None:
            slots.setdefault((0, group.key), wait)
        elif group.kind == GroupKind.REENTRANT:
            slots.setdefault((id(callback), callback.place.file), wait)
    return slots


def _spun_elsewhere(wait: Wait, use: ExecutorUse) -> bool:
    """Whether another executor has the client's node, whose threads may take the answer."""
    return any(other is not use for other in wait.program.executors_of(wait.client.node))


def _crowd(system: System, use: ExecutorUse, found: list[Wait]) -> Finding:
    place: Place | None = use.place
    assert place is not None and use.threads is not None
    names = " and ".join(dict.fromkeys(wait.call.context.name for wait in found))
    limited = all(wait.limited for wait in found)
    who = names if " and " in names else f"{len(found)} runs of {names}"
    return finding(
        "EXE014",
        place,
        f"{who} {'' if limited else 'may '}wait at the same time, and this executor has {use.threads} threads: "
        f"none is left to process a response, and they {'time out' if limited else 'deadlock'}",
        help=f"num_threads={len(found) + 1}: one more than there are waiting callbacks",
        related=tuple(
            Related(wait.call.place, f"{callback_words(wait.call.context)} waits for {endpoint_words(wait.client)}")
            for wait in found
        ),
        node=node_name(system, found[0].call.context.node),
        identity=(names,),
    )


# ------------------------------------------------------------------------------------------ both


@once
def _threaded(system: System) -> list[Wait]:
    """The waits of callbacks that keep a thread, and that groups and executor let end well."""
    return [
        wait
        for wait in waits(system)
        if wait.kind == CALL and runs_in_executor(wait.call.context) and not wait.call.conditional
        if judge_wait(CALL, wait.call, wait.client, wait.program, wait.limited).safe
    ]
