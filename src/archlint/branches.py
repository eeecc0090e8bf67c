"""Branches that nothing decides, and which arm of them something is in."""

from __future__ import annotations


class UnfollowedCondition(str):
    """A condition of a launch file of which it is not known how the arguments decide it: it may never hold."""

    __slots__ = ()


class ChoiceOfCallee(str):
    """Which of several functions is called."""

    __slots__ = ()


class ChoiceOfArgument(str):
    """Which of several values an argument has."""

    __slots__ = ()


BranchArm = tuple[str, int]
"""An undecided branch, and the number of one of its arms: two arms of one branch exclude each other."""
BranchArms = frozenset[BranchArm]


def exclusive(one: BranchArms, other: BranchArms) -> bool:
    """Whether two sets name different arms of one branch."""
    arms = dict(one)
    return any(branch in arms and arms[branch] != arm for branch, arm in other)
