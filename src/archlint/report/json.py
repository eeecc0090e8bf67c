"""Findings as JSON, for editors, scripts and dashboards: version 1."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text

if TYPE_CHECKING:
    from archlint.finding import Edit, Finding, Fix
    from archlint.report.model import Report

VERSION = 1
"""Raised when a key changes its meaning or goes away; new keys come without notice."""


def render(report: Report) -> str:
    document = {
        "version": VERSION,
        "diagnostics": [diagnostic(finding) for finding in report.findings],
        "summary": {**asdict(report.summary), "elapsed_s": round(report.summary.elapsed_s, 3)},
    }
    return dumps(document)


def dumps(document: object) -> str:
    """JSON in ASCII, so that no file name can break the encoding of a pipe."""
    return json_text(document, indent=1) + "\n"


def diagnostic(finding: Finding) -> dict[str, Any]:
    place = finding.place
    return {
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.label,
        "message": finding.message,
        "help": finding.help,
        "file": place.file,
        "line": place.line,
        "column": place.column,
        "end_line": place.end_line,
        "end_column": place.end_column,
        "node": finding.node,
        "system": finding.system,
        "condition": finding.condition,
        "related": [
            {
                "file": related.place.file,
                "line": related.place.line,
                "column": related.place.column,
                "end_line": related.place.end_line,
                "end_column": related.place.end_column,
                "message": related.message,
            }
            for related in finding.related
        ],
        "fix": None if finding.fix is None else _fix(finding.fix),
    }


def _fix(fix: Fix) -> dict[str, Any]:
    return {"safety": fix.safety, "edits": [_edit(edit) for edit in fix.edits]}


def _edit(edit: Edit) -> dict[str, Any]:
    place = edit.place
    return {
        "file": place.file,
        "start": [place.line, place.column],
        "end": [place.end_line, place.end_column],
        "text": edit.text,
    }
