"""What became of one program that was followed, and what its modules define."""

from __future__ import annotations

from dataclasses import field

from archlint import model
from archlint.finding import Place
from archlint.records import dataclass


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


__all__ = ["Definition", "Followed"]
