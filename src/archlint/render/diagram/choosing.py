"""A picture without what a view leaves out."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.render.selection import Network, selected
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from archlint.render.diagram.model import Diagram, Key
    from archlint.render.view import View


def network_of(diagram: Diagram) -> Network:
    """Who is tied to what in a picture of a whole system."""
    ties: dict[Key, dict[Key, None]] = {key: {} for key in diagram.shapes}
    for line in diagram.lines:
        ties[line.tail][line.head] = None
        ties[line.head][line.tail] = None
    matched = frozenset(key for key, shape in diagram.shapes.items() if shape.matched and key[0] != NODE)
    return Network({key: tuple(around) for key, around in ties.items()}, matched)


def chosen(diagram: Diagram, view: View) -> Diagram:
    """What the view selects.  Raises :class:`archlint.render.selection.NothingOfThatName`."""
    return only(diagram, selected(network_of(diagram), view))


def only(diagram: Diagram, keys: Set[Key]) -> Diagram:
    """The diagram with some of its shapes, and the lines between these."""
    return replace(
        diagram,
        shapes={key: shape for key, shape in diagram.shapes.items() if key in keys},
        lines=tuple(line for line in diagram.lines if line.tail in keys and line.head in keys),
        groups={key: title for key, title in diagram.groups.items() if key in keys},
    )


__all__ = ["chosen", "network_of", "only"]
