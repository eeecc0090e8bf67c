"""What a change breaks, as data."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from archlint.json_text import json_text
from archlint.render.json import shown_file

if TYPE_CHECKING:
    from archlint.dataflow.consequences import Effect
    from archlint.dataflow.impacts import Impact
    from archlint.place import Place


VERSION = 1


def render_json(name: str, impacts: Sequence[Impact]) -> str:
    """The same as data; a key is always there, null where nothing is known."""
    document = {"version": VERSION, "name": name, "matches": [_document(impact) for impact in impacts]}
    return json_text(document, indent=2) + "\n"


def _document(impact: Impact) -> dict[str, Any]:
    return {
        "kind": impact.kind,
        "name": impact.name,
        "systems": impact.systems,
        "used_by": [_effect_data(effect) for effect in impact.direct],
        "through_callbacks": [_effect_data(effect) for effect in impact.further],
        "uses": [
            {"kind": use.kind, "message": use.words, "package": use.package, **_place(use.place)} for use in impact.uses
        ],
        "launch_files": [{"message": row.words, **_place(row.place)} for row in impact.launch_files],
        "parameter_files": [{"message": row.words, **_place(row.place)} for row in impact.parameter_files],
        "packages": impact.packages,
    }


def _effect_data(effect: Effect) -> dict[str, Any]:
    return {
        "node": effect.node,
        "name": effect.name,
        "package": effect.package,
        "message": effect.words,
        "certain": not effect.perhaps,
        **_place(effect.place),
    }


def _place(place: Place | None) -> dict[str, Any]:
    if place is None:
        return {"file": None, "line": None, "column": None}
    return {"file": shown_file(place.file), "line": place.line, "column": place.column}


__all__ = ["render_json"]
