"""The fixes of a run's findings, made where they are asked for."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.registry import failure
from archlint.engine.inputs import parts_of, python_files
from archlint.faults import Faults
from archlint.fixes import Surroundings, attach

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.finding import Finding
    from archlint.report.model import Judged
    from archlint.workspace.model import Workspace


def mended(judged: Judged, inputs: Inputs) -> Judged:
    """The findings with their fixes; one more for each fix that cannot be made by a fault of ours."""
    workspace = inputs.workspace
    faults = Faults()
    findings: list[Finding] = []
    left = list(judged.findings)
    for part in parts_of(inputs.request, workspace):
        files = {file.relative for file in part.files}
        mine = [finding for finding in left if finding.place.file in files]
        left = [finding for finding in left if finding.place.file not in files]
        findings += attach(mine, _around(part, inputs), faults)
    # A launch file that git ignores is read where another one includes it.
    findings += attach(left, _around(workspace, inputs), faults)
    failures = [failure(fault) for fault in faults.by_place()]
    ordered = sorted((*findings, *failures), key=lambda finding: finding.sort_key)
    summary = replace(judged.summary, errors=judged.summary.errors + len(failures))
    return replace(judged, findings=ordered, summary=summary, mended=True)


def _around(workspace: Workspace, inputs: Inputs) -> Surroundings:
    tree, inside = inputs.tree, inputs.workspace.inside
    return Surroundings([file.path for file in python_files(workspace)], tree.given, tree.base, inside)
