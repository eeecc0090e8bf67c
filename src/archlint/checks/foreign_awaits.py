"""EXE010: what needs asyncio's event loop, in callbacks that rclpy runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import one_for_each_place
from archlint.analysis.source_code import source_code
from archlint.checks.callback_findings import finding_in_callback
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.execution.callback_roles import callback_words
from archlint.finding import Finding, Related
from archlint.libraries.tables.event_loops import LIMITS, SLEEP, STARTS
from archlint.model import Role
from archlint.python_code.foreign_awaits import foreign_awaits, waits_for_an_answer
from archlint.python_code.spins_in_tasks import SpinInTask, spins_in_tasks

if TYPE_CHECKING:
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_IN_A_TIMER = "continue in a timer: create_timer(…), and cancel it when it has fired"
_UNTIL_A_TIMER = "await an rclpy.task.Future that a timer completes"
_IN_A_THREAD = "do this in a thread of its own, with asyncio.run()"
_UNTIL_EITHER = "await an rclpy.task.Future that a timer completes, or the answer in its add_done_callback()"


@rule("EXE010", scope=Scope.CODE)
def foreign_awaitable(system: System, options: Options) -> Iterator[Finding]:
    """Calls that end with the exception that there is no event loop, and spins that keep it from running."""
    yield from one_for_each_place(_finding(system, program, call) for program, call in foreign_awaits(system))
    for row in () if system.workspace is None else spins_in_tasks(system.workspace):
        yield from unless_uncalled(system, _blocking(row))


def _blocking(row: SpinInTask) -> Finding:
    return finding(
        "EXE010",
        row.place,
        f"{row.function}() spins and never gives the thread back to asyncio: the tasks beside it stand still",
        help="await asyncio.to_thread(rclpy.spin, node), or start the spin in a thread of its own",
        related=[Related(row.task, f"asyncio runs {row.function}() as a task here")],
        identity=("spin", row.function),
        group=(row.place.file, "spin", row.function),
    )


def _finding(system: System, program: Program, call: ApiCall) -> Finding:
    verb = "calls" if call.api == STARTS else "awaits"
    return finding_in_callback(
        "EXE010",
        system,
        program,
        call,
        f"{callback_words(call.context)} {verb} {call.api}(), which raises a RuntimeError: rclpy's executor is no "
        "event loop of asyncio",
        help=_help(system, call),
        identity=(call.api,),
        group=(call.place.file, call.context.name),
    )


def _help(system: System, call: ApiCall) -> str:
    """What to do instead; a handler that returns before its time has answered with nothing."""
    if call.api == LIMITS and waits_for_an_answer(source_code(system), call):
        return _UNTIL_EITHER
    if call.api != SLEEP:
        return _IN_A_THREAD
    return _UNTIL_A_TIMER if call.context.role in (Role.SERVICE, Role.EXECUTE) else _IN_A_TIMER


@folds("EXE010")
def of_one_callback(findings: Sequence[Finding]) -> Finding:
    """The first such call of a callback, with which it ends."""
    return with_others(findings, "another line does", "more lines do", "the same")
