"""Ways through the graph of data: what leads to a step and on from it, and the shortest way between two."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Literal

from archlint.dataflow.model import StepKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.dataflow.model import Flow, Link, Step

Direction = Literal["back", "on"]


_BETWEEN = frozenset({StepKind.KEPT, StepKind.ANSWER, StepKind.RESULT})
"""What is not worth a line where all that it leads to has been shown on the way to it."""


@dataclass(frozen=True, eq=False)
class Branch:
    """What a link leads to, going back or on.  ``again`` says that what is beyond is shown elsewhere in the tree."""

    step: Step
    link: Link | None
    branches: tuple[Branch, ...] = ()
    again: bool = False


def tree(
    flow: Flow, starts: Sequence[Step], direction: Direction, within: Collection[int] | None = None
) -> list[Branch]:
    """What leads to some steps, or on from them, each step once and by the shortest way.

    A stranger ends its branch; so does a link that is broken.  ``within`` are the steps (``id``) that count."""
    children: dict[int, list[tuple[Link, bool]]] = {}
    parents: dict[int, Step | None] = {id(step): None for step in starts}
    queue = deque(starts)
    while queue:
        step = queue.popleft()
        rows = children.setdefault(id(step), [])
        if step.kind == StepKind.STRANGER and all(step is not start for start in starts):
            continue
        for link in _links(flow, step, direction):
            other = link.tail if direction == "back" else link.head
            if within is not None and id(other) not in within:
                continue
            is_new = id(other) not in parents and not link.broken
            if is_new or link.broken or not _is_above(other, step, parents):
                rows.append((link, is_new))
            if is_new:
                parents[id(other)] = step
                queue.append(other)
    return [_grown(flow, start, children, direction) for start in starts]


def _is_above(other: Step, step: Step, parents: Mapping[int, Step | None]) -> bool:
    """Whether a link leads back to a step that its branch comes from: a loop in the flow of data."""
    above: Step | None = step
    while above is not None:
        if above is other:
            return True
        above = parents[id(above)]
    return False


def _grown(flow: Flow, start: Step, children: dict[int, list[tuple[Link, bool]]], direction: Direction) -> Branch:
    """The tree of a start, made from its ends: it may be deeper than Python calls functions."""
    order: list[Step] = [start]
    for step in order:
        order += [_other(link, direction) for link, is_new in children.get(id(step), ()) if is_new]
    below: dict[int, tuple[Branch, ...]] = {}
    for step in reversed(order):
        below[id(step)] = tuple(
            Branch(other, link, below.get(id(other), ()) if is_new else (), not is_new and not link.broken)
            for link, is_new in children.get(id(step), ())
            for other in [_other(link, direction)]
            if not is_new or below[id(other)] or other.kind not in _BETWEEN or not ways_of(flow, other, direction)
        )
    return Branch(start, None, below[id(start)])


def _other(link: Link, direction: Direction) -> Step:
    return link.tail if direction == "back" else link.head


def _links(flow: Flow, step: Step, direction: Direction) -> Sequence[Link]:
    """Those that are shown, the surest first: not what only the step itself leaves for itself, nor an answer for
    nobody."""
    links = [
        link for link in ways_of(flow, step, direction) if not _is_idle(flow, step, _other(link, direction), direction)
    ]
    return sorted(links, key=lambda link: (bool(link.broken), bool(link.doubt)))


def ways_of(flow: Flow, step: Step, direction: Direction) -> Sequence[Link]:
    """The links that lead to a step, or on from it."""
    return flow.into(step) if direction == "back" else flow.out_of(step)


def _is_idle(flow: Flow, step: Step, other: Step, direction: Direction) -> bool:
    match other.kind:
        case StepKind.KEPT:
            return all(_other(link, direction) is step for link in ways_of(flow, other, direction))
        case StepKind.ANSWER | StepKind.RESULT:
            return not flow.out_of(other)
    return False


def reached(flow: Flow, starts: Iterable[Step], direction: Direction, through_strangers: bool = False) -> set[int]:
    """All steps (``id``) that lead to some steps, or that they lead to, these included."""
    queue = deque(starts)
    first = {id(step) for step in queue}
    seen = set(first)
    while queue:
        step = queue.popleft()
        if step.kind == StepKind.STRANGER and id(step) not in first and not through_strangers:
            continue
        for link in ways_of(flow, step, direction):
            other = _other(link, direction)
            if not link.broken and id(other) not in seen:
                seen.add(id(other))
                queue.append(other)
    return seen


def shortest(flow: Flow, starts: Sequence[Step], ends: Collection[int]) -> list[Link] | None:
    """The links of the shortest way from any of some steps to any of others (``id``), of several the surest; None where
    there is none.  A way through what is in doubt counts as longer than any other."""
    for with_doubts in (False, True):
        before: dict[int, Link | None] = {id(step): None for step in starts}
        queue = deque(starts)
        while queue:
            step = queue.popleft()
            if id(step) in ends:
                return _way(step, before)
            for link in flow.out_of(step):
                if id(link.head) not in before and not link.broken and (with_doubts or not link.doubt):
                    before[id(link.head)] = link
                    queue.append(link.head)
    return None


def _way(step: Step, before: dict[int, Link | None]) -> list[Link]:
    links: list[Link] = []
    while (link := before[id(step)]) is not None:
        links.append(link)
        step = link.tail
    return links[::-1]


__all__ = ["Branch", "Direction", "reached", "shortest", "tree"]
