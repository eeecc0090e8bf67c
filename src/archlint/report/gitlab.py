"""GitLab's code quality report, shown in merge requests."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from archlint.finding import Finding, Severity
from archlint.report.fingerprint import with_fingerprints
from archlint.report.json import dumps
from archlint.report.paths import findings_in_repository

if TYPE_CHECKING:
    from archlint.report.model import Report

_LEVELS = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(report: Report) -> str:
    findings = findings_in_repository(report)
    return dumps([_issue(finding, mark) for finding, mark in with_fingerprints(findings)])


def _issue(finding: Finding, mark: str) -> dict[str, Any]:
    place = finding.place
    return {
        "check_name": finding.code,
        "description": f"{finding.code} {finding.name}: {finding.message}",
        "severity": _LEVELS[finding.severity],
        "fingerprint": mark,
        "location": {"path": place.file, "lines": {"begin": place.line, "end": place.end_line}},
    }
