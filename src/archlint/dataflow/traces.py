"""A trace: where what arrives at a name comes from, what depends on it, how long that takes and what does not fit."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.dataflow.graph import flow_of
from archlint.dataflow.latency import Term, terms
from archlint.dataflow.misfits import Misfit, misfits
from archlint.dataflow.model import Link, Step, StepKind
from archlint.dataflow.paths import Branch, reached, shortest, tree
from archlint.dataflow.subjects import Subject, subjects

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

MOST_WAYS = 12
"""Sources, and ends, to which the shortest way and its times are worked out for one trace."""


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
        shown = {id(step) for step in _steps((*self.back, *self.on))}
        return [step for step in self.flow.steps if id(step) in shown]

    @property
    def links(self) -> list[Link]:
        """The links between its steps, in the order of the graph."""
        shown = {id(step) for step in self.steps}
        return [link for link in self.flow.links if id(link.tail) in shown and id(link.head) in shown]


def _steps(branches: Sequence[Branch]) -> Iterator[Step]:
    stack = list(branches)
    while stack:
        branch = stack.pop()
        yield branch.step
        stack += branch.branches


def traces(system: System, name: str, origin: str | None = None, end: str | None = None) -> list[Trace]:
    """The traces of all that a name means in a system; ``origin`` and ``end`` limit them to the ways from one name
    and to another."""
    flow = flow_of(system)
    return [
        trace
        for subject in subjects(flow, name)
        if (trace := _trace(flow, subject, _named(flow, origin), _named(flow, end))) is not None
    ]


def _named(flow: Flow, name: str | None) -> list[Subject] | None:
    return None if name is None else subjects(flow, name)


def _trace(flow: Flow, subject: Subject, origin: list[Subject] | None, end: list[Subject] | None) -> Trace | None:
    """None where no way leads from the origin, or to the end."""
    first = None if origin is None else [step for each in origin for step in each.leaving]
    last = None if end is None else [step for each in end for step in each.arriving]
    is_limited = first is not None or last is not None
    back = on = None
    if first is not None:
        back = reached(flow, first, "on", True) & reached(flow, subject.arriving, "back", True)
        if not back & set(map(id, subject.arriving)) or not back & set(map(id, first)):
            return None
    if last is not None:
        on = reached(flow, last, "back", True) & reached(flow, subject.leaving, "on", True)
        if not on & set(map(id, last)):
            return None
    behind = tree(flow, subject.arriving, "back", back) if first is not None or not is_limited else []
    ahead = tree(flow, subject.leaving, "on", on) if last is not None or not is_limited else []
    ways = list(_ways(flow, subject, behind, ahead, first, last))
    steps = {id(step) for step in _steps((*behind, *ahead))}
    shown = tuple(Way(tuple(way), tuple(terms(flow, way))) for way in ways if way is not None)
    return Trace(flow, subject, tuple(behind), tuple(ahead), shown, tuple(misfits(flow, steps)), ways.count(None))


def _ways(
    flow: Flow,
    subject: Subject,
    behind: Sequence[Branch],
    ahead: Sequence[Branch],
    first: Sequence[Step] | None,
    last: Sequence[Step] | None,
) -> Iterator[list[Link] | None]:
    """The shortest way from each source to the name, and from it to each end; None for one that is not looked for."""
    if first is not None and last is not None:
        middle = set(map(id, subject.arriving))
        to = shortest(flow, first, middle)
        if to is not None:
            after = shortest(flow, [to[-1].head] if to else list(subject.leaving), set(map(id, last)))
            if after is not None and to + after:
                yield to + after
        return
    if first is not None or last is None:
        yield from _from_each(flow, subject, first if first is not None else _ends_of(behind))
    if last is not None or first is None:
        yield from _to_each(flow, subject, last if last is not None else _ends_of(ahead))


def _from_each(flow: Flow, subject: Subject, sources: Sequence[Step]) -> Iterator[list[Link] | None]:
    arriving = set(map(id, subject.arriving))
    for number, source in enumerate(_worth(sources, arriving)):
        way = shortest(flow, [source], arriving) if number < MOST_WAYS else None
        if way != []:
            yield way


def _to_each(flow: Flow, subject: Subject, ends: Sequence[Step]) -> Iterator[list[Link] | None]:
    leaving = set(map(id, subject.leaving))
    for number, end in enumerate(_worth(ends, leaving)):
        way = shortest(flow, subject.leaving, {id(end)}) if number < MOST_WAYS else None
        if way != []:
            yield way


def _worth(steps: Sequence[Step], own: Collection[int]) -> list[Step]:
    return [step for step in steps if step.kind != StepKind.STRANGER and id(step) not in own]


def _is_broken(branch: Branch) -> bool:
    return branch.link is not None and bool(branch.link.broken)


def _ends_of(branches: Sequence[Branch]) -> list[Step]:
    """The steps at which a tree ends, each once."""
    ends: dict[int, Step] = {}
    stack = list(branches)[::-1]
    while stack:
        branch = stack.pop()
        goes_on = any(not below.again and not _is_broken(below) for below in branch.branches)
        if not goes_on and not branch.again and not _is_broken(branch):
            ends.setdefault(id(branch.step), branch.step)
        stack += branch.branches[::-1]
    return list(ends.values())


__all__ = ["MOST_WAYS", "Trace", "Way", "traces"]
