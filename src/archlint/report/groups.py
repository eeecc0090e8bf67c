"""Findings by what they have in common, under a heading each, and the most important ones among many."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.report.model import GroupName, Report

GROUPS: Mapping[GroupName, Callable[[Finding, Report], str]] = {
    "rule": lambda finding, report: f"{finding.code} {finding.name}",
    "package": lambda finding, report: package_of(finding, report) or "no package",
    "node": lambda finding, report: finding.node or "no node",
    "file": lambda finding, report: finding.place.file,
}
"""What a finding is grouped by, and the heading under which it stands then."""


def package_of(finding: Finding, report: Report) -> str | None:
    """The name of the package that a finding's file lies in."""
    return report.packages.get(finding.place.file)


def grouped(report: Report) -> Iterator[tuple[str, list[Finding]]]:
    """Headings with their findings, in the order of the headings; one empty heading where nothing is to be grouped."""
    if report.grouping is None:
        yield "", list(report.findings)
        return
    heading_of = GROUPS[report.grouping]
    groups: dict[str, list[Finding]] = {}
    for finding in report.findings:
        groups.setdefault(heading_of(finding, report), []).append(finding)
    for heading in sorted(groups):
        findings = groups[heading]
        yield f"{visible(heading)}: {len(findings)} finding{'s' if len(findings) > 1 else ''}", findings


def most_important(report: Report, most: int) -> Sequence[Finding]:
    """So many of the findings: the most severe first, and of these what is in launched code."""
    return sorted(report.findings, key=lambda finding: (-finding.severity, not is_launched(finding, report)))[:most]


def is_launched(finding: Finding, report: Report) -> bool:
    """Whether it is about a system of a launch file, or in code of a node that one starts."""
    return finding.system is not None or finding.place.file in report.launched


__all__ = ["GROUPS", "grouped", "is_launched", "most_important", "package_of"]
