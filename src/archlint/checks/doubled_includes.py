"""NME004, launch files that a system includes twice: where a whole stack comes again, the include that brings it."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
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


def of_includes(included: Mapping[Again, Sequence[Twins]], nodes: Sequence[Node]) -> Iterator[Finding]:
    """One finding for each file that is included twice; one for all that come again with one include further out, at
    that include.  ``nodes`` are all of the system."""
    left = dict(included)
    for leads_from in (_second, _first):
        outer = {again: _outermost(leads_from(again)) for again in left}
        counts = Counter(outer.values())
        for place in [place for place, number in counts.items() if place is not None and number > 1]:
            several = {again: left.pop(again) for again in list(left) if outer[again] == place}
            yield _of_a_stack(place, [leads_from(again) for again in several], several)
    for again, twins in left.items():
        apart = _namespaces_of_each(again, twins, nodes)
        yield _of_an_include(again, twins) if apart is None else _without_namespace(again, twins, apart, nodes)


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


def _namespaces_of_each(again: Again, twins: Sequence[Twins], nodes: Sequence[Node]) -> tuple[Node, Node] | None:
    """Two nodes that one action starts, for each of two includes in another namespace: whoever includes the file keeps
    them apart."""
    by_place: dict[Place, list[Node]] = {}
    for node in (node for node in nodes if node.started is not None and node.started.namespace is not None):
        assert node.started is not None
        by_place.setdefault(node.started.place, []).append(node)
    near = {twin.started.file for pair in twins for twin in pair if twin.started is not None}
    ordered = sorted(by_place, key=lambda place: place.file not in near)
    pairs = (pair for place in ordered for pair in combinations(by_place[place], 2))
    return next((pair for pair in pairs if _are_apart(again, *(node.started for node in pair))), None)


def _are_apart(again: Again, first: Started | None, second: Started | None) -> bool:
    if first is None or second is None or first.namespace is None or second.namespace is None:
        return False
    known = first.namespace.resolution == second.namespace.resolution == "exact"
    return known and first.namespace.text != second.namespace.text and included_twice(first, second) == again


def _are_there_already(names: Sequence[str], apart: tuple[Node, Node], nodes: Sequence[Node]) -> bool:
    """Whether a node of one of some names is in a namespace that the includes would give it, too."""
    taken = {node.name for node in nodes}
    spaces = [(node.name or "").rpartition("/")[0] for node in apart]
    return any(f"{space}/{name.rpartition('/')[2]}" in taken for name in names for space in spaces)


def _without_namespace(
    again: Again, several: Sequence[Twins], apart: tuple[Node, Node], nodes: Sequence[Node]
) -> Finding:
    """What is told where the file gives other nodes the namespace of the include: the same for all that include it."""
    places = sorted(node.launch_place for node, _ in several if node.launch_place is not None)
    names = sorted(node.name or "" for node, _ in several)
    file = posixpath.basename(again.file)
    what = f"'{names[0]}' gets none: it is"
    if len(names) > 1:
        what = f"{len(names)} get none, such as '{names[0]}': they are"
    beside = [node.launch_place for node in apart[:1] if node.launch_place is not None]
    return finding(
        "NME004",
        places[0],
        f"{file} is included twice, each time with another namespace for its nodes, but {what} started twice under one "
        "name",
        help=f"start it once, outside of {file}"
        if _are_there_already(names, apart, nodes)
        else f"give it namespace=, too, or start it once, outside of {file}",
        related=[
            *(Related(place, "this one, too") for place in places[1:]),
            *(Related(place, "this one gets the namespace") for place in beside),
            Related(again.first[-1], "it is first included here"),
            Related(again.second[-1], "it is included again here"),
        ],
        node=names[0],
        identity=(file, *names),
    )


def _twice(names: Sequence[str]) -> str:
    return f"'{names[0]}' twice" if len(names) == 1 else f"{len(names)} nodes twice, such as '{names[0]}'"


__all__ = ["Again", "Twins", "included_twice", "of_includes"]
