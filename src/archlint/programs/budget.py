"""What all programs of a workspace may run together, so that one with very many of them ends, too."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint import model
    from archlint.libraries.run import Run

WORKSPACE_STEPS = 500_000
"""How many statements the programs run before the rest of them gets few.  Counted in statements, never in seconds:
what is found does not depend on the machine."""
LATE_STEPS = 1_000
"""How many statements each of the rest may run, and all of its callbacks once these are spent."""


class Budget:
    """What is left of :data:`WORKSPACE_STEPS`.  Programs run in a fixed order, so that it is always the same ones that
    come late."""

    def __init__(self) -> None:
        self.left = WORKSPACE_STEPS

    @property
    def is_spent(self) -> bool:
        return self.left <= 0

    def grant(self, run: Run, steps: int) -> None:
        """Let a program run so many statements; few where the workspace has spent its own."""
        run.late = self.is_spent
        run.granted = run.left = run.allowed_steps = min(steps, LATE_STEPS) if run.late else steps

    def spend(self, steps: int) -> None:
        """Note what a program has run."""
        self.left -= steps


def steps_of(run: Run) -> int:
    """How many statements a program has run."""
    return run.granted - run.left + run.steps


def settle(run: Run) -> None:
    """Note whether a program was cut short for the sake of the others."""
    run.program.late = run.late and run.program.exhausted


def cut_short(programs: list[model.Program]) -> list[str]:
    """The files of the programs that came late and were cut short."""
    return sorted({program.file for program in programs if program.late})
