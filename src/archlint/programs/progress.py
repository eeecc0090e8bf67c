"""What the programs that were followed so far add up to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from archlint import model
from archlint.finding import Place
from archlint.programs.budget import Budget
from archlint.programs.followed import Followed
from archlint.programs.helpers import Holders
from archlint.records import dataclass


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


__all__ = ["Progress"]
