"""LCH013: what a bridge between ROS and Gazebo is given and does not understand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_galactic
from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.launch_files.refused_bridge_files import refused_entries
from archlint.launch_files.refused_bridges import refused_bridges

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH013", scope=Scope.LAUNCH_FILE)
def refused_bridge(system: System, options: Options) -> Iterator[Finding]:
    """Arguments of ``parameter_bridge``, and entries of its file, that bridge nothing, or with which it ends."""
    if is_from_before_galactic(system.workspace):
        return
    for row in (*refused_bridges(system), *refused_entries(system)):
        effect = "the bridge prints how it is used, and ends" if row.ends else "nothing is bridged there"
        yield finding(
            "LCH013",
            row.place,
            f"'{row.argument}' is no bridge, for {row.wrong}: {effect}",
            help=row.help or (f"write '{row.instead}'" if row.instead else "write topic@type/of/ROS[type.of.Gazebo"),
            identity=(row.argument,),
            group=(row.place.file, row.argument),
        )


@folds("LCH013", across_systems=True)
def _of_one_argument(several: Sequence[Finding]) -> Finding:
    """One finding for an argument, whichever launch files include the one that has it."""
    return with_places(several, "it is given here, too")


__all__ = ["refused_bridge"]
