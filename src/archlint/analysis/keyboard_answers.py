"""Branches that an answer of somebody at a keyboard decides: ``if input('Calibrate? ') == 'y':``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.branches import CodeBranch
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, names_in, targets_in
from archlint.syntax.tree import span_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from archlint.branches import BranchArm
    from archlint.systems.model import WorkspaceIndex


def is_answered(workspace: WorkspaceIndex, arms: Iterable[BranchArm]) -> bool:
    """Whether such an answer decides one of some branches."""
    branches = (branch for branch, _ in arms if isinstance(branch, CodeBranch))
    return any((branch.line, branch.column) in (_asking(workspace, branch.file) or ()) for branch in branches)


@kept_for_each_file
def _asking(code: facts.Facts) -> frozenset[tuple[int, int]]:
    """Where the ``if`` statements of a file, and their conditions, begin that ask for an answer, or for what the file
    keeps one in."""
    kept = {
        target.last_name
        for assignment in everything_in(code.body, facts.Assign)
        if _reads(assignment.value)
        for whole in assignment.targets
        for target in targets_in(whole)
    }
    checks = [
        check for check in everything_in(code.body, facts.If) if _reads(check.test) or kept & names_in(check.test)
    ]
    spans = [span for check in checks for span in (check.span, span_of(check.test))]
    return frozenset((span[0], span[1]) for span in spans)


def _reads(value: facts.Expr) -> bool:
    return any(call.func.variable == "input" for call in everything_in([value], facts.Call))


__all__ = ["is_answered"]
