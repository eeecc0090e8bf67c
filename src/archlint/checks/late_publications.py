"""EXE016: messages that a program publishes once rclpy is shut down."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.python_code.late_publications import LatePublication, late_publications

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE016", scope=Scope.CODE)
def late_publication(system: System, options: Options) -> Iterator[Finding]:
    """Publications behind a spin that Ctrl-C has ended, and behind a shutdown."""
    if system.workspace is not None:
        yield from map(_finding, late_publications(system.workspace))


def _finding(row: LatePublication) -> Finding:
    error, when, why = "an error", "here", "rclpy is shut down further up"
    cure = "publish it before the shutdown"
    if row.after_interrupt:
        error, when, why = "RCLError", "after Ctrl-C", "rclpy's own handler of the signal has shut it down before"
        cure = "start with rclpy.init(signal_handler_options=SignalHandlerOptions.NO): rclpy then runs on after Ctrl-C"
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
