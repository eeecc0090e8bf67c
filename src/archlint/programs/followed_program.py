"""One program while it is followed."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.finding import Place
from archlint.interpreter.modules import Module
from archlint.interpreter.roots import enter_root
from archlint.libraries.rclpy import escapes
from archlint.libraries.run import Run
from archlint.programs.budget import settle, steps_of
from archlint.programs.followed import Definition, Followed
from archlint.programs.helpers import holders_in
from archlint.programs.roots import finish, run_callbacks
from archlint.programs.top_level import place_of
from archlint.syntax import facts


class FollowedProgram:
    """One program on a layer of its own: its callbacks run when the block ends, then the layer goes.

    What is raised inside is noted at ``place``, and what the program has done until then stays."""

    def __init__(self, run: Run, module: Module, place: Place | None = None) -> None:
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
            self._holders = holders_in(run, run.store.cut(self.depth))
            run.store.forget_program_references()
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
        run = self.run
        settle(run)
        try:
            finish(run)
        except Exception as raised:
            run.note_fault(self._what, raised, self.place)

    def result(self, definitions: Sequence[Definition] = ()) -> Followed:
        """What became of the program, once the block has ended."""
        run = self.run
        classes = [instance.own_class for instance in run.instances.values()]
        bases = {id(base): base for cls in classes if cls is not None for base in cls.mro}
        instantiated = frozenset(place for base in bases.values() if (place := place_of(base)) is not None)
        return Followed(
            run.program, steps_of(run), _ran(run), instantiated, self._holders, list(definitions), run.overrides
        )


def _ran(run: Run) -> frozenset[Place]:
    """The functions that ran."""
    return frozenset(
        Place(path, *(fact.span if isinstance(fact, facts.Lambda) else fact.name_span))
        for fact, path in run.ran.values()
    )


__all__ = ["FollowedProgram"]
