"""One program while it is followed, and what all of them add up to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from archlint import model
from archlint.finding import Place
from archlint.interpreter.modules import Module
from archlint.interpreter.roots import enter_root
from archlint.libraries.rclpy import escapes
from archlint.libraries.run import Run
from archlint.programs.budget import Budget, settle, steps_of
from archlint.programs.helpers import Holders, holders_in
from archlint.programs.roots import finish, run_callbacks
from archlint.programs.top_level import place_of
from archlint.syntax import facts


@dataclass(frozen=True)
class Definition:
    """A class or function at the top level of a module."""

    variable: str
    """What the module calls it."""
    name: str
    """What it is called where it is defined."""
    qualified: str
    place: Place
    is_class: bool
    is_own: bool
    """Whether it is defined in this module."""
    is_node: bool
    is_interesting: bool
    bases: tuple[Place, ...]
    """The classes of the workspace that it derives from."""
    names: frozenset[str]
    """The names that its code uses, where it may be run alone and is no node."""

    def parts(self) -> tuple[object, ...]:
        """All of it, as the constructor takes it."""
        return tuple(getattr(self, name) for name in self.__dataclass_fields__)


@dataclass(eq=False)
class Followed:
    """What became of one program."""

    program: model.Program
    steps: int
    """How many statements it has run."""
    ran: frozenset[Place]
    """The functions that ran."""
    instantiated: frozenset[Place]
    """Classes of which an object was made, and their bases."""
    holders: list[tuple[model.ClassKey, str, model.Blueprint]]
    """The nodes that objects of a class hold in an attribute in the end."""
    definitions: list[Definition] = field(default_factory=list)
    """What a module defines, where nothing but the module was run."""
    asked: model.Asked | None = None
    """What it has asked of its overrides; None for one that an earlier run has followed."""


@dataclass
class Progress:
    """What the programs that were followed so far add up to."""

    budget: Budget = field(default_factory=Budget)
    ran: set[Place] = field(default_factory=set)
    instantiated: set[Place] = field(default_factory=set)
    _followed: dict[int, Followed] = field(default_factory=dict)
    """By the id of each program, in their order."""

    @property
    def programs(self) -> list[model.Program]:
        return [followed.program for followed in self._followed.values()]

    @property
    def holders(self) -> Holders:
        holders: Holders = {}
        for followed in self._followed.values():
            for cls, attribute, node in followed.holders:
                holders.setdefault((cls, attribute), []).append(node)
        return holders

    def add(self, followed: Followed) -> None:
        """One more program."""
        self.budget.spend(followed.steps)
        self.ran |= followed.ran
        self.instantiated |= followed.instantiated
        self._followed.setdefault(id(followed.program), followed)

    def replace(self, copies: Mapping[int, Followed]) -> None:
        """Go on with copies of some programs, by the ids of these."""
        every = [copies.get(number, followed) for number, followed in self._followed.items()]
        self._followed = {id(followed.program): followed for followed in every}


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


__all__ = ["Definition", "Followed", "FollowedProgram", "Progress"]
