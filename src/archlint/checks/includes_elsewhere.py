"""LCH003: arguments that a well-known launch file from elsewhere does not take."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.well_known_includes import unknown_to_includes
from archlint.suggestions import meant, nearest

if TYPE_CHECKING:
    from archlint.launch.model import Included, Launched
    from archlint.launch_files.well_known_includes import UnknownToInclude
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex

PASSED_TO_ALL = frozenset({"use_sim_time"})
"""Arguments that launch files hand to every include as a matter of course, to those of drivers as well."""


def unknown_elsewhere(workspace: WorkspaceIndex, launched: Launched) -> Iterator[Finding]:
    """One finding for an include."""
    switches = frozenset(
        argument.name
        for argument in launched.declared
        if argument.default is not None and (argument.default.text or "").lower() in ("true", "false")
    )
    yield from (_unknown(row, switches) for row in unknown_to_includes(workspace, launched))


def _unknown(row: UnknownToInclude, switches: Collection[str]) -> Finding:
    """What a well-known launch file from elsewhere does not take, in any distribution since humble."""
    (first, place), *others = row.given
    names = [name for name, _ in row.given]
    near = _meant(first, row.taken, switches)
    said = f"takes no launch argument '{first}' since Humble" + meant(f"'{near}'" if near else "")
    if others:
        said = "takes none of these launch arguments since Humble: " + ", ".join(f"'{name}'" for name in names)
    see = f"ros2 launch {row.package} {row.file} --show-args lists those that it takes"
    diagnostic = finding(
        "LCH003",
        place,
        f"{row.file} of {row.package} {said}",
        help=f"write '{near}': the value has no effect"
        if near and not others
        else f"the value has no effect: correct the name or remove it; {see}",
        related=[Related(at, _set_here(name, _meant(name, row.taken, switches))) for name, at in others],
        identity=(row.package, row.file, *names),
        group=(place.file, row.package, row.file, *names),
    )
    return replace(diagnostic, severity=Severity.INFO) if PASSED_TO_ALL.issuperset(names) else diagnostic


def _set_here(name: str, near: str) -> str:
    return f"'{name}' is set here" + meant(f"'{near}'" if near else "")


def _meant(name: str, taken: Collection[str], switches: Collection[str]) -> str:
    """The argument nearest to a name, or the only one that is the name with words before or behind it:
    ``slam_params_file`` for ``params_file``.  What the launch file itself has for a switch, such as ``rviz``, is not
    meant for ``rviz_config``."""
    if name in switches:
        return nearest(name, taken) or ""
    longer = [other for other in taken if other.endswith(f"_{name}") or other.startswith(f"{name}_")]
    return nearest(name, taken) or (longer[0] if len(longer) == 1 else "")


def is_shared(
    workspace: WorkspaceIndex, launched: Launched, includes: Sequence[Included], name: str, place: Place
) -> bool:
    """Whether an argument stands in a dict that another include is given, too, which takes it or may do so."""
    for include in launched.included:
        if include in includes or (name, place) not in include.arguments:
            continue
        source = include.reference.source
        target = None if source is None else workspace.launched_alone[source]
        if target is None or name in target.read or any(argument.name == name for argument in target.declared):
            return True
    return False


__all__ = ["PASSED_TO_ALL", "is_shared", "unknown_elsewhere"]
