"""LCH003: arguments that a well-known launch file from elsewhere does not take."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.well_known_includes import unknown_to_includes
from archlint.suggestions import did_you_mean, nearest

if TYPE_CHECKING:
    from archlint.launch.model import Launched
    from archlint.launch_files.well_known_includes import UnknownToInclude
    from archlint.systems.model import WorkspaceIndex

PASSED_TO_ALL = frozenset({"use_sim_time"})
"""Arguments that launch files hand to every include as a matter of course, to those of drivers as well."""


def unknown_elsewhere(workspace: WorkspaceIndex, launched: Launched) -> Iterator[Finding]:
    """One finding for an include."""
    yield from map(_unknown, unknown_to_includes(workspace, launched))


def _unknown(row: UnknownToInclude) -> Finding:
    """What a well-known launch file from elsewhere does not take, in any distribution since humble."""
    (first, place), *others = row.given
    names = [name for name, _ in row.given]
    said = f"takes no launch argument '{first}' since Humble" + did_you_mean(first, row.taken)
    if others:
        said = "takes none of these launch arguments since Humble: " + ", ".join(f"'{name}'" for name in names)
    near = nearest(first, row.taken)
    see = f"ros2 launch {row.package} {row.file} --show-args lists those that it takes"
    diagnostic = finding(
        "LCH003",
        place,
        f"{row.file} of {row.package} {said}",
        help=f"write '{near}': the value has no effect"
        if near and not others
        else f"the value has no effect: remove it; {see}",
        related=[Related(at, f"'{name}' is set here" + did_you_mean(name, row.taken)) for name, at in others],
        identity=(row.package, row.file, *names),
        group=(place.file, row.package, row.file, *names),
    )
    return replace(diagnostic, severity=Severity.INFO) if PASSED_TO_ALL.issuperset(names) else diagnostic


__all__ = ["PASSED_TO_ALL", "unknown_elsewhere"]
