"""LCH011: launch arguments that are declared and never read."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from archlint.analysis.unread_arguments import unread_arguments
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.systems.model import System

_OF_HABIT = frozenset({"use_sim_time"})
"""Arguments that launch files declare as a matter of course."""


@rule("LCH011", scope=Scope.LAUNCH_FILE)
def unread_launch_argument(system: System, options: Options) -> Iterator[Finding]:
    """Arguments that nothing of a launch file reads: one finding for each file."""
    unread = [*unread_arguments(system)]
    if not unread:
        return
    first, *others = unread
    names = [argument.name for argument in unread]
    message = f"nothing reads the launch argument '{first.name}': setting it has no effect"
    if others:
        shown = " and ".join(f"'{name}'" for name in names)
        message = f"nothing reads the launch arguments {shown}: setting them has no effect"
    diagnostic = finding(
        "LCH011",
        first.place,
        message,
        help=f"read it where it is meant, {_reading(first.file, first.name)}, or remove the declaration",
        related=[Related(argument.place, f"'{argument.name}' is declared here") for argument in others],
        identity=(first.file, *names),
    )
    yield replace(diagnostic, severity=Severity.INFO) if _OF_HABIT.issuperset(names) else diagnostic


def _reading(file: str, name: str) -> str:
    return f"LaunchConfiguration('{name}')" if file.endswith(".py") else f"$(var {name})"


__all__ = ["unread_launch_argument"]
