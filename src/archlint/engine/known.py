"""Findings that are known already, by what they are about and not by their lines: those that a baseline holds, and
those that an earlier revision has, too."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence, Set
from dataclasses import field, replace
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.report.occurrence import Key, Occurrence

if TYPE_CHECKING:
    from archlint.finding import Finding, Severity

NEVER_HELD = ("LNT003", "LNT004")
"""A failure of ours, and an entry that nothing matches, are news each time."""


@dataclass(frozen=True)
class Entry:
    """A line of a baseline."""

    line: int
    key: Key


@dataclass(frozen=True)
class Baseline:
    """The findings that a file holds; ``file`` is its path as shown."""

    file: str
    entries: tuple[Entry, ...] = ()


class Known:
    """Each key as often as it was noted: who takes it may have it once for each time."""

    def __init__(self, keys: Iterable[Key]) -> None:
        self._left = Counter(keys)

    def takes(self, key: Key) -> bool:
        """Whether a finding is known; it is used up."""
        if self._left[key] <= 0:
            return False
        self._left[key] -= 1
        return True


@dataclass(frozen=True)
class Older:
    """A finding of an earlier revision, and how much it weighs there."""

    key: Key
    severity: Severity


class Earlier:
    """The findings of an earlier revision.  One that weighs more now is new: the change has made it matter."""

    def __init__(self, findings: Iterable[Older]) -> None:
        self._left: dict[Key, list[Severity]] = {}
        for finding in findings:
            self._left.setdefault(finding.key, []).append(finding.severity)

    def takes(self, key: Key, severity: Severity) -> bool:
        """Whether a finding was there, and weighed as much at least; it is used up."""
        left = self._left.get(key, [])
        enough = [weight for weight in left if weight >= severity]
        if enough:
            left.remove(min(enough))
        return bool(enough)


@dataclass
class Sifted:
    """The findings of one workspace."""

    new: list[Finding] = field(default_factory=list)
    baselined: list[Finding] = field(default_factory=list)
    older: list[Finding] = field(default_factory=list)
    """Those that an earlier revision has, too, and no baseline."""


class Sieve:
    """Lets through what is new, of all workspaces that stand side by side.

    ``before`` are the findings of an earlier revision, None where it is not compared with one.
    """

    def __init__(self, baseline: Baseline | None = None, before: Sequence[Older] | None = None) -> None:
        self._held: list[Occurrence] = []
        self._unheld: list[tuple[Finding, Set[str]]] = []
        """The findings where there is nothing to compare them with."""
        self._entries = () if baseline is None else baseline.entries
        self._older = None if before is None else Counter(older.key for older in before)
        self._baseline = Known(entry.key for entry in self._entries)
        self._before = Earlier(before or ())
        self._of_gone_files = Earlier(
            Older(_anywhere(older.key), older.severity) for older in before or () if not os.path.lexists(older.key.file)
        )

    def part(self, findings: Iterable[Finding], files: Set[str] = frozenset()) -> Sifted:
        """The findings of one workspace, known ones apart; ``files`` are its files, as findings name them."""
        ordered = sorted(findings, key=lambda finding: finding.sort_key)
        if not self._entries and self._older is None:
            self._unheld += ((finding, files) for finding in ordered)
            return Sifted(new=ordered)
        sifted = Sifted()
        for finding in ordered:
            occurrence = Occurrence.of(finding, files)
            # Both are asked: what the baseline holds is no longer there for an equal finding that is new.
            baselined, older = self._baseline.takes(occurrence.key), self._is_older(occurrence)
            if finding.code in NEVER_HELD:
                baselined = older = False
            (sifted.baselined if baselined else sifted.older if older else sifted.new).append(finding)
            self._held.append(replace(occurrence, known=baselined or older))
        return sifted

    @property
    def occurrences(self) -> list[Occurrence]:
        """Every finding so far as it is known again."""
        return [*self._held, *(Occurrence.of(finding, files) for finding, files in self._unheld)]

    def _is_older(self, occurrence: Occurrence) -> bool:
        """Whether the earlier revision has a finding, too, perhaps in a file that was renamed since."""
        key, severity = occurrence.key, occurrence.severity
        return self._before.takes(key, severity) or self._of_gone_files.takes(_anywhere(key), severity)

    def idle(self) -> list[Entry]:
        """The entries of the baseline that no finding matches; with an earlier revision those that one did there."""
        present = Counter(occurrence.key for occurrence in self.occurrences)
        matched = Known(present.elements())
        idle = [entry for entry in self._entries if not matched.takes(entry.key)]
        if self._older is None:
            return idle
        gone = Known((self._older - present).elements())
        return [entry for entry in idle if gone.takes(entry.key)]


def _anywhere(key: Key) -> Key:
    return replace(key, file="")


__all__ = ["NEVER_HELD", "Baseline", "Entry", "Known", "Older", "Sieve", "Sifted"]
