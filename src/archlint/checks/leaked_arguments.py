"""LCH009: launch arguments that an include changes for what comes after it."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, package_around, with_other_places
from archlint.checks.launch_arguments import places_of_unknown_arguments
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.mistakes import LeakedArgument
    from archlint.launch.model import Launched
    from archlint.systems.model import System, WorkspaceIndex

_SHARED = frozenset({"use_sim_time", "log_level"})
"""Arguments that all launch files of a system are meant to have in common."""


@rule("LCH009", scope=Scope.LAUNCH_FILE)
def leaked_launch_argument(system: System, options: Options) -> Iterator[Finding]:
    """Launch configurations that an include leaves changed for another reader."""
    if system.launched is None or system.workspace is None or not system.launched.leaked:
        return
    told = places_of_unknown_arguments(system.workspace, system.launched)
    for leak in system.launched.leaked:
        shared = leak.name in _SHARED or (leak.name == "namespace" and leak.is_declared_in_vain)
        renamed = leak.is_declared_in_vain and _is_passed_by_another_name(system.launched, leak, told)
        if leak.given not in told and not shared and not renamed:
            yield _finding(system.workspace, leak)


def _is_passed_by_another_name(launched: Launched, leak: LeakedArgument, unknown: Collection[Place]) -> bool:
    """Whether the include that does not get its own default is given a value by a name that it does not take: LCH003
    says so, and with the right name nothing leaks into it."""
    words = set(leak.name.split("_"))
    return any(
        place in unknown and not words.isdisjoint(name.split("_"))
        for include in launched.included
        if include.reference.source == leak.file
        for name, place in include.arguments
    )


def _finding(workspace: WorkspaceIndex, leak: LeakedArgument) -> Finding:
    name, value, own = leak.name, _shown(leak.value), _shown(leak.own)
    other = posixpath.basename(leak.file)
    if leak.default:
        setter = posixpath.basename(leak.given.file)
        message = (
            f"'{name}' keeps {value}, the default of {setter}, behind this include: {other} does not get its own, {own}"
        )
        beside = f"{other} declares '{name}' in vain here"
        related = [Related(leak.given, "the first default is here"), Related(leak.read, beside)]
        place = leak.include
    elif leak.is_declared_in_vain:
        message = f"'{name}' keeps {value} behind this include: {other} does not get its own default, {own}"
        related = [Related(leak.read, f"{other} declares '{name}' in vain here")]
        place = leak.given
    else:
        message = f"'{name}' keeps {value} behind this include, instead of {own}: includes are not scoped"
        related = [Related(leak.read, f"'{name}' is read here")]
        place = leak.given
    if leak.earlier:  # the others would leak without this one
        place, *others = leak.earlier
        related += [Related(other, f"'{name}' is set here, too") for other in (*others, leak.given)]
        message = message.replace("behind this include", f"behind {len(leak.earlier) + 1} includes from this one on")
    group = "<group>" if not leak.include.file.endswith(".py") else "GroupAction([…])"
    them = "each of these includes" if leak.earlier else "the include"
    help = f"put {them} into a {group}, which gives the arguments back at its end"
    if leak.read_late:  # a group has ended by then
        help = f"rename the argument '{name}' in one of the two files: what is included reads it in a timer or an event"
    if leak.the_same or (leak.read_late and leak.is_declared_in_vain):
        help = f"pass '{name}' to {other}, too: {value}, or its own default, {own}, if that is meant"
    told = finding(
        "LCH009",
        place,
        message,
        help=help,
        related=related,
        identity=(name, leak.file),
        group=(*package_around(workspace, leak.include.file), name, "default" if leak.default else "given"),
    )
    # What all includes set is the value that the launch file wants: it is there by chance, and not a wrong one.
    return replace(told, severity=Severity.INFO) if leak.the_same else told


def _shown(text: str) -> str:
    return f"'{text}'"


@folds("LCH009", across_systems=True)
def _of_one_argument(findings: Sequence[Finding]) -> Finding:
    """One finding for an argument, whichever includes of the launch files of a package set it and wherever it is read:
    one of these files is a copy of the other."""
    return with_other_places(findings, "it is set here, too")


__all__ = ["leaked_launch_argument"]
