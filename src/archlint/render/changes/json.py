"""A comparison as JSON, version 1: every key is always there, null where nothing is known."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from archlint.comparing.changes import Change, Impact
from archlint.json_text import json_text
from archlint.render.changes.model import Difference, SideName
from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.finding import Finding

VERSION = 1


def render(difference: Difference) -> str:
    return json_text(document(difference), indent=2) + "\n"


def document(difference: Difference) -> dict[str, Any]:
    """The comparison as plain data."""
    appeared, vanished = difference.appeared, difference.vanished
    return {
        "version": VERSION,
        "base": _side(difference.base),
        "head": _side(difference.head),
        "summary": {impact.value: len(difference.of(impact)) for impact in Impact},
        "changes": [_change(change) for change in difference.changes],
        "findings": None
        if appeared is None or vanished is None
        else {"appeared": _findings(appeared), "vanished": _findings(vanished)},
        "notices": list(difference.notices),
    }


def _side(side: SideName) -> dict[str, Any]:
    return {"name": side.shown, "commit": side.commit}


def _change(change: Change) -> dict[str, Any]:
    spot = change.spot
    return {
        "impact": change.impact.value,
        "status": change.status.value,
        "subject": change.subject,
        "name": change.name,
        "owner": change.owner,
        "aspect": change.aspect,
        "before": change.before,
        "after": change.after,
        "type": change.type,
        "reason": change.reason,
        "side": None if spot is None else "base" if spot.before else "head",
        "file": None if spot is None else spot.file,
        "line": None if spot is None else spot.line,
        "with_node": change.with_node,
        "systems": list(change.systems),
        "other_names": list(change.others),
    }


def _findings(findings: Sequence[Finding]) -> list[dict[str, Any]]:
    return [
        {
            "code": finding.code,
            "severity": finding.severity.label,
            "message": finding.message,
            "file": shown_file(finding.place.file),
            "line": finding.place.line,
            "column": finding.place.column,
        }
        for finding in findings
    ]
