"""SRV006: service handlers that wait for each other in a circle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.reach import one_for_each_place
from archlint.checks.circle_search import Key, circles
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.start_circles import start_circles
from archlint.execution.waits import Wait, waits
from archlint.finding import Finding, Related
from archlint.model import SERVER_OF, EntityKind, Role
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

_HANDLES = {Role.SERVICE: EntityKind.SERVICE, Role.EXECUTE: EntityKind.ACTION_SERVER}


@dataclass(frozen=True)
class Edge:
    """The handler of one server waits for another."""

    server: Endpoint
    target: Key
    wait: Wait


def waits_behind(system: System, wait: Wait) -> list[Edge]:
    """What the handler waits for, in its turn, that a wait of another handler asks."""
    edges = waits_of_handlers(system)
    return [
        behind
        for edge in _edges_of_waits(system).get(id(wait), ())
        for behind in edges.get(edge.target, ())
        if behind.wait.call.context is not wait.call.context
        and _may_coexist(system, behind.server.node, edge.server.node)
    ]


@once
def _edges_of_waits(system: System) -> dict[int, list[Edge]]:
    """What a handler asks, for each wait of one."""
    edges: dict[int, list[Edge]] = {}
    for row in waits_of_handlers(system).values():
        for edge in row:
            edges.setdefault(id(edge.wait), []).append(edge)
    return edges


def _may_coexist(system: System, node: Node, other: Node) -> bool:
    return system.may_coexist(node, other) or system.in_same_launch(node, other)


@rule("SRV006", scope=Scope.SYSTEM)
def service_call_cycle(system: System, options: Options) -> Iterator[Finding]:
    """Circles of handlers, and of nodes at their start, each of which waits for the next."""
    edges = waits_of_handlers(system)
    yield from one_for_each_place([_circle(circle) for circle in circles(edges, system, _servers_of)])
    yield from one_for_each_place(start_circles(system))


def _servers_of(circle: Sequence[Edge]) -> frozenset[object]:
    return frozenset((edge.server.kind, edge.server.name or "") for edge in circle)


@once
def waits_of_handlers(system: System) -> dict[Key, list[Edge]]:
    """For each server, by kind and full name, the servers that its handler waits for."""
    ends = {id(end.creation): end for end in system.endpoints if end.resolved and not end.node.test}
    edges: dict[Key, list[Edge]] = {}
    for wait in waits(system):
        handler = wait.call.context
        kind = _HANDLES.get(handler.role)
        server = ends.get(id(handler.creation))
        client = ends.get(id(wait.client))
        if kind is None or server is None or client is None or server.name is None or client.name is None:
            continue
        edge = Edge(server, (SERVER_OF[client.kind], client.name), wait)
        edges.setdefault((kind, server.name), []).append(edge)
    return edges


def _circle(circle: list[Edge]) -> Finding:
    ordered = sorted(circle, key=lambda edge: edge.wait.call.place)
    last = ordered[-1]
    at = circle.index(last)
    turned = circle[at + 1 :] + circle[: at + 1]
    names = [edge.server.name or "" for edge in (turned[-1], *turned)]
    path = " → ".join([names[0], *(edge.target[1] for edge in [turned[-1], *turned[:-1]])])
    alone = len(circle) == 1
    limited = any(edge.wait.limited for edge in circle)
    end = "all of them time out" if limited else "none of them ever responds"
    return finding(
        "SRV006",
        last.wait.call.place,
        f"the handler of {names[0]} waits for {names[0] if alone else last.target[1]}"
        + (", which it serves itself" if alone else f", which closes a circle: {path}")
        + f": {end}",
        help="let one of them publish the data that the others request",
        related=[
            Related(edge.wait.call.place, f"the handler of {edge.server.name} waits for {edge.target[1]}")
            for edge in ordered
        ],
        node=last.server.node.name,
        identity=tuple(sorted(names[1:])),
    )
