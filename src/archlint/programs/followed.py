"""One program while it is followed, and what all of them add up to."""

from __future__ import annotations

from dataclasses import dataclass, field

from archlint import model
from archlint.finding import Place
from archlint.interpreter.modules import Module
from archlint.interpreter.roots import enter_root
from archlint.libraries.rclpy import escapes
from archlint.libraries.run import Run
from archlint.programs.budget import Budget
from archlint.programs.helpers import Holders, note_holders
from archlint.programs.roots import finish, run_callbacks


@dataclass
class Progress:
    """What the programs that were followed so far add up to."""

    programs: list[model.Program] = field(default_factory=list)
    budget: Budget = field(default_factory=Budget)
    ran: set[int] = field(default_factory=set)
    """The functions that ran, by the id of their facts."""
    made: set[int] = field(default_factory=set)
    """Classes of which an object was made, and their bases, by id."""
    holders: Holders = field(default_factory=dict)
    """The nodes that objects of a class were seen to hold in an attribute."""


class FollowedProgram:
    """One program on a layer of its own: its callbacks run when the block ends, then the layer goes.

    What is raised inside is noted at ``place``, and what the program has done until then stays."""

    def __init__(self, progress: Progress, run: Run, module: Module, place: Place | None = None) -> None:
        self.progress = progress
        self.run = run
        self.module = module
        self.place = place or run.context.place

    def __enter__(self) -> FollowedProgram:
        self.depth = self.run.store.depth
        self.run.store.push()
        enter_root(self.run, self.module)
        return self

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> bool:
        run = self.run
        try:
            if isinstance(error, Exception):
                self._recover(error)
            if error is None or isinstance(error, Exception):
                run_callbacks(run)
                escapes.settle(run)
        except Exception as raised:
            run.note_fault(self._what, raised, self.place)
        finally:
            run.activations.clear()
            note_holders(self.progress.holders, run, run.store.cut(self.depth))
        self._finish()
        return isinstance(error, Exception)

    @property
    def _what(self) -> str:
        return f"following {self.run.context.name}"

    def _recover(self, error: Exception) -> None:
        """Where the program failed: its callbacks are run all the same."""
        run = self.run
        run.note_fault(self._what, error, self.place)
        run.activations.clear()
        run.branch_arms.clear()
        run.store.merge([run.store.cut(self.depth + 1)])
        enter_root(run, self.module)

    def _finish(self) -> None:
        progress, run = self.progress, self.run
        progress.budget.settle(run)
        progress.ran |= run.ran
        for instance in run.instances.values():
            if instance.own_class is not None:
                progress.made.update(id(base) for base in instance.own_class.mro)
        try:
            finish(run)
        except Exception as raised:
            run.note_fault(self._what, raised, self.place)
        if run.program not in progress.programs:
            progress.programs.append(run.program)


__all__ = ["FollowedProgram", "Progress"]
