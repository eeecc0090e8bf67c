"""Branches that nothing decides, and which arm of them something is in."""

from __future__ import annotations

from archlint.records import dataclass


@dataclass(frozen=True, slots=True)
class Branch:
    """What nothing decides.  Branches are the same where their class and their fields are."""


@dataclass(frozen=True, slots=True)
class CodeBranch(Branch):
    """A branch of code, by the place of what decides it; lines start at 1, columns as in the file's facts."""

    file: str
    line: int
    column: int
    part: int | None = None
    """Which operand of a test, or item of a loop; None for the whole statement."""


@dataclass(frozen=True, slots=True)
class ChoiceOfCallee(CodeBranch):
    """Which of several functions is called."""


@dataclass(frozen=True, slots=True)
class ChoiceOfArgument(CodeBranch):
    """Which of several values an argument has."""


@dataclass(frozen=True, slots=True)
class AttributeBranch(Branch):
    """What asks an attribute of ``self`` that only constructors set, wherever in a file."""

    file: str
    attribute: str


@dataclass(frozen=True, slots=True)
class ArgumentBranch(Branch):
    """What asks a launch argument for its truth or its value, or whether it is another than ``other_than``."""

    argument: str
    other_than: str | None = None


@dataclass(frozen=True, slots=True)
class UnfollowedCondition(Branch):
    """A condition of a launch file of which it is not known how the arguments decide it: it may never hold."""

    shape: str


@dataclass(frozen=True, slots=True)
class ChoiceOfValue(Branch):
    """Which of several values an object of a launch is, by its number; ``holding`` are those that have the same
    part, where these are several."""

    number: int
    holding: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class ChoiceOfVisit(Branch):
    """Which of several visits of one action starts a process, the first of those in a launch with that number."""

    number: int


BranchArm = tuple[Branch, int]
"""An undecided branch, and the number of one of its arms: two arms of one branch exclude each other."""
BranchArms = frozenset[BranchArm]


def exclusive(these: BranchArms, those: BranchArms) -> bool:
    """Whether two sets name different arms of one branch."""
    arms = dict(these)
    return any(branch in arms and arms[branch] != arm for branch, arm in those)


def runs_along(arms: BranchArms, other: BranchArms) -> bool:
    """Whether, of two nodes in these branches, one runs whenever the other does, and the other may.

    A condition that is not followed may never hold: a node under it is held only against one under the same.
    """
    few, more = sorted((arms, other), key=len)
    return few <= more and not any(isinstance(branch, UnfollowedCondition) for branch, _ in more - few)
