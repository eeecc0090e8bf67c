"""Waits of callbacks that keep a thread of their executor, and that end well by themselves."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.execution.blocking import CALL
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.deadlock import judge_wait
from archlint.execution.waits import DONE, Wait, waits

if TYPE_CHECKING:
    from archlint.model import ApiCall
    from archlint.systems.model import System


def complete_wait(call: ApiCall) -> ApiCall:
    """The wait as a whole: ``while not future.done()`` is one, where the loop stands."""
    return replace(call, loops=call.loops[:-1]) if call.api == DONE else call


@once
def threaded_waits(system: System) -> list[Wait]:
    """The waits of callbacks that keep a thread, and that groups and executor let end well."""
    return [
        wait
        for wait in waits(system)
        if wait.kind == CALL and runs_in_executor(wait.call.context) and not wait.call.conditional
        if judge_wait(CALL, wait.call, wait.client, wait.program, wait.limited).safe
    ]
