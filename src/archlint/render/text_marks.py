"""What a view shows of a system, and what is remarkable there, in words for a terminal."""

from __future__ import annotations

from collections.abc import Sequence, Set
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.render.diagram.choosing import network_of
from archlint.render.diagram.making import marked_whole
from archlint.render.selection import selected
from archlint.systems.graph import node_keys

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.render.diagram.model import Diagram, Key
    from archlint.render.view import View
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


@dataclass(frozen=True)
class Marks:
    """The ``keys`` that are shown, and the picture of the whole system with its marks."""

    keys: Set[Key]
    whole: Diagram
    nodes: dict[tuple[str | None, object], Key]

    def of(self, key: Key) -> list[str]:
        """What is remarkable of a thing, and the codes of what was found there or at its ends."""
        shape = self.whole.shapes.get(key)
        if shape is None:
            return []
        lines = [line for line in self.whole.lines if line.tail == key or line.head == key] if key[0] != "node" else []
        codes = [badge.text for badge in (*shape.badges, *(badge for line in lines for badge in line.badges))]
        return [*shape.remarks, *([", ".join(dict.fromkeys(codes))] if codes else [])]

    def of_node(self, node: Node) -> list[str]:
        return self.of(self.nodes[_identity(node)])


def marks_of(system: System, view: View, findings: Sequence[Finding]) -> Marks:
    """Raises :class:`archlint.render.selection.NothingOfThatName`."""
    whole = marked_whole(system, findings)
    keys = node_keys(system)
    return Marks(
        selected(network_of(whole), view),
        whole,
        {_identity(node): keys[id(node)] for node in system.drawn},
    )


def _identity(node: Node) -> tuple[str | None, object]:
    """The same for a node and for what is shown of it."""
    return node.name, node.launch_place if node.blueprint is None else id(node.blueprint)


__all__ = ["Marks", "marks_of"]
