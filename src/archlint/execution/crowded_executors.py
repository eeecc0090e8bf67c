"""Executors with no more threads than callbacks that may wait at the same time."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.source_code import SourceCode, source_code
from archlint.execution.polling import is_unguarded
from archlint.execution.sleeps import stay_of
from archlint.execution.threaded_waits import complete_wait, threaded_waits
from archlint.execution.waits import Wait
from archlint.model import ExecutorKind, GroupKind, Role

if TYPE_CHECKING:
    from archlint.model import ExecutorUse, Program
    from archlint.systems.model import System

_Slot = tuple[int, str]
"""What lets one of its callbacks run at a time: a node's (its ``id``) default group, or a group by its key."""


def crowds(system: System) -> Iterator[tuple[ExecutorUse, list[Wait]]]:
    """The executors with as few threads as there are callbacks that may wait at the same time, one wait for each."""
    code = source_code(system)
    by_program: dict[int, tuple[Program, list[Wait]]] = {}
    for wait in threaded_waits(system):
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


def _coincide(code: SourceCode, waits: Collection[Wait]) -> bool:
    """Whether waits that end by themselves come at the same time, and again and again: timers of one period that a
    function makes one after the other."""
    if not any(wait.limited for wait in waits):
        return True
    timers = [wait.call.context.creation for wait in waits if wait.call.context.creation is not None]
    timer_keys = {
        (timer.period, timer.place.file, timer.function, id(timer.node), timer.conditional) for timer in timers
    }
    first, last = min(timer.place for timer in timers), max(timer.place for timer in timers)
    between = (
        call
        for call in next(iter(waits)).program.calls
        if call.function == timers[0].function and first < call.place < last
    )
    return len(timer_keys) == 1 and not any(stay_of(code, call) for call in between)


def _period(code: SourceCode, wait: Wait) -> float | None:
    """The period of a timer that waits each time, one wait for each tick."""
    creation = wait.call.context.creation
    if wait.call.context.role != Role.TIMER or creation is None or not is_unguarded(code, complete_wait(wait.call)):
        return None
    return creation.period


def _slots(use: ExecutorUse, waits: list[Wait]) -> dict[_Slot, Wait]:
    slots: dict[_Slot, Wait] = {}
    for wait in waits:
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
