"""Whether an action runs."""

from __future__ import annotations

from archlint.branches import BranchArm
from archlint.records import dataclass


@dataclass(frozen=True)
class Verdict:
    """``holds`` is None where the arguments do not decide; ``branch`` is then the arm that this action is in."""

    holds: bool | None
    branch: BranchArm | None = None


ALWAYS = Verdict(True)
