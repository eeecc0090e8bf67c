"""EXE017: what a program means to do at its end, and Ctrl-C keeps from happening."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_humble
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding, Related
from archlint.python_code.skipped_endings import SkippedEnding, skipped_endings

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE017", scope=Scope.CODE)
def skipped_ending(system: System, options: Options) -> Iterator[Finding]:
    """Lines behind a spin that publish or write a file, where nothing catches what Ctrl-C raises."""
    if system.workspace is not None:
        for row in skipped_endings(system.workspace):
            runs_on = is_from_before_humble(system.workspace)  # Ctrl-C shuts no context down there: rclpy 3.2 began to
            yield from unless_uncalled(system, _finding(row, runs_on))


def _finding(row: SkippedEnding, runs_on: bool) -> Finding:
    spin = "loop" if row.in_loop else "spin"
    what = f"{row.name}(), which {row.effect}," if row.name else f"this line, which {row.effect},"
    cure = f"put it in the finally of a try around the {spin}"
    if row.effect == "publishes" and not runs_on:
        cure += ", and start with rclpy.init(signal_handler_options=SignalHandlerOptions.NO): rclpy runs on until then"
    done = [] if row.done_at is None else [Related(row.done_at, f"{row.name}() {row.effect} here")]
    return finding(
        "EXE017",
        row.place,
        f"{what} is not run after Ctrl-C: the {spin} on line {row.spin.line} ends with a KeyboardInterrupt then",
        help=cure,
        related=[Related(row.spin, "nothing catches what Ctrl-C raises here"), *done],
        identity=("ending", row.name, row.effect),
        group=(row.place.file,),
    )


@folds("EXE017")
def of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all of a file."""
    return with_others(findings, "another line is", "more lines are", "not run, either")


__all__ = ["of_one_file", "skipped_ending"]
