"""OWN001 and OWN002: a name that more than one node publishes or serves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.checks.conflicts import in_source_order, meeting
from archlint.checks.registry import Options, finding, rule
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.system.model import Connection, Endpoint, System

SHARED_BY_DESIGN = ("/tf", "/tf_static", "/rosout", "/parameter_events", "/diagnostics", "/joint_states")


@rule("OWN001")
def multiple_publishers(system: System, options: Options) -> Iterator[Finding]:
    """Topics with publishers in several nodes that run together."""
    for connection in system.topics.values():
        if connection.name in SHARED_BY_DESIGN or options.is_shared(connection.name):
            continue
        for owners in _several_owners(system, connection):
            yield _finding(
                "OWN001",
                owners,
                f"{_nodes(owners)} all publish the topic '{connection.name}'"
                if _count(owners) > 2
                else f"{_nodes(owners)} both publish the topic '{connection.name}'",
                "publishes it here",
                "let one node own the topic: give each source a topic of its own and let one node decide, or "
                "list the topic under shared-topics if it is meant to be shared",
            )


@rule("OWN002")
def multiple_servers(system: System, options: Options) -> Iterator[Finding]:
    """Services and actions with servers in several nodes that run together."""
    for connection in (*system.services.values(), *system.actions.values()):
        for owners in _several_owners(system, connection):
            both = "all" if _count(owners) > 2 else "both"
            yield _finding(
                "OWN002",
                owners,
                f"{_nodes(owners)} {both} serve the {connection.kind} '{connection.name}': "
                "a request reaches each of them",
                "serves it here",
                "give each server a name of its own; a private name ('~/…') puts the node's name in front",
            )


def _several_owners(system: System, connection: Connection) -> Iterator[list[Endpoint]]:
    """Groups of endpoints of different nodes that meet; the last one in the source comes last."""
    groups: list[list[Endpoint]] = []
    for one, other in meeting(system, connection.providers):
        if one.node is other.node:
            continue
        group = next((g for g in groups if one in g or other in g), None)
        if group is None:
            groups.append([one, other])
        else:
            group.extend(e for e in (one, other) if e not in group)
    for group in groups:
        yield in_source_order(group)


def _finding(code: str, owners: list[Endpoint], message: str, does: str, help: str) -> Finding:
    last, others = owners[-1], owners[:-1]
    return finding(
        code,
        last.place,
        message,
        help=help,
        related=[Related(e.place, f"{e.node.name} {does}") for e in others],
        node=last.node.name,
        identity=(last.kind, last.name or "", *sorted({e.node.name or "" for e in owners})),
    )


def _names(owners: Iterable[Endpoint]) -> list[str]:
    return sorted({endpoint.node.name or "" for endpoint in owners})


def _count(owners: Iterable[Endpoint]) -> int:
    return len(_names(owners))


def _nodes(owners: Iterable[Endpoint]) -> str:
    *most, last = _names(owners)
    return f"{', '.join(most)} and {last}" if most else f"several nodes called {last}"
