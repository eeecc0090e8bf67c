"""NME004, launch files that a system includes twice: where a whole stack comes again, the include that brings it."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

from archlint.checks.registry import finding
from archlint.finding import Finding, Place, Related

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.systems.nodes import Node

Twins = tuple["Node", "Node"]


class Again(NamedTuple):
    """A launch ``file`` that is included at two places, and the includes further out that lead to each, as far as these
    two have none in common: outermost first, each place itself the last."""

    file: str
    first: tuple[Place, ...]
    second: tuple[Place, ...]


def included_twice(started: Started | None, other: Started | None) -> Again | None:
    """The file that is included twice and that two processes come from; None where there is none."""
    if started is None or other is None or started.place != other.place:
        return None
    before, after, file = list(started.includes), list(other.includes), started.file
    while before and after and before[-1] == after[-1]:
        file = before.pop().file
        after.pop()
    if not before or not after:
        return None
    while before[0] == after[0] and len(before) > 1 and len(after) > 1:
        del before[0], after[0]
    return Again(file, tuple(before), tuple(after))


def of_includes(included: Mapping[Again, Sequence[Twins]]) -> Iterator[Finding]:
    """One finding for each file that is included twice; one for all that come again with one include further out, at
    that include."""
    left = dict(included)
    for leads_from in (_second, _first):
        outer = {again: _outermost(leads_from(again)) for again in left}
        counts = Counter(outer.values())
        for place in [place for place, number in counts.items() if place is not None and number > 1]:
            several = {again: left.pop(again) for again in list(left) if outer[again] == place}
            yield _of_a_stack(place, [leads_from(again) for again in several], several)
    for again, twins in left.items():
        yield _of_an_include(again, twins)


def _first(again: Again) -> tuple[Place, ...]:
    return again.first


def _second(again: Again) -> tuple[Place, ...]:
    return again.second


def _outermost(includes: Sequence[Place]) -> Place | None:
    """The include that brings a file by way of another one; None where it includes the file itself."""
    return includes[0] if len(includes) > 1 else None


def _of_a_stack(place: Place, led: Sequence[Sequence[Place]], several: Mapping[Again, Sequence[Twins]]) -> Finding:
    """``led`` are the includes that ``place`` leads to."""
    names = sorted(node.name or "" for twins in several.values() for node, _ in twins)
    files = sorted({posixpath.basename(again.file) for again in several})
    brought = posixpath.basename(led[0][1].file)
    shown = ", ".join(files[:3]) + (f" and {len(files) - 3} more" if len(files) > 3 else "")
    related: dict[Related, None] = {}
    for again, includes in zip(several, led, strict=True):
        file = posixpath.basename(again.file)
        beside = again.second if includes == again.first else again.first
        related.setdefault(Related(beside[-1], f"{file} is included here, too"))
    return finding(
        "NME004",
        place,
        f"what {brought} includes is included beside it, too ({shown}), which starts {_twice(names)}",
        help=f"include each of these once: give {brought} an argument that leaves them out",
        related=list(related),
        node=names[0],
        identity=(brought, *names),
    )


def _of_an_include(again: Again, several: Sequence[Twins]) -> Finding:
    names = sorted(node.name or "" for node, _ in several)
    file = posixpath.basename(again.file)
    started_at = [Related(n.launch_place, f"{n.name} is started here") for n, _ in several[:1] if n.launch_place]
    return finding(
        "NME004",
        again.second[-1],
        f"this system includes {file} twice, which starts {_twice(names)}",
        help="include it once, or in a different namespace each time",
        related=[Related(again.first[-1], "it is first included here"), *started_at],
        node=names[0],
        identity=(file, *names),
    )


def _twice(names: Sequence[str]) -> str:
    return f"'{names[0]}' twice" if len(names) == 1 else f"{len(names)} nodes twice, such as '{names[0]}'"


__all__ = ["Again", "Twins", "included_twice", "of_includes"]
