"""A change, and what it does to others."""

from __future__ import annotations

from collections import Counter
from dataclasses import field, replace
from typing import Literal

from archlint.records import dataclass
from archlint.string_enum import StringEnum


class Impact(StringEnum):
    """What a change does to what it does not change itself, worst first."""

    BREAKING = "breaking"
    RISKY = "risky"
    SAFE = "safe"

    @property
    def rank(self) -> int:
        """0 is the worst."""
        return list(Impact).index(self)


class Status(StringEnum):
    REMOVED = "removed"
    RENAMED = "renamed"
    CHANGED = "changed"
    ADDED = "added"


Subject = Literal[
    "node",
    "topic",
    "publisher",
    "subscriber",
    "service",
    "client",
    "action",
    "action_server",
    "action_client",
    "parameter",
    "remapping",
    "launch_file",
    "launch_argument",
    "interface",
    "field",
    "constant",
]


@dataclass(frozen=True)
class Spot:
    """A line of one of the two sides."""

    file: str
    line: int
    before: bool = False
    """Whether it is a line of the base."""


@dataclass(frozen=True)
class Judgement:
    """How much a change weighs, and why."""

    impact: Impact
    reason: str

    @staticmethod
    def worst(first: Judgement, *others: Judgement) -> Judgement:
        """The heaviest, the first of equals."""
        return min((first, *others), key=lambda judgement: judgement.impact.rank)


@dataclass(frozen=True)
class Change:
    """One change.  ``name`` is that of its subject (after the change, where it has one there), ``owner`` the node or
    interface that it belongs to, ``aspect`` what has changed of it, and ``values`` what that was and is."""

    status: Status
    subject: Subject
    name: str
    judgement: Judgement
    owner: str | None = None
    aspect: str | None = None
    values: tuple[str | None, str | None] | None = None
    type: str | None = None
    spot: Spot | None = None
    cause: tuple[object, ...] = ()
    """Equal for what one edit does in several systems."""
    with_node: bool = False
    """Whether it came or went with its node."""
    systems: tuple[str | None, ...] = ()
    """The launch files of the systems in which it is met; None for all nodes of the workspace."""
    others: tuple[str, ...] = field(default=())
    """The names that the subject has in further systems."""

    @property
    def impact(self) -> Impact:
        return self.judgement.impact

    @property
    def reason(self) -> str:
        return self.judgement.reason

    @property
    def before(self) -> str | None:
        return None if self.values is None else self.values[0]

    @property
    def after(self) -> str | None:
        return None if self.values is None else self.values[1]


def breaking(reason: str) -> Judgement:
    return Judgement(Impact.BREAKING, reason)


def risky(reason: str) -> Judgement:
    return Judgement(Impact.RISKY, reason)


def safe(reason: str) -> Judgement:
    return Judgement(Impact.SAFE, reason)


_SUBJECTS: tuple[Subject, ...] = Subject.__args__  # type: ignore[attr-defined]
_STATUSES = list(Status)


def in_order(changes: list[Change]) -> list[Change]:
    """The changes, the heaviest first, each once for what one edit does in several systems."""
    merged: dict[tuple[object, ...], Change] = {}
    times: Counter[tuple[object, ...]] = Counter()
    for change in changes:
        same = (change.status, change.subject, change.aspect, change.cause or (change.owner, change.name))
        times[same, change.systems] += 1
        key = (same, times[same, change.systems])  # a loop creates several ends at one place
        merged[key] = _joined(merged[key], change) if key in merged else change
    return sorted(merged.values(), key=_order)


def _joined(first: Change, other: Change) -> Change:
    main = min(first, other, key=lambda change: change.impact.rank)
    names = dict.fromkeys((*first.others, first.name, other.name, *other.others))
    return replace(
        main,
        systems=tuple(dict.fromkeys((*first.systems, *other.systems))),
        others=tuple(name for name in names if name != main.name),
    )


def _order(change: Change) -> tuple[object, ...]:
    return (
        change.impact.rank,
        _SUBJECTS.index(change.subject),
        change.owner or "",
        change.name,
        _STATUSES.index(change.status),
        change.aspect or "",
        change.before or "",
        change.after or "",
        tuple(system or "" for system in change.systems),
    )
