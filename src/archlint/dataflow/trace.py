"""What is known of a name in one system, as a trace."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.dataflow.latency import Term
from archlint.dataflow.misfits import Misfit
from archlint.dataflow.model import Link, Step
from archlint.dataflow.paths import Branch
from archlint.dataflow.subjects import Subject
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


@dataclass(frozen=True)
class Way:
    """Links from a source to an end, with the times along them."""

    links: tuple[Link, ...]
    terms: tuple[Term, ...]


@dataclass(frozen=True, eq=False)
class Trace:
    """What is known of a name in one system.  ``back`` are what leads to it, ``on`` what it leads to."""

    flow: Flow
    subject: Subject
    back: tuple[Branch, ...]
    on: tuple[Branch, ...]
    ways: tuple[Way, ...]
    misfits: tuple[Misfit, ...]
    more_ways: int = 0
    """How many ways were left out."""
    beside: tuple[Endpoint, ...] = ()
    """The ends that the same name has in nodes that no launch file starts."""

    @property
    def system(self) -> System:
        return self.flow.system

    @property
    def steps(self) -> list[Step]:
        """All steps of the trace, in the order of the graph."""
        shown = {id(step) for step in steps_of((*self.back, *self.on))}
        return [step for step in self.flow.steps if id(step) in shown]

    @property
    def links(self) -> list[Link]:
        """The links between its steps, in the order of the graph."""
        shown = {id(step) for step in self.steps}
        return [link for link in self.flow.links if id(link.tail) in shown and id(link.head) in shown]


def steps_of(branches: Sequence[Branch]) -> Iterator[Step]:
    stack = list(branches)
    while stack:
        branch = stack.pop()
        yield branch.step
        stack += branch.branches


__all__ = ["Trace", "Way", "steps_of"]
