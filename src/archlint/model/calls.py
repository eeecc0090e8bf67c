"""The calls that checks care about: what waits, spins, sleeps or reads a parameter."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.branches import BranchArm
    from archlint.finding import Place
    from archlint.model.given import Given
    from archlint.model.nodes import Blueprint, Callback, Creation, Frame
    from archlint.model.transforms import FramePair


@dataclass(eq=False)
class ApiCall:
    """A call of an API that checks care about: blocking calls, spins, sleeps, parameter reads …

    ``api`` is the canonical dotted name; ``arguments`` maps the API's own parameter names to what they are
    given.  ``chain`` leads from ``context`` (what is running) to the call.
    """

    api: str
    place: Place
    context: Callback
    chain: tuple[Frame, ...]
    arguments: dict[str, Given]
    argument_places: dict[str, Place]
    receiver: Given | None = None
    """What the method is called on."""
    creation: Creation | None = None
    """The endpoint the call is made on or waits for, where it is known."""
    node: Blueprint | None = None
    function: str = ""
    file: str = ""
    loops: tuple[Place, ...] = ()
    """The loops of the same function around it, outermost first: not those that it always leaves."""
    conditional: bool = False
    awaited: bool = False
    in_try: bool = False
    """Whether a ``try`` is around it, here or in a caller."""
    enclosing_loops: tuple[Place, ...] = ()
    """The loops around it, also those of its callers, outermost first."""
    branch_arms: tuple[BranchArm, ...] = ()
    """The arms of undecided branches that lead to it, outermost first."""
    limits: tuple[float | None, ...] = ()
    """For each of ``loops`` the seconds after which it ends, where it watches the clock for a known time."""
    cleaning: bool = False
    """Whether it is reached only where something has failed: no loop tries again, or the callback ends with it."""
    call_chains: list[tuple[tuple[Frame, ...], tuple[Place, ...], tuple[Creation, ...]]] = field(default_factory=list)
    """Other chains (the loops on them, the endpoints it is for) from the same context, through the same arms."""
    frames: list[FramePair] = field(default_factory=list)
    """The coordinate frames that it is about, if it sends or looks up transforms."""

    @property
    def looped(self) -> bool:
        """Whether it is in a loop, also one of a caller."""
        return bool(self.enclosing_loops)
