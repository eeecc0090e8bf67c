"""A topic, service or action of which every end has moved to another name: one change, where that is certain."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.comparing.changes import Change, Status, risky
from archlint.comparing.ends import EndChanges
from archlint.comparing.graphs import KINDS, EndKind, Family

_OF_SUBJECT: dict[str, EndKind] = {kind: kind for kind in KINDS}


def topics_renamed(changes: Sequence[Change], ends: EndChanges) -> list[Change]:
    """The changes, with one in place of those of the ends of what is renamed as a whole: both sides of it were here,
    all of its ends went from one name, which nothing has any more, to one that nothing had."""
    gone: dict[tuple[Family, str], list[Change]] = {}
    came: dict[tuple[Family, str], list[Change]] = {}
    for change in changes:
        kind = _OF_SUBJECT.get(change.subject)
        if kind is None or change.with_node:
            continue
        family = KINDS[kind].family
        if change.status == Status.REMOVED:
            gone.setdefault((family, change.name), []).append(change)
        elif change.status == Status.ADDED:
            came.setdefault((family, change.name), []).append(change)
        elif change.status == Status.RENAMED and change.before is not None:
            gone.setdefault((family, change.before), []).append(change)
            came.setdefault((family, change.name), []).append(change)
    replaced: dict[int, Change | None] = {}
    for (family, name), lost in gone.items():
        if _ends_at(ends, family, name)[1] or len(_kinds(lost)) < 2:
            continue
        targets = [
            (other, arrived)
            for (other_family, other), arrived in came.items()
            if other_family == family and _signature(arrived) == _signature(lost)
        ]
        if len(targets) != 1 or _ends_at(ends, family, targets[0][0])[0]:
            continue
        target, moved = targets[0]
        if len(_ends_at(ends, family, name)[0]) != len(lost) or len(_ends_at(ends, family, target)[1]) != len(moved):
            continue
        replaced |= {id(change): None for change in (*lost, *moved)}
        replaced[id(moved[0])] = _renamed(family, name, target, moved)
    kept = [(change, replaced.get(id(change), change)) for change in changes]
    return [new for _, new in kept if new is not None]


def _kinds(changes: Sequence[Change]) -> set[str]:
    return {change.subject for change in changes}


def _signature(changes: Sequence[Change]) -> list[tuple[str, str, str]]:
    return sorted((change.subject, change.owner or "", change.type or "") for change in changes)


def _ends_at(ends: EndChanges, family: Family, name: str) -> tuple[list[object], list[object]]:
    """Those of both sides."""
    kind: EndKind = next(kind for kind, row in KINDS.items() if row.family == family)
    before, after = ends.before, ends.after
    return (
        [*before.at(kind, name), *before.opposite(kind, name)],
        [*after.at(kind, name), *after.opposite(kind, name)],
    )


def _renamed(family: Family, before: str, after: str, ends: Sequence[Change]) -> Change:
    ends_here = "both ends" if len(ends) == 2 else f"all {len(ends)} ends"
    return Change(
        Status.RENAMED,
        family,
        after,
        risky(f"{ends_here} here have moved; bags, tools and nodes elsewhere use the old name"),
        aspect="name",
        values=(before, after),
        type=ends[0].type,
        spot=ends[0].spot,
        cause=(before, after),
    )
