"""Connections between nodes as the declared architecture sees them: one link from a sender to a receiver."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import in_source_order
from archlint.architecture import ACTION, SERVICE, TOPIC, Contract, Globs, matches
from archlint.branches import exclusive
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

_DOES = {
    TOPIC: ("publishes", "subscribes to it"),
    SERVICE: ("calls", "serves it"),
    ACTION: ("calls", "serves it"),
}


@dataclass(frozen=True)
class Link:
    """A connection in the direction of the data or the request: from ``source`` to ``target``."""

    connection: Connection
    source: Endpoint
    target: Endpoint

    def words(self) -> str:
        does, answers = _DOES[self.connection.kind]
        kind = "" if self.connection.kind == TOPIC else f"the {self.connection.kind} "
        return f"{self.source.node.shown} {does} {kind}'{self.connection.name}' and {self.target.node.shown} {answers}"

    def goes(self, contract: Contract) -> bool:
        """Whether it leads from a contract's ``from`` to its ``to``, over what the contract names."""
        return (
            is_meant(contract.source, self.source.node)
            and is_meant(contract.target, self.target.node)
            and (not contract.names or is_named(contract, self.connection))
        )


def links(system: System, *groups: Globs) -> Iterator[Link]:
    """Every connection of two nodes of the system that can run together.

    ``groups`` are the nodes that are asked about.  In the system of all nodes, two that some launch file starts
    together count there, under their final names, and not here; unless no launch file has nodes of two groups.
    """
    separately = system.name is None and any(_has_two(other, groups) for other in launched(system))
    for connection in connections(system):
        topic = connection.kind == TOPIC
        sources = connection.providers if topic else connection.users
        targets = connection.users if topic else connection.providers
        for source in in_source_order(end for end in sources if counts(end)):
            for target in in_source_order(end for end in targets if counts(end)):
                if source.node is target.node or not _may_coexist(source, target):
                    continue
                if not separately or not system.in_same_launch(source.node, target.node):
                    yield Link(connection, source, target)


def _may_coexist(end: Endpoint, other: Endpoint) -> bool:
    return (
        end.node.domain == other.node.domain
        and not exclusive(end.node.alternatives, other.node.alternatives)
        and not exclusive(end.creation.branch_arms, other.creation.branch_arms)
        and end.node.name != other.node.name
    )


def connections(system: System) -> tuple[Connection, ...]:
    return (*system.topics.values(), *system.services.values(), *system.actions.values())


def named(system: System, contract: Contract) -> list[Connection]:
    """The connections that a contract is about by their names."""
    return [connection for connection in connections(system) if is_named(contract, connection)]


def is_named(contract: Contract, connection: Connection) -> bool:
    return connection.kind == contract.connection and matches(contract.names, connection.name)


def counts(end: Endpoint) -> bool:
    """Whether an endpoint is one of a running system, and not of a test."""
    return end.node.name is not None and not end.node.test and not end.creation.destroyed


def is_meant(globs: Globs, node: Node) -> bool:
    return node.name is not None and not node.test and matches(globs, node.name, node.package)


def has(system: System, globs: Globs) -> bool:
    """Whether a system has a node that is meant."""
    return any(is_meant(globs, node) for node in system.nodes)


def _has_two(system: System, groups: Iterable[Globs]) -> bool:
    return sum(has(system, globs) for globs in groups) > 1


def launched(system: System) -> list[System]:
    """The systems of launch files that are judged beside this one."""
    return [] if system.workspace is None else [other for other in system.workspace.systems if other.name is not None]


def by_source(all_links: Iterable[Link]) -> list[list[Link]]:
    """Links in groups of one sending endpoint."""
    groups: dict[int, list[Link]] = {}
    for link in all_links:
        groups.setdefault(id(link.source), []).append(link)
    return list(groups.values())
