"""What a change breaks, for a terminal, as data and as pictures of what depends on it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from archlint.json_text import json_text
from archlint.render import look
from archlint.render.json import shown_file
from archlint.render.text import painted_text
from archlint.render.tracing import picture
from archlint.render.tracing.words import place_words

if TYPE_CHECKING:
    from archlint.dataflow.consequences import Effect
    from archlint.dataflow.impacts import Impact, Mentioned
    from archlint.dataflow.interface_users import InterfaceUse
    from archlint.place import Place
    from archlint.render.text import Paint
    from archlint.render.tracing.picture import Row, Rows

VERSION = 1
MOST_ROWS = 100
"""Lines of one section."""
_MORE = "--format json has all of them"


def render_text(impacts: Sequence[Impact], *, color: bool = False) -> str:
    """What depends on a name, for a terminal."""
    paint = partial(painted_text, color)
    return "\n\n".join("\n".join(_block(impact, paint)) for impact in impacts) + "\n"


def _block(impact: Impact, paint: Paint) -> Iterator[str]:
    systems = impact.systems
    others = f" and {look.counted(len(systems) - 1, 'more launch file')}" if len(systems) > 1 else ""
    where = f"  {paint(systems[0] + others, 'quiet')}" if systems else ""
    yield f"{paint(impact.kind, 'plain')}  {paint(impact.name, 'name')}{where}"
    sections: list[tuple[str, list[str]]] = [
        ("used by", [_effect(effect, paint) for effect in impact.direct]),
        ("depends on it through callbacks", [_effect(effect, paint) for effect in impact.further]),
        ("used at", [_use(use, paint) for use in impact.uses]),
        ("in launch files", [_mentioned(row, paint) for row in impact.launch_files]),
        ("in parameter files", [_mentioned(row, paint) for row in impact.parameter_files]),
        ("packages to build and test again", [paint(package, "plain") for package in impact.packages]),
    ]
    for title, rows in sections:
        if rows:
            yield paint(title, "title")
            yield from (f"  {row}" for row in rows[:MOST_ROWS])
            if len(rows) > MOST_ROWS:
                yield f"  {paint(f'… and {len(rows) - MOST_ROWS} more: {_MORE}', 'quiet')}"
    if not any(rows for _, rows in sections[:3]):
        yield f"  {paint('nothing here uses it', 'quiet')}"


def _effect(effect: Effect, paint: Paint) -> str:
    is_connection = effect.node is None
    words = [paint(effect.name if is_connection else effect.node or "?", "name" if is_connection else "node")]
    if not is_connection and not effect.name.startswith("/"):
        words.append(paint(effect.name, "name"))
    words.append(paint(("perhaps: " if effect.perhaps else "") + effect.words, "alarm" if effect.perhaps else "plain"))
    place = "" if effect.place is None else f"  {paint(place_words(effect.place), 'quiet')}"
    return "  ".join(words) + place


def _use(use: InterfaceUse, paint: Paint) -> str:
    return f"{paint(use.words, 'plain')}  {paint(place_words(use.place), 'quiet')}"


def _mentioned(row: Mentioned, paint: Paint) -> str:
    return f"{paint(row.words, 'plain')}  {paint(place_words(row.place), 'quiet')}"


# ------------------------------------------------------------------------------------------------ as data


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


# ---------------------------------------------------------------------------------------------- pictures


def _rows(impacts: Sequence[Impact]) -> Rows:
    """What depends on a name in each system: only pictures that differ, and a few."""
    unlike: dict[str, Row] = {}
    for impact in impacts:
        for flow, steps, asked in impact.drawn:
            shown = {id(step) for step in steps}
            links = [link for link in flow.links if id(link.tail) in shown and id(link.head) in shown]
            row = flow, steps, links, asked
            unlike.setdefault(picture.mermaid([row]), row)
    return list(unlike.values())[:_MOST_PICTURES]


_MOST_PICTURES = 4

IMPACTS: Final[Mapping[str, Callable[[str, Sequence[Impact], bool], str]]] = {
    "text": lambda name, impacts, color: render_text(impacts, color=color),
    "json": lambda name, impacts, color: render_json(name, impacts),
    "mermaid": lambda name, impacts, color: picture.mermaid(_rows(impacts)),
    "dot": lambda name, impacts, color: picture.dot(_rows(impacts)),
    "svg": lambda name, impacts, color: picture.svg(_rows(impacts)),
}

__all__ = ["IMPACTS", "render_json", "render_text"]
