"""Suppressions in place: which findings they hide, and which of them hide nothing."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Edit, Finding, Fix, Place
from archlint.rulebook import find_rule, suggestion

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
    for one in findings:
        covering = _covering(one, by_file.get(one.place.file, ()))
        used.update(covering)
        (outcome.suppressed if covering else outcome.kept).append(one)
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
        if suppression.covers(finding.place.line)
        for code in suppression.codes
        if code.upper() == finding.code or code.lower() == finding.name
    ]


def stale(unused: Iterable[Unused], ran: frozenset[str], line: Callable[[str, int], str | None]) -> list[Finding]:
    """The LNT001 findings for suppressions that hid nothing though their rules ran, one a comment."""
    comments: dict[tuple[str, int, int], list[Unused]] = {}
    for one in unused:
        rule = find_rule(one.code)
        if rule is None or (rule.code in ran and rule.code != "LNT001"):
            comments.setdefault((one.file, one.suppression.line, one.suppression.column), []).append(one)
    return [_stale(comments[key], line) for key in sorted(comments)]


def _stale(unused: list[Unused], line: Callable[[str, int], str | None]) -> Finding:
    first = unused[0]
    comment, file = first.suppression, first.file
    codes = ", ".join(one.code for one in unused)
    no_rule = [one.code for one in unused if find_rule(one.code) is None]
    return replace(
        finding(
            "LNT001",
            Place(file, comment.line, comment.column, comment.line, comment.end_column),
            f"there is no rule {no_rule[0]}{suggestion(no_rule[0])}"
            if no_rule
            else f"this suppression of {codes} is unused",
            help="remove it",
            identity=(codes,),
        ),
        fix=_without(first, {one.code for one in unused}, line(file, comment.line)),
    )


_ALONE_IN_XML = re.compile(r"<!--\s*archlint:\s*ignore(?:-file)?\[[^\]]*\]\s*-->")


def _without(one: Unused, codes: set[str], line: str | None) -> Fix | None:
    """Take codes out of a comment, or all of it where none is left.  A comment of XML that says more is left to
    its author."""
    comment = one.suppression
    if line is None:
        return None
    left = [code for code in comment.codes if code not in codes]
    start, end, last = comment.column, comment.end_column, comment.line
    text = line[start - 1 : end - 1]
    rest = line[end - 1 :]
    in_xml = text.startswith("<")
    if in_xml and _ALONE_IN_XML.fullmatch(text) is None:
        return None
    if left:
        new = f"{text.partition('[')[0]}[{', '.join(left)}]{text.partition(']')[2]}"
    elif in_xml and rest.strip():
        new = ""
        end += len(rest) - len(rest.lstrip())
    elif rest.strip():
        new = "" if rest.lstrip().startswith("#") else "#"
        end += len(rest) - len(rest.lstrip()) if not new else 0
    else:
        new, end = "", len(line) + 1
        start = len(line[: start - 1].rstrip()) + 1
        if start == 1:
            last, end = last + 1, 1  # nothing else stands on the line
    return Fix("safe", (Edit(Place(one.file, comment.line, start, last, end), new),), "remove the suppression")


def refusal(file: str, suppression: Suppression) -> str:
    """What to tell about a bare ignore, and about words that only look like a suppression."""
    where = f"{file}:{suppression.line}:{suppression.column}"
    if suppression.not_understood:
        return f"{where}: `{suppression.not_understood}` has no effect; write it as `archlint: ignore[{_CODE}]`"
    return f"{where}: a bare `archlint: ignore` has no effect; name the rule, as in `# archlint: ignore[{_CODE}]`"


_CODE = "SRV003"
