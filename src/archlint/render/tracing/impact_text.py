"""What a change breaks, for a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.text import painted_text
from archlint.render.tracing.words import place_words

if TYPE_CHECKING:
    from archlint.dataflow.consequences import Effect
    from archlint.dataflow.impacts import Impact, Mentioned
    from archlint.dataflow.interface_users import InterfaceUse
    from archlint.render.text import Paint


MOST_ROWS = 100
"""Lines of one section."""
_MORE = "--format json has all of them"


def render_text(impacts: Sequence[Impact], *, color: bool = False) -> str:
    """What depends on a name, for a terminal."""
    paint = partial(painted_text, color)
    return "\n\n".join("\n".join(_block(impact, paint)) for impact in impacts) + "\n"


def _block(impact: Impact, paint: Paint) -> Iterator[str]:
    systems = impact.systems
    others = f" and {counted(len(systems) - 1, 'more launch file')}" if len(systems) > 1 else ""
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


__all__ = ["render_text"]
