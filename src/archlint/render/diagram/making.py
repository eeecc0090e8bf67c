"""From a system to the picture that a view asks for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.finding import Severity
from archlint.render.diagram.boxes import boxes_alone
from archlint.render.diagram.captions import captioned, pattern_words
from archlint.render.diagram.choosing import chosen
from archlint.render.diagram.crowded import THINNED, thinned
from archlint.render.diagram.findings import attached
from archlint.render.diagram.gathering import gathered, without_single_nodes
from archlint.render.diagram.large import OPENED, in_groups
from archlint.render.diagram.marks import marked
from archlint.render.diagram.parts import parts_of
from archlint.render.diagram.styles import nodes_alone
from archlint.render.picture import graph_of
from archlint.render.view import WHOLE, View

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.render.diagram.model import Diagram
    from archlint.systems.model import System

EACH_NODE = 1500
"""Shapes up to which each is drawn; beyond, one box stands for each package or namespace."""


def diagram_of(system: System, view: View = WHOLE, findings: Sequence[Finding] = ()) -> Diagram:
    """Parts of the whole system, marks on them, what of it is shown, how it is grouped and gathered, what it says.

    Raises :class:`archlint.render.selection.NothingOfThatName`.
    """
    whole = marked_whole(system, findings)
    diagram = chosen(whole, view)
    if view.style == "nodes":
        diagram = nodes_alone(diagram)
    diagram, boxed = in_groups(diagram, view)
    words = [*([OPENED] if boxed else []), *pattern_words(system)]
    if len(diagram.shapes) > EACH_NODE and diagram.groups:
        diagram = boxes_alone(diagram)
        words.insert(0, f"more than {EACH_NODE} shapes, too many to draw each: --only and --focus draw a part")
    else:
        plain = gathered(diagram)
        diagram = plain if view.every_line else thinned(plain, keep_frames=view.group is not None)
        if diagram != plain:
            words.insert(0, THINNED)
        diagram = without_single_nodes(diagram)
    return captioned(diagram, whole, words, system.compared is not None)


def marked_whole(system: System, findings: Sequence[Finding]) -> Diagram:
    """All of a system with its marks; what is only informative has none."""
    graph = graph_of(system)
    shown = [finding for finding in findings if finding.severity > Severity.INFO]
    return marked(parts_of(system, graph), system, attached(graph, shown))


__all__ = ["diagram_of", "marked_whole"]
