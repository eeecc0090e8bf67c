"""Suppressions in place: which findings they hide, and which of them hide nothing."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.edit_sites import IdleSuppression, Sites
from archlint.finding import Finding, Place
from archlint.records import dataclass
from archlint.rulebook import find_rule, may_be_rule, suggestion

if TYPE_CHECKING:
    from archlint.syntax.facts import Suppression

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
    candidates = list(findings)
    on_lines = _on_lines(candidates, by_file)
    for candidate in candidates:
        covering = _covering(candidate, on_lines.get((candidate.place.file, candidate.place.line), ()))
        used.update(covering)
        (outcome.suppressed if covering else outcome.kept).append(candidate)
    for file, suppressions in sorted(by_file.items()):
        for suppression in suppressions:
            if not suppression.codes:
                outcome.refused.append((file, suppression))
            for code in suppression.codes:
                if (file, suppression.line, suppression.column, code) not in used:
                    outcome.unused.append(Unused(file, suppression, code))
    return outcome


def _on_lines(
    findings: Iterable[Finding], by_file: Mapping[str, Sequence[Suppression]]
) -> dict[tuple[str, int], list[Suppression]]:
    """The suppressions that cover a line with findings, by file and line."""
    lines: dict[str, set[int]] = {}
    for candidate in findings:
        lines.setdefault(candidate.place.file, set()).add(candidate.place.line)
    covering: dict[tuple[str, int], list[Suppression]] = {}
    for file, numbers in lines.items():
        ordered = sorted(numbers)
        for suppression in by_file.get(file, ()):
            first, last = suppression.applies_to
            whole = suppression.scope == "file"
            for line in ordered if whole else ordered[bisect_left(ordered, first) : bisect_right(ordered, last)]:
                covering.setdefault((file, line), []).append(suppression)
    return covering


def _covering(finding: Finding, suppressions: Sequence[Suppression]) -> list[tuple[str, int, int, str]]:
    """Keys of the suppressions that cover a finding: file, line and column of each and the code it names."""
    if finding.code == NEVER_SUPPRESSED:
        return []
    return [
        (finding.place.file, suppression.line, suppression.column, code)
        for suppression in suppressions
        for code in suppression.codes
        if code.upper() == finding.code or code.lower() == finding.name
    ]


def stale(unused: Iterable[Unused], ran: frozenset[str]) -> list[Finding]:
    """The LNT001 findings for suppressions that hid nothing though their rules ran, one a comment."""
    comments: dict[tuple[str, int, int], list[Unused]] = {}
    for unused_code in unused:
        rule, comment = find_rule(unused_code.code), unused_code.suppression
        if not may_be_rule(unused_code.code) or (rule is not None and rule.code in ran and rule.code != "LNT001"):
            comments.setdefault((unused_code.file, comment.line, comment.column), []).append(unused_code)
    return [_stale(comments[key]) for key in sorted(comments)]


def _stale(unused: list[Unused]) -> Finding:
    comment, file = unused[0].suppression, unused[0].file
    codes = [unused_code.code for unused_code in unused]
    no_rule = [code for code in codes if not may_be_rule(code)]
    listed = ", ".join(codes)
    return finding(
        "LNT001",
        Place(file, comment.line, comment.column, comment.line, comment.end_column),
        f"there is no rule {no_rule[0]}{suggestion(no_rule[0])}"
        if no_rule
        else f"this suppression of {listed} is unused",
        help="remove it",
        identity=(listed,),
        sites=_sites(file, comment, frozenset(codes)),
    )


def without_reason(by_file: Mapping[str, Sequence[Suppression]]) -> Iterator[Finding]:
    """The LNT005 findings for suppressions that do not say why."""
    for file, suppressions in sorted(by_file.items()):
        for comment in suppressions:
            if comment.codes and not comment.reason:
                listed = ", ".join(comment.codes)
                yield finding(
                    "LNT005",
                    Place(file, comment.line, comment.column, comment.line, comment.end_column),
                    f"this suppression of {listed} gives no reason",
                    help=f"add the reason behind the bracket: `ignore[{listed}] <why>`",
                    identity=(listed,),
                )


def _sites(file: str, comment: Suppression, idle: frozenset[str]) -> Sites | None:
    """What to edit for the codes that hide nothing."""
    if comment.listed is None:
        return None
    start, end = comment.listed
    suppression = IdleSuppression(
        Place(file, comment.line, comment.column, comment.line, comment.end_column),
        Place(file, comment.line, start, comment.line, end),
        needed=tuple(code for code in comment.codes if code not in idle),
        closed=comment.closed,
    )
    return Sites(suppressions=(suppression,))


def refusal(file: str, suppression: Suppression) -> str:
    """What to say about a bare ignore, and about words that only look like a suppression."""
    where = f"{file}:{suppression.line}:{suppression.column}"
    if suppression.not_understood:
        return f"{where}: `{suppression.not_understood}` has no effect; write it as `archlint: ignore[{_CODE}]`"
    return f"{where}: a bare `archlint: ignore` has no effect; name the rule, as in `# archlint: ignore[{_CODE}]`"


_CODE = "SRV003"
