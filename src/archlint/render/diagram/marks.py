"""Marks on a picture of a whole system: findings where they are, and what its shape says of single nodes."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.diagram.model import Badge
from archlint.systems.graph import NODE, node_keys
from archlint.systems.pattern import HUB, figures
from archlint.systems.shape import splits
from archlint.visible import visible

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from archlint.finding import Finding
    from archlint.render.diagram.findings import Attached
    from archlint.render.diagram.model import Diagram, Key, Line
    from archlint.systems.model import System
    from archlint.systems.pattern import Figures, Hub

OWNERS: Mapping[str, str] = {"OWN001": "publishers", "OWN002": "servers"}
"""The rules about names with several owners, and what the owners are."""
_FEWEST = 4
"""Other nodes that a hub is tied to at least, where the whole system is not one of hub and spokes."""
_SHARE = 0.25
"""And the share of all other connected nodes."""


def marked(diagram: Diagram, system: System, at: Attached) -> Diagram:
    """The diagram with badges, hubs, single points of failure and circles of requests."""
    remarks = _remarks(diagram, system, at.shapes)
    circles = _circles(diagram.lines)
    shapes = {
        key: replace(shape, badges=badges_of(at.shapes.get(key, ())), remarks=tuple(remarks.get(key, ())))
        for key, shape in diagram.shapes.items()
    }
    lines = tuple(
        replace(line, badges=badges_of(at.lines.get(line.ends, ())), cycle=line.ends in circles)
        for line in diagram.lines
    )
    return replace(diagram, shapes=shapes, lines=lines)


def badges_of(findings: Iterable[Finding]) -> tuple[Badge, ...]:
    """One for each rule, the most severe first."""
    by_code: dict[str, list[Finding]] = {}
    for finding in findings:
        by_code.setdefault(finding.code, []).append(finding)
    order = sorted(by_code, key=lambda code: (-max(f.severity for f in by_code[code]), code))
    return tuple(
        Badge(
            code,
            max(finding.severity for finding in by_code[code]).label,
            tuple(visible(finding.message) for finding in by_code[code]),
        )
        for code in order
    )


def _remarks(diagram: Diagram, system: System, findings: Mapping[Key, Sequence[Finding]]) -> dict[Key, list[str]]:
    keys = {id(node): key for node, key in zip(system.drawn, node_keys(system).values(), strict=True)}
    by_name = {node.name: keys[id(node)] for node in system.nodes if node.name is not None}
    remarks: dict[Key, list[str]] = {}
    for hub in _hubs(figures(system)):
        if hub.node in by_name:
            remarks.setdefault(by_name[hub.node], []).append(f"hub: {hub.fan_in} in, {hub.fan_out} out")
    for node, parts in splits(system):
        if len(parts[0]) > 1:  # where single nodes are left, it is the hub of a small system
            remarks.setdefault(keys[id(node)], []).append(f"single point of failure: {len(parts)} parts without it")
    for key, told in findings.items():
        owned = next((OWNERS[finding.code] for finding in told if finding.code in OWNERS), None)
        if owned is not None and key[0] != NODE:
            remarks.setdefault(key, []).append(f"{_owners(diagram, key, owned)} {owned}")
    return remarks


def _hubs(figures: Figures) -> list[Hub]:
    """The centre of a hub with its spokes; else the nodes that many others are tied to."""
    if figures.pattern == HUB:
        return [*figures.hubs[:1]]
    least = max(_FEWEST, _SHARE * (figures.connected - 1))
    return [hub for hub in figures.hubs if max(hub.fan_in, hub.fan_out) >= least]


def _owners(diagram: Diagram, key: Key, owned: str) -> int:
    """How many nodes publish a topic, or serve."""
    if owned == OWNERS["OWN001"]:
        return sum(line.head == key for line in diagram.lines)
    return sum(line.tail == key for line in diagram.lines)


def _circles(lines: Iterable[Line]) -> set[tuple[Key, Key]]:
    """The lines of requests that lead back to the node that they come from, over other nodes."""
    import networkx

    requests = networkx.DiGraph(line.ends for line in lines if line.kind != "topic" and line.directed)
    parts = (part for part in networkx.strongly_connected_components(requests))
    circle = {
        key: number for number, part in enumerate(parts) if sum(key[0] == NODE for key in part) > 1 for key in part
    }
    return {ends for ends in requests.edges if ends[0] in circle and circle[ends[0]] == circle.get(ends[1])}


def summary(findings: Sequence[Finding]) -> str:
    """``2 errors, 3 warnings``; empty for none."""
    severities = Counter(finding.severity.label for finding in findings)
    return ", ".join(counted(severities[label], label) for label in ("error", "warning") if severities[label])


__all__ = ["badges_of", "marked", "summary"]
