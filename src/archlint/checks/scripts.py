"""PKG006: installed scripts that the operating system cannot start."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.packaging.unstartable_scripts import Unstartable, unstartable_scripts

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("PKG006", scope=Scope.WORKSPACE, in_use=True)
def script_without_interpreter(system: System, options: Options) -> Iterator[Finding]:
    """Installed scripts whose first line does not say what runs them."""
    workspace = workspace_of(system)
    if workspace is not None:
        yield from map(_finding, unstartable_scripts(workspace))


def _finding(row: Unstartable) -> Finding:
    name, package = row.executable.name, row.executable.package
    if row.carriage_return:
        why, help = "its lines end in \\r\\n, and no interpreter is called so", "save the file with Unix line endings"
    elif row.below:
        why, help = f"its #! line is line {row.below}, and not the first", "move the #! line to the top of the file"
    else:
        why, help = "it does not begin with a #! line", "begin the file with #!/usr/bin/env python3"
    started = [] if row.started_at is None else [Related(row.started_at, "it is started here")]
    return finding(
        "PKG006",
        Place(row.script, 1, 1, 1, 1),
        f"ros2 run and launch cannot start '{name}' of package '{package}': {why}",
        help=help,
        related=[Related(row.executable.place, "it is installed as a program here"), *started],
        identity=(package, name),
        group=(package, str(row.carriage_return)),
    )


@folds("PKG006")
def _of_one_package(findings: Sequence[Finding]) -> Finding:
    """One finding for all such scripts of a package."""
    first, *others = findings
    return with_others(findings, "another script is", "more scripts are", "like that") if others else first
