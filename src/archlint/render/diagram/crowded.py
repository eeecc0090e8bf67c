"""A picture of many lines with fewer of them, in which everything is still said.

Each step takes away no more than is too much, what saves most lines first, so that a node more changes little.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.diagram.gathering import enough, shared
from archlint.render.diagram.naming import SEVERAL_NODES, busy_named, loose_named
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from archlint.render.diagram.model import Diagram, Line

MANY_LINES = 40
"""Lines up to which a picture is drawn with all of them."""
THINNED = (
    f"more than {MANY_LINES} lines: names in nodes and lists stand for some, frames that they cross are left out; "
    "--all-lines draws each"
)
"""What the caption says of that."""


def thinned(diagram: Diagram, keep_frames: bool) -> Diagram:
    """A crowded diagram in which a topic, service or action of very many nodes is named in each of them, as a net is in
    the plan of a circuit, and so is what has nothing at its other end; those of the same nodes are listed in one shape,
    and frames that tear it apart are left out; any other diagram as it is."""
    thin = _without_words(diagram, _too_many(diagram))
    for step in (busy_named, loose_named, shared):
        thin = step(thin, _too_many(thin))
    thin = busy_named(thin, _too_many(thin), SEVERAL_NODES)
    return thin if keep_frames else _without_torn_frames(thin, _too_many(diagram))


def _too_many(diagram: Diagram) -> int:
    return len(diagram.lines) - MANY_LINES


def _without_words(diagram: Diagram, most: int) -> Diagram:
    """Without what is said of quality of service on lines, on as many of them as are too many."""
    worded = Counter(line.tail for line in diagram.lines if _has_words(line))
    silent = {*enough(worded, most)}
    lines = (replace(line, labels=()) if _has_words(line) and line.tail in silent else line for line in diagram.lines)
    return replace(diagram, lines=tuple(lines))


def _has_words(line: Line) -> bool:
    """Not those of a line from node to node, which is worth nothing without."""
    return bool(line.labels) and not line.differs and line.tail[0] != NODE


def _without_torn_frames(diagram: Diagram, most: int) -> Diagram:
    """Without those that more lines leave than stay inside, or that have one node alone."""
    inside: Counter[str] = Counter()
    for line in diagram.lines:
        titles = {diagram.groups.get(key, "") for key in line.ends}
        inside.update({title: 1 if len(titles) == 1 else -1 for title in titles})
    nodes = Counter(title for key, title in diagram.groups.items() if key[0] == NODE)
    titles = {*diagram.groups.values()}
    torn = {title: max(1, -inside[title]) for title in titles if inside[title] < 0 or nodes[title] < 2}
    return replace(diagram, unframed=frozenset(enough(torn, most)))


__all__ = ["MANY_LINES", "THINNED", "thinned"]
