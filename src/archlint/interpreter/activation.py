"""One running function, with its variables and what it has returned so far; and what calls of one have come to."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.branches import BranchArm
from archlint.finding import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from collections.abc import Mapping

    from archlint.interpreter.heap import Layer, Slot
    from archlint.interpreter.modules import Module, Scope
    from archlint.interpreter.values import FunctionValue, Value
    from archlint.syntax import facts


@dataclass(eq=False)
class Activation:
    """One running function (or module, or class body)."""

    qualified: str
    module: Module
    scope: Scope
    body: list[facts.Stmt]
    depth: int
    """Depth of the store when it began."""
    function: FunctionValue | None = None
    self_value: Value | None = None
    call_place: Place | None = None
    statement: facts.Stmt | None = None
    loops: list[facts.While | facts.For] = field(default_factory=list)
    left: set[int] = field(default_factory=set)
    """Loops (by identity) that an undecided ``break`` may have left."""
    ended_arms: frozenset[BranchArm] = frozenset()
    """Arms of undecided branches that have left the function: what runs now does so only where none was taken."""
    tries: int = 0
    """How many ``try`` blocks of the function are around what runs now."""
    forgiving: int = 0
    """How many of them may be there for an attribute that is missing."""
    expecting_refusals: int = 0
    """How many of them are there for a call that Python rejects."""
    catching: list[tuple[facts.Try, int]] = field(default_factory=list)
    """The ``try`` blocks around what runs now, innermost last, each with the number of undecided branches around it."""
    returns: list[tuple[Value, Layer | None]] = field(default_factory=list)
    yields: list[Value] = field(default_factory=list)
    scopes: list[int] = field(default_factory=list)
    """Scopes that end with it: its own, and those of its comprehensions."""
    branch_arms: int = 0
    """How many undecided branches it was called in."""
    settled: int = -1
    """How many undecided branches there were when the statement that runs began: no more are left to chance in it."""
    open_test: str | None = None
    """Why the first test that is not decided is not."""
    closed_over: bool = False
    """Whether a function defined inside may outlive it."""

    def forget(self, layers: list[Layer]) -> None:
        """Drop the variables of a function that has ended, unless an inner function still needs them."""
        if self.closed_over:
            return
        for layer in layers:
            for at in [at for at in layer if at[0] in self.scopes]:
                del layer[at]

    def place(self, span: facts.Span) -> Place:
        return self.module.place(span)


@dataclass(slots=True)
class Repeated:
    """What is known of the calls of one function with the same arguments."""

    count: int = 0
    value: Value | None = None
    """What the last call gave; None while it runs."""
    around: Mapping[Slot, object] | None = None
    """What it read of the state, and what it left there; None where that was not watched."""


__all__ = ["Activation", "Repeated"]
