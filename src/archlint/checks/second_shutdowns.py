"""EXE015: programs that shut rclpy down after Ctrl-C has done so."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_humble_to_jazzy, may_be_of_old_template, names_no_distro
from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.python_code.second_shutdowns import RAISING, second_shutdowns

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("EXE015", scope=Scope.CODE)
def second_shutdown(system: System, options: Options) -> Iterator[Finding]:
    """Shutdowns that raise an error whenever Ctrl-C ends the program, where the workspace is for a distribution that
    has it so, or may be for any."""
    workspace = system.workspace
    if workspace is None:
        return
    certain = RAISING.issuperset(options.distros) or is_from_humble_to_jazzy(workspace)
    open_to_all = RAISING.issubset(options.distros) and names_no_distro(workspace)
    if not certain and (not open_to_all or may_be_of_old_template(workspace)):
        return
    where = "" if certain else f" on {' and '.join(sorted(map(str.capitalize, RAISING)))}"
    for place in second_shutdowns(workspace):
        yield finding(
            "EXE015",
            place,
            f"after Ctrl-C this raises RCLError{where}: rclpy's own handler of the signal has shut it down before",
            help="write rclpy.try_shutdown()",
            identity=("shutdown",),
            group=("shutdown",),
        )


@folds("EXE015")
def of_one_workspace(findings: Sequence[Finding]) -> Finding:
    """One finding for all programs: they have it of each other."""
    return with_others(findings, "another program does", "more programs do", "the same", "here, too")
