"""Calls with which callbacks keep their thread for longer than a moment, in code that is in use, and others waiting."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.order import is_called_in_branches
from archlint.analysis.reach import argument, judged_calls
from archlint.analysis.source_code import source_code
from archlint.execution.callback_roles import runs_in_executor
from archlint.execution.commands import ends_the_machine, goes_on_behind, is_soon_over, makes_a_file
from archlint.execution.kept_waiting import blocks_nobody
from archlint.execution.loop_times import in_loops
from archlint.execution.openings import lets_settle
from archlint.execution.own_timers import ends_its_timer_after, ends_its_timer_before, gives_up_at_a_miss, runs_once
from archlint.execution.present_servers import is_there
from archlint.execution.processes import is_signalled_to_end
from archlint.execution.recoveries import brings_up_again
from archlint.execution.retries import around_future, is_retry
from archlint.execution.sleeps import Stay, stay_of
from archlint.execution.spins import is_never_spun_at_all
from archlint.execution.starting_threads import is_after_a_join, waits_for_its_thread
from archlint.execution.ways_out import ends_at_a_miss, ends_with_the_node, hands_over, says_farewell
from archlint.model import Role
from archlint.model.given import Constant

if TYPE_CHECKING:
    from archlint.model import ApiCall, Callback, Program
    from archlint.systems.model import System

MOMENT = 0.25
"""Seconds of a sleep that are not worth a word, unless a loop adds them up or a timer comes more often."""
_NOW_AND_THEN = 0.1
"""Seconds of a sleep under a condition that a timer may lose: a few of its turns, once."""
DISCOVERY = 1.0
"""Seconds that a callback may look for a server."""
_TRIFLES = frozenset({"clear", "cls", "reset", ""})

LongStay = tuple["Program", "ApiCall", Stay]
"""A call of a callback, in the program that runs it, and for how long it stays there."""


def long_stays(system: System) -> Iterator[LongStay]:
    code = source_code(system)
    for program, call in judged_calls(system):
        stay = stay_of(code, call) if runs_in_executor(call.context) else None
        if stay is None or _trifle(call) or not _is_long(system, call, stay) or blocks_nobody(call.context, program):
            continue
        if (
            is_signalled_to_end(code, call)
            or (stay.kind == "discovery" and is_there(system, call))
            or ends_with_the_node(code, call, stay)
            or ends_the_machine(code, call)
            or (stay.kind == "process" and goes_on_behind(code, call))
            or (stay.kind in ("discovery", "process") and runs_once(system, call))
            or (stay.kind == "discovery" and (gives_up_at_a_miss(system, call) or ends_at_a_miss(code, call)))
            or (stay.kind in ("sleep", "process") and brings_up_again(code, call))
            or (stay.kind == "sleep" and lets_settle(code, call, stay))
            or hands_over(code, call, stay)
            or says_farewell(code, call, stay)
            or (stay.kind == "process" and (not call.looped or is_retry(code, call)) and is_soon_over(code, call))
            or (stay.kind == "process" and call.context.role == Role.SERVICE and makes_a_file(code, call))
            or (stay.kind == "sleep" and (waits_for_its_thread(code, call) or is_after_a_join(code, call)))
            or _is_no_program(system, call.context)
            or (call.context.node is not None and is_never_spun_at_all(code, program, call.context.node))
        ):
            continue
        yield program, call, stay


def _is_long(system: System, call: ApiCall, stay: Stay) -> bool:
    if stay.kind == "discovery":
        return stay.seconds is not None and stay.seconds > DISCOVERY
    if around_future(source_code(system), call):
        return False
    if stay.kind not in ("sleep", "process") or stay.seconds is None:
        return True
    period, seconds = period_of(system, call), in_loops(source_code(system), call, stay, with_callers=True)
    if seconds > MOMENT or period is None:
        return seconds > MOMENT
    return seconds > period and (seconds > _NOW_AND_THEN or not is_called_in_branches(source_code(system), call))


def _trifle(call: ApiCall) -> bool:
    """``os.system('clear')``: over before anybody notices."""
    command = argument(call, "command")
    return command is not None and all(
        isinstance(option, Constant) and option.value in _TRIFLES for option in command.alternatives
    )


def period_of(system: System, call: ApiCall) -> float | None:
    """The seconds after which a callback runs again; None where nobody knows, or where it ends its own timer."""
    creation = call.context.creation
    ended = ends_its_timer_before(system, call) or ends_its_timer_after(system, call)
    return None if creation is None or ended else creation.period


def _is_no_program(system: System, callback: Callback) -> bool:
    """Whether the callback's node is in a script of a package that installs others: nobody starts it."""
    workspace, node = system.workspace, callback.node
    file = callback.place.file if node is None else node.place.file
    return workspace is not None and workspace.package_of(file) is not None and is_not_installed(workspace, file)


__all__ = ["LongStay", "long_stays", "period_of"]
