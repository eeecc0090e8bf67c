"""Undecided branches that ask the same: an attribute of ``self`` that only the constructor sets is one condition,
wherever it is asked."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.branches import AttributeBranch, CodeBranch
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from archlint.branches import BranchArm, BranchArms
    from archlint.systems.model import WorkspaceIndex


def conditions(workspace: WorkspaceIndex | None, arms: Iterable[BranchArm]) -> BranchArms:
    """Arms of branches, those that ask the same under one name."""
    return frozenset(_condition(workspace, arm) for arm in arms)


def _condition(workspace: WorkspaceIndex | None, arm: BranchArm) -> BranchArm:
    branch, number = arm
    if workspace is None or type(branch) is not CodeBranch or branch.part is not None:
        return arm
    asked = _asked(workspace, branch.file)
    test = None if asked is None else asked.get((branch.line, branch.column))
    if test is None:
        return arm
    attribute, turned = test
    return AttributeBranch(branch.file, attribute), 1 - number if turned else number


@once_for_each_file
def _asked(file_facts: facts.Facts) -> dict[tuple[int, int], tuple[str, bool]]:
    """Where an ``if`` asks nothing but an attribute of ``self`` that is set once, or in constructors alone, and whether
    it asks ``not``."""
    constructors = [
        function for function in everything_in(file_facts.body, facts.Function) if function.name == "__init__"
    ]
    once, later = _assigned(file_facts.body), _assigned(file_facts.body)
    for function in constructors:
        later.subtract(_assigned(function.body))
    rows = ((branch, _attribute(branch.test)) for branch in everything_in(file_facts.body, facts.If))
    return {
        (branch.span[0], branch.span[1]): attribute
        for branch, attribute in rows
        if attribute is not None and (later[attribute[0]] <= 0 or once[attribute[0]] == 1)
    }


def _assigned(body: Sequence[facts.Stmt]) -> Counter[str]:
    """How often each attribute is assigned in a body."""
    targets = (target for assignment in everything_in(body, facts.Assign) for target in assignment.targets)
    return Counter(target.attribute for target in targets if target.attribute)


def _attribute(test: facts.Expr) -> tuple[str, bool] | None:
    match test:
        case facts.Unary(op="not"):
            inner = _attribute(test.operand)
            return None if inner is None else (inner[0], not inner[1])
        case facts.Attribute(value=facts.Name(id="self"), attr=name):
            return name, False
    return None
