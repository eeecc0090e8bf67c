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


def runs_along(arms: BranchArms, other: BranchArms) -> bool:
    """Whether, of two nodes in these branches, one runs whenever the other does, and the other may.

    A condition that is not followed may never hold: a node under it is held only against one under the same.
    """
    few, more = sorted((arms, other), key=len)
    return few <= more and not any(isinstance(branch, UnfollowedCondition) for branch, _ in more - few)
