"""SARIF 2.1.0, for code scanning services.

The limits are those of GitHub, the strictest reader: 25,000 results in a run, 1,000 locations in a result.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from archlint import __version__
from archlint.finding import Finding, Place, Severity
from archlint.report.fingerprint import with_fingerprints
from archlint.report.json import dumps
from archlint.report.paths import findings_in_repository
from archlint.rulebook import Rule, rules

if TYPE_CHECKING:
    from archlint.report.model import Report

SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
MAX_RESULTS = 25_000
MAX_LOCATIONS = 1_000

_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}


def render(report: Report) -> str:
    kept = _most_severe(findings_in_repository(report))
    codes = sorted({finding.code for finding in kept})
    run = {
        "tool": {
            "driver": {
                "name": "archlint",
                "version": __version__,
                "semanticVersion": __version__,
                "rules": [_rule(rules()[code]) for code in codes],
            }
        },
        "columnKind": "unicodeCodePoints",
        "invocations": [_invocation(report, len(kept))],
        "results": [_result(finding, codes, mark) for finding, mark in with_fingerprints(kept)],
    }
    return dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]})


def _most_severe(findings: list[Finding]) -> list[Finding]:
    """All findings, or as many of the most severe as a reader takes; the order stays."""
    if len(findings) <= MAX_RESULTS:
        return findings
    chosen = sorted(range(len(findings)), key=lambda index: (-findings[index].severity, index))[:MAX_RESULTS]
    return [findings[index] for index in sorted(chosen)]


def _invocation(report: Report, kept: int) -> dict[str, Any]:
    failed = any(finding.code == "LNT003" for finding in report.findings)
    invocation: dict[str, Any] = {"executionSuccessful": not failed}
    left_out = len(report.findings) - kept
    if left_out:
        text = f"{left_out} findings are left out: code scanning takes {MAX_RESULTS} at most"
        invocation["toolExecutionNotifications"] = [{"level": "warning", "message": {"text": text}}]
    return invocation


def _rule(rule: Rule) -> dict[str, Any]:
    return {
        "id": rule.code,
        "name": rule.name,
        "shortDescription": {"text": rule.summary},
        "fullDescription": {"text": rule.summary},
        "help": {"text": rule.page, "markdown": rule.page},
        "defaultConfiguration": {"level": _LEVELS[rule.severity]},
        "properties": {"tags": ["ros2", "architecture"]},
    }


def _result(finding: Finding, codes: list[str], mark: str) -> dict[str, Any]:
    text = finding.message + (f"\n{finding.help}" if finding.help else "")
    result: dict[str, Any] = {
        "ruleId": finding.code,
        "ruleIndex": codes.index(finding.code),
        "level": _LEVELS[finding.severity],
        "message": {"text": text},
        "locations": [{"physicalLocation": _location(finding.place)}],
        "partialFingerprints": {"archlint/v1": mark},
    }
    if finding.related:
        result["relatedLocations"] = [
            {"id": number, "physicalLocation": _location(related.place), "message": {"text": related.message}}
            for number, related in enumerate(finding.related[: MAX_LOCATIONS - 1], 1)
        ]
    about = {"node": finding.node, "system": finding.system, "condition": finding.condition}
    properties = {key: value for key, value in about.items() if value is not None}
    return result | ({"properties": properties} if properties else {})


def _location(place: Place) -> dict[str, Any]:
    return {
        "artifactLocation": {"uri": quote(os.fsencode(place.file), safe="/")},
        "region": {
            "startLine": place.line,
            "startColumn": place.column,
            "endLine": place.end_line,
            "endColumn": place.end_column,
        },
    }
