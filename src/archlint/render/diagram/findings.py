"""Where in a picture a finding belongs: on an end, on what several ends share, or on a node."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.systems.graph import NODE

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import networkx

    from archlint.finding import Finding, Place
    from archlint.render.diagram.model import Key
    from archlint.systems.nodes import Node

Ends = tuple["Key", "Key"]
_MOST_LINES = 2
"""With more lines at one interface, the one that a finding is about has the badge itself."""


@dataclass
class Attached:
    """Findings by what of a picture they are about."""

    shapes: dict[Key, list[Finding]] = field(default_factory=dict)
    lines: dict[Ends, list[Finding]] = field(default_factory=dict)


def attached(graph: networkx.MultiDiGraph, findings: Iterable[Finding]) -> Attached:
    """The findings with a place in the picture.  A finding is about an end where it is reported at the call that
    creates it, and about what ends share where its places are those of several."""
    lines_at = _lines_at(graph)
    files = _nodes_by_file(graph)
    attached = Attached()
    for finding in findings:
        places = [finding.place, *(related.place for related in finding.related)]
        own = _of_node(graph, finding, lines_at.get(_where(finding.place), []))
        every = [line for place in places for line in lines_at.get(_where(place), [])]
        shared = {_interface(line) for line in every}
        if own and (len({_node(line) for line in every if _interface(line) in shared}) > 1 or _is_small(graph, own)):
            attached.shapes.setdefault(_interface(own[0]), []).append(finding)
        elif own:
            attached.lines.setdefault(own[0], []).append(finding)
        else:
            for key in _nodes(files, graph, finding):
                attached.shapes.setdefault(key, []).append(finding)
    _share(attached)
    return attached


def _share(attached: Attached) -> None:
    """What a rule finds at several lines of an interface is said once, at the interface."""
    lines_with: dict[tuple[Key, str], list[Ends]] = {}
    for line, findings in attached.lines.items():
        for code in dict.fromkeys(finding.code for finding in findings):
            lines_with.setdefault((_interface(line), code), []).append(line)
    for (interface, code), lines in lines_with.items():
        for line in lines if len(lines) > 1 else ():
            shared = [finding for finding in attached.lines[line] if finding.code == code]
            attached.lines[line] = [finding for finding in attached.lines[line] if finding.code != code]
            attached.shapes.setdefault(interface, []).extend(shared)


def _is_small(graph: networkx.MultiDiGraph, lines: Sequence[Ends]) -> bool:
    interface = _interface(lines[0])
    return len({*graph.predecessors(interface), *graph.successors(interface)}) <= _MOST_LINES


def _where(place: Place) -> tuple[str, int]:
    return place.file, place.line


def _interface(line: Ends) -> Key:
    return line[1] if line[0][0] == NODE else line[0]


def _node(line: Ends) -> Key:
    return line[0] if line[0][0] == NODE else line[1]


def _lines_at(graph: networkx.MultiDiGraph) -> dict[tuple[str, int], list[Ends]]:
    """The lines of the ends that are created at a place."""
    lines: dict[tuple[str, int], list[Ends]] = {}
    for tail, head, edge in graph.edges(data=True):
        lines.setdefault(_where(edge["endpoint"].place), []).append((tail, head))
    return lines


def _of_node(graph: networkx.MultiDiGraph, finding: Finding, lines: list[Ends]) -> list[Ends]:
    """The lines at the place of a finding, of the node that it names where it names one of theirs."""
    named = [line for line in lines if graph.nodes[_node(line)]["name"] == finding.node]
    return named or lines


def _nodes_by_file(graph: networkx.MultiDiGraph) -> dict[str, list[tuple[Key, Node]]]:
    files: dict[str, list[tuple[Key, Node]]] = {}
    for key, data in graph.nodes(data=True):
        if data["kind"] == NODE and data["node"].blueprint is not None:
            files.setdefault(data["node"].blueprint.place.file, []).append((key, data["node"]))
    return files


def _nodes(files: dict[str, list[tuple[Key, Node]]], graph: networkx.MultiDiGraph, finding: Finding) -> list[Key]:
    """The node that a finding names, or else the one whose class is the last to begin above it in its file."""
    if finding.node is not None and (NODE, finding.node) in graph:
        return [(NODE, finding.node)]
    above = [
        (node.blueprint.place.line, key)
        for key, node in files.get(finding.place.file, [])
        if node.blueprint is not None and node.blueprint.place.line <= finding.place.line
    ]
    last = max((line for line, _ in above), default=0)
    return [key for line, key in above if line == last][:1]


__all__ = ["attached"]
