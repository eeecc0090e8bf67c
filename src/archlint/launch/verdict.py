"""Whether an action runs."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Verdict:
    """``holds`` is None where the arguments do not decide; ``branch`` is then the arm that this action is in."""

    holds: bool | None
    branch: tuple[str, int] | None = None


ALWAYS = Verdict(True)
