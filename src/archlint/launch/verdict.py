"""Whether an action runs."""

from __future__ import annotations

from dataclasses import dataclass

from archlint.branches import BranchArm


@dataclass(frozen=True)
class Verdict:
    """``holds`` is None where the arguments do not decide; ``branch`` is then the arm that this action is in."""

    holds: bool | None
    branch: BranchArm | None = None


ALWAYS = Verdict(True)
