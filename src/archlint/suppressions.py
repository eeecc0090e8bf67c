"""Suppressions in place: which findings they hide, and which of them hide nothing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.facts.model import Suppression
    from archlint.finding import Finding

NEVER_SUPPRESSED = "LNT003"
"""A failure of ours ends with exit status 2, which no comment in a user's file may hide."""


@dataclass(frozen=True)
class Unused:
    """A code of a suppression that hid nothing."""

    file: str
    suppression: Suppression
    code: str


@dataclass
class Outcome:
    """Findings apart by whether a suppression covers them; ``refused`` are bare ignores, by file."""

    kept: list[Finding] = field(default_factory=list)
    suppressed: list[Finding] = field(default_factory=list)
    unused: list[Unused] = field(default_factory=list)
    refused: list[tuple[str, Suppression]] = field(default_factory=list)


def apply(findings: Iterable[Finding], by_file: Mapping[str, Sequence[Suppression]]) -> Outcome:
    """Take away the findings whose primary place is covered by a suppression of their code or name."""
    outcome = Outcome()
    used: set[tuple[str, int, int, str]] = set()
    for finding in findings:
        covering = _covering(finding, by_file.get(finding.place.file, ()))
        used.update(covering)
        (outcome.suppressed if covering else outcome.kept).append(finding)
    for file, suppressions in sorted(by_file.items()):
        for suppression in suppressions:
            if not suppression.codes:
                outcome.refused.append((file, suppression))
            for code in suppression.codes:
                if (file, suppression.line, suppression.column, code) not in used:
                    outcome.unused.append(Unused(file, suppression, code))
    return outcome


def _covering(finding: Finding, suppressions: Sequence[Suppression]) -> list[tuple[str, int, int, str]]:
    """Keys of the suppressions that cover a finding: file, line and column of each and the code it names."""
    if finding.code == NEVER_SUPPRESSED:
        return []
    return [
        (finding.place.file, suppression.line, suppression.column, code)
        for suppression in suppressions
        if suppression.scope == "file" or _covers(suppression, finding.place.line)
        for code in suppression.codes
        if code.upper() == finding.code or code.lower() == finding.name
    ]


def _covers(suppression: Suppression, line: int) -> bool:
    first, last = suppression.applies_to
    return first <= line <= last


def refusal(file: str, suppression: Suppression) -> str:
    """What to tell about a bare ignore."""
    return (
        f"{file}:{suppression.line}:{suppression.column}: a bare `archlint: ignore` hides nothing; "
        "name the rule, as in `# archlint: ignore[SRV003]`"
    )
