"""The shortest ways from the sources of a name to it, and from it to its ends."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.dataflow.model import Link, Step, StepKind
from archlint.dataflow.paths import Branch, shortest
from archlint.dataflow.subjects import Subject

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow


MOST_WAYS = 12
"""Sources, and ends, to which the shortest way and its times are worked out for one trace."""


def shortest_ways(
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


__all__ = ["MOST_WAYS", "shortest_ways"]
