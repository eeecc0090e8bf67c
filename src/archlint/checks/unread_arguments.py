"""LCH011: launch arguments that are declared and never read."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, package_around, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.shown_files import is_shown_only
from archlint.launch_files.unread_arguments import is_text_that_yaml_reads, kept_for_nothing, unread_arguments

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.model import DeclaredArgument
    from archlint.systems.model import System

_OF_HABIT = frozenset({"use_sim_time"})
"""Arguments that launch files declare as a matter of course."""


@rule("LCH011", scope=Scope.LAUNCH_FILE)
def unread_launch_argument(system: System, options: Options) -> Iterator[Finding]:
    """Arguments that nothing of a launch file reads: one finding for each file."""
    unread = [*unread_arguments(system)]
    if not unread or is_shown_only(system):
        return
    first, *others = unread
    names = [argument.name for argument in unread]
    blank = _with_blanks(names)
    workspace = system.workspace
    kept = {
        argument.name: variable
        for argument in unread
        if workspace is not None and (variable := kept_for_nothing(workspace, argument)) is not None
    }
    message = f"nothing reads the launch argument '{first.name}': setting it has no effect"
    if others:
        *most, last = [f"'{name}'" for name in names]
        shown = f"{', '.join(most)} and {last}"
        message = f"nothing reads the launch arguments {shown}: setting them has no effect"
    if blank:
        message += f"; blanks at the ends of '{blank[0]}' are a part of the name"
    diagnostic = finding(
        "LCH011",
        first.place,
        message,
        help=_help(system, first, kept.get(first.name)),
        related=[
            *(Related(argument.place, f"'{argument.name}' is declared here") for argument in others),
            *(Related(place, f"'{name}' is kept here, and nothing uses that") for name, (_, place) in kept.items()),
        ],
        identity=(first.file, *names),
        group=(*package_around(workspace, first.file), *names),
    )
    yield replace(diagnostic, severity=Severity.INFO) if _OF_HABIT.issuperset(names) else diagnostic


def _with_blanks(names: Sequence[str]) -> list[str]:
    """The names that begin or end with a blank: what reads the same name without it reads another argument."""
    return [name for name in names if name != name.strip()]


def _help(system: System, argument: DeclaredArgument, kept: tuple[str, Place] | None) -> str:
    if argument.name != argument.name.strip():
        return f"declare it as '{argument.name.strip()}', or remove the declaration"
    if kept is not None:
        return f"use {kept[0]} where it is meant, or remove it and the declaration"
    return f"read it where it is meant, {_reading(system, argument)}, or remove the declaration"


def _reading(system: System, argument: DeclaredArgument) -> str:
    if not argument.file.endswith(".py"):
        return f"$(var {argument.name})"
    read = f"LaunchConfiguration('{argument.name}')"
    return f"ParameterValue({read}, value_type=str)" if is_text_that_yaml_reads(system, argument) else read


@folds("LCH011", across_systems=True)
def _of_one_package(several: Sequence[Finding]) -> Finding:
    """One finding for the same arguments of several launch files of a package: one is copied from the other."""
    first, others = with_places(several, "so it is here"), len(several) - 1
    if not others:
        return first
    subject = (
        "another launch file of the package has" if others == 1 else f"{others} more launch files of the package have"
    )
    return replace(first, message=f"{first.message}; {subject} {'it' if len(first.identity) == 2 else 'them'}, too")


__all__ = ["unread_launch_argument"]
