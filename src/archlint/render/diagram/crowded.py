"""A picture of many lines with fewer of them, in which everything is still said."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.diagram.gathering import is_plain_line, lines_at, shared
from archlint.render.look import UNOWNED, counted
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Collection, Sized

    from archlint.render.diagram.model import Diagram, Key, Line

MANY_LINES = 40
"""Lines up to which a picture is drawn with all of them."""
THINNED = (
    f"more than {MANY_LINES} lines: names at the nodes and lists stand for some, frames that they cross are left out; "
    "--all-lines draws each"
)
"""What the caption says of that."""
MANY_NODES = 8
"""Nodes up to which lines lead to a topic, service or action in a crowded picture."""


def is_crowded(diagram: Diagram) -> bool:
    return len(diagram.lines) > MANY_LINES


def thinned(diagram: Diagram, keep_frames: bool) -> Diagram:
    """A crowded diagram in which a topic, service or action of very many nodes is named at each of them, as a net is in
    the plan of a circuit, those of the same nodes are listed in one shape, and frames that tear it apart are left out;
    any other diagram as it is."""
    if not is_crowded(diagram):
        return diagram
    thin = shared(_named(diagram))
    return thin if keep_frames else _without_torn_frames(thin)


def _without_torn_frames(diagram: Diagram) -> Diagram:
    """Without those that more lines leave than stay inside, or that have one node alone."""
    inside: Counter[str] = Counter()
    for line in diagram.lines:
        titles = {diagram.groups.get(key, "") for key in line.ends}
        inside.update({title: 1 if len(titles) == 1 else -1 for title in titles})
    nodes = Counter(title for key, title in diagram.groups.items() if key[0] == NODE)
    torn = {title for title in diagram.groups.values() if inside[title] < 0 or nodes[title] < 2}
    return replace(diagram, unframed=frozenset(torn - {UNOWNED}))


def _named(diagram: Diagram) -> Diagram:
    shapes, lines = dict(diagram.shapes), dict.fromkeys(diagram.lines)
    named: dict[Key, dict[str, list[Line]]] = {}
    for key, own in lines_at(diagram).items():
        shape = diagram.shapes[key]
        senders = {line.tail for line in own if line.head == key}
        takers = {line.head for line in own if line.tail == key}
        if shape.kind not in ("topic", "service", "action") or len(senders | takers) <= MANY_NODES:
            continue
        plain = [line for line in own if is_plain_line(line)]
        shapes[key] = replace(shape, lines=(*shape.lines, _ends_in_words(senders, takers)))
        for line in plain:
            del lines[line]
            node = line.tail if line.head == key else line.head
            named.setdefault(node, {}).setdefault(shape.title, []).append(line)
    for key, names in named.items():
        shapes[key] = replace(shapes[key], named=tuple(_tie_in_words(key, *name) for name in names.items()))
    return replace(diagram, shapes=shapes, lines=tuple(lines))


def _ends_in_words(senders: Sized, takers: Sized) -> str:
    """``from 2 nodes, to 9 nodes``."""
    sides = (("from", len(senders)), ("to", len(takers)))
    return ", ".join(f"{word} {counted(number, NODE)}" for word, number in sides if number)


def _tie_in_words(node: Key, title: str, lines: Collection[Line]) -> str:
    """``→ /tf`` for a node that sends to it, ``← /tf`` for one that takes from it."""
    ways = {line.tail == node for line in lines}
    arrow = "↔" if len(ways) == 2 else "→" if True in ways else "←"
    condition = ", under a condition" if all(line.stroke == "dotted" for line in lines) else ""
    return f"{arrow} {title}{condition}"


__all__ = ["MANY_LINES", "THINNED", "is_crowded", "thinned"]
