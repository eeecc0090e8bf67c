"""Executors: what spins which nodes, and for how long."""

from __future__ import annotations

from dataclasses import field
from enum import IntEnum
from typing import TYPE_CHECKING

from archlint.model.kinds import ExecutorKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model.nodes import Blueprint


class SpinDuration(IntEnum):
    """How long a spin goes on, the shortest first."""

    A_MOMENT = 0
    """It gives one thing a chance: a single call, until a future is done, in the constructor of the node."""
    A_WHILE = 1
    """A loop of spins that ends by itself."""
    TO_THE_END = 2
    """Until the program ends."""


@dataclass(frozen=True)
class Spell:
    """A spin that was given a node itself: its executor serves the node for that time only."""

    place: Place
    lasting: SpinDuration
    in_constructor: bool
    """True where the node's own constructor spins."""
    for_answer: bool
    """True where it lasts until the answer of a client is there."""
    creations: int
    """How many entities the node had by then."""
    taken_from: Place | None = None
    """The executor that the node had been added to by then, unless it was added again: this spin takes it away."""


@dataclass(eq=False)
class ExecutorUse:
    """An executor of a program: what spins which nodes, with how many threads."""

    kind: ExecutorKind
    threads: int | None
    nodes: list[Blueprint]
    place: Place | None
    in_thread: bool = False
    spun: bool = False
    lasting: SpinDuration = SpinDuration.A_MOMENT
    """How long the most lasting of its spins goes on, as for :class:`Spell`."""
    spun_at: Place | None = None
    """The first call of those that spin it longest."""
    spells: dict[Blueprint, list[Spell]] = field(default_factory=dict)
    """The nodes that are only there while a spin that is given them lasts, with these spins."""
    astray: bool = False
    """True where it was given a node that is not known, or code that is not followed has the executor."""

    def lasts_for(self, node: Blueprint) -> SpinDuration:
        """How long it spins one of its nodes."""
        spells = self.spells.get(node)
        return self.lasting if spells is None else max(spell.lasting for spell in spells)

    def spins_at(self, node: Blueprint) -> Place | None:
        """The call that spins one of its nodes longest."""
        lasting = self.lasts_for(node)
        return next((spell.place for spell in self.spells.get(node, ()) if spell.lasting == lasting), self.spun_at)
