"""EXE016: messages that a program publishes once rclpy is shut down."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_humble
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import EntityKind
from archlint.python_code.late_publications import LatePublication, late_publications

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE016", scope=Scope.CODE)
def late_publication(system: System, options: Options) -> Iterator[Finding]:
    """Publications behind a spin that Ctrl-C has ended, and behind a shutdown."""
    if system.workspace is not None:
        # Before Humble Ctrl-C shuts no context down: rclpy 3.2 began to.
        runs_on = is_from_before_humble(system.workspace)
        for row in (row for row in late_publications(system.workspace) if not (runs_on and row.after_interrupt)):
            yield _finding(row, _may_sleep_on(system, row.place.file))


def _may_sleep_on(system: System, file: str) -> bool:
    """Whether no node of the programs of a file has a timer: without rclpy's handler, nothing but a message then wakes
    the spin that Ctrl-C is to end."""
    programs = [program for program in system.programs if program.file == file]
    creations = (row for program in programs for node in program.nodes for row in node.creations)
    return bool(programs) and not any(row.kind == EntityKind.TIMER for row in creations)


def _finding(row: LatePublication, may_sleep_on: bool) -> Finding:
    error, when, why = "an error", "here", "rclpy is shut down further up"
    cure = "publish it before the shutdown"
    if row.after_interrupt:
        error, when, why = "RCLError", "after Ctrl-C", "rclpy's own handler of the signal has shut it down before"
        cure = "start with rclpy.init(signal_handler_options=SignalHandlerOptions.NO): rclpy then runs on after Ctrl-C"
        if may_sleep_on:
            cure += "; and give the node a timer, without which its spin goes on after Ctrl-C until a message comes"
    what = f"{row.method}() publishes, which raises {error}" if row.method else f"this raises {error}"
    return finding(
        "EXE016",
        row.place,
        f"{when} {what}, and the message is not sent: {why}",
        help=cure,
        related=[] if row.publishes is None else [Related(row.publishes, f"{row.method}() publishes here")],
        identity=("publish", row.method),
        group=(row.place.file, str(row.after_interrupt)),
    )


@folds("EXE016")
def of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all of a file: one line of the program mends them."""
    return with_others(findings, "another line does", "more lines do", "the same", "here, too")
