"""What a change breaks, in each format: pictures are those of what depends on it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final

from archlint.render.tracing import picture
from archlint.render.tracing.impact_json import render_json
from archlint.render.tracing.impact_text import render_text

if TYPE_CHECKING:
    from archlint.dataflow.impacts import Impact
    from archlint.render.tracing.picture import Row, Rows


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

__all__ = ["IMPACTS"]
