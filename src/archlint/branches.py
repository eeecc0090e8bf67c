"""Branches that nothing decides, and which arm of them something is in."""

from __future__ import annotations

BranchArm = tuple[str, int]
"""An undecided branch, and the number of one of its arms: two arms of one branch exclude each other."""
BranchArms = frozenset[BranchArm]


def exclusive(one: BranchArms, other: BranchArms) -> bool:
    """Whether two sets name different arms of one branch."""
    arms = dict(one)
    return any(branch in arms and arms[branch] != arm for branch, arm in other)
