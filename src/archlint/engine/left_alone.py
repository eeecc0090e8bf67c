"""Findings about files that are put aside: nobody mends what nothing runs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused, is_left_alone
from archlint.checks.registry import registered
from archlint.checks.scope import Scope
from archlint.packaging.unbuilt_files import runs_nowhere

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex


def without_left_alone(index: WorkspaceIndex, findings: Iterable[Finding], paths: Sequence[str]) -> list[Finding]:
    """The findings, without those in files that are put aside and that no code names (``driver copy.py``).  What
    packages say of themselves is left: colcon builds a package wherever it lies.  Nor is it told that a file cannot be
    read which is neither built nor installed.  A file that the run was asked about by its name has all findings."""
    named = {os.path.abspath(path) for path in paths}
    alone: dict[str, bool] = {}
    kept: list[Finding] = []
    for finding in findings:
        file = finding.place.file
        if finding.code == "LNT002" and os.path.abspath(file) not in named and runs_nowhere(index, file):
            continue
        if file not in alone:
            put_aside = is_left_alone(index, file) and is_disused(index, file)
            alone[file] = put_aside and os.path.abspath(file) not in named and _is_code(index, file)
        if not (alone[file] and _is_of_what_runs(finding)):
            kept.append(finding)
    return kept


def _is_code(index: WorkspaceIndex, file: str) -> bool:
    """Whether a file is code, a launch file or an interface: others are judged where something in use reads them."""
    return not file.endswith((".yaml", ".yml")) or file in index.launch_files.all()


def _is_of_what_runs(finding: Finding) -> bool:
    check = registered().get(finding.code)
    return finding.code == "LNT002" or (check is not None and check.scope is not Scope.WORKSPACE)


__all__ = ["without_left_alone"]
