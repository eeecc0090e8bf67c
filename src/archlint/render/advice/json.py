"""Advice as data.  A key is always there, null where nothing is known."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text
from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.advice.model import Advice, Evidence

VERSION = 1


def render(rows: Sequence[Advice]) -> str:
    """All connections, in the order of their kinds and names."""
    return json_text({"version": VERSION, "connections": list(map(_connection, rows))}, indent=2) + "\n"


def _connection(advice: Advice) -> dict[str, Any]:
    judged = advice.judged
    return {
        "kind": advice.kind,
        "name": advice.name,
        "types": list(advice.types),
        "systems": list(advice.systems),
        "use": str(judged.use),
        "rate_hz": judged.rate,
        "fits": advice.is_fitting,
        "better": None if advice.is_fitting else judged.fits,
        "reason": judged.reason,
        "instead": judged.instead or None,
        "evidence": list(map(_evidence, judged.evidence)),
    }


def _evidence(evidence: Evidence) -> dict[str, Any]:
    place = evidence.place
    return {"message": evidence.words, "file": shown_file(place.file), "line": place.line, "column": place.column}


__all__ = ["render"]
