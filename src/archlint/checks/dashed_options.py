"""PKG010: options of a setup.cfg that setuptools no longer wants."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_from_before_humble
from archlint.checks.folding import folds, with_others, with_places
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.packaging.dashed_options import dashed_options

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("PKG010", scope=Scope.WORKSPACE, taste=True)
def dashed_option(system: System, options: Options) -> Iterator[Finding]:
    """``script-dir`` and ``install-scripts``, as old templates write them."""
    workspace = workspace_of(system)
    dashed = [] if workspace is None else [*dashed_options(workspace)]
    if workspace is None or not dashed:
        return
    if is_from_before_humble(workspace):  # the setuptools of its Ubuntu says nothing
        return
    for option in dashed:
        right = option.name.replace("-", "_")
        yield finding(
            "PKG010",
            option.place,
            f"'{option.name}' has a dash: setuptools warns of it at each build, and says that it will refuse it",
            help=f"write '{right}'",
            identity=(option.name,),
            group=("dashed",),
            meant=right,
        )


@folds("PKG010", across_workspaces=True)
def _of_one_workspace(findings: Sequence[Finding]) -> Finding:
    """One finding for all files: they come of one template."""
    files = {diagnostic.place.file for diagnostic in findings}
    if len(findings) == 1:
        return findings[0]
    if len(files) == 1:
        return with_others(findings, "another option of the file has", "more options of the file have", "one, too")
    first, others = with_places(findings, "so has this one"), len(files) - 1
    subject = "another setup.cfg has" if others == 1 else f"{others} more setup.cfg files have"
    return replace(first, message=f"{first.message}; {subject} such options, too")


__all__ = ["dashed_option"]
