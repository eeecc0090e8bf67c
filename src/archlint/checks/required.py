"""ARC003: connections that a contract requires and the system does not have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import in_source_order
from archlint.architecture import REQUIRE, Contract, Globs, any_node, matches
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.links import Link, counts, has, is_meant, is_named, launched, links, named
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
)

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

_ENDS = {
    "topic": ((EntityKind.PUBLISHER, "publish"), (EntityKind.SUBSCRIBER, "subscribe to")),
    "service": ((EntityKind.SERVICE, "serve"), (EntityKind.CLIENT, "call")),
    "action": ((EntityKind.ACTION_SERVER, "serve"), (EntityKind.ACTION_CLIENT, "call")),
}
"""By kind of connection: the two kinds of ends, the provider's first, and what a node does there."""


@rule("ARC003", scope=Scope.SYSTEM)
def missing_connection(system: System, options: Options) -> Iterator[Finding]:
    """Contracts whose connection is not there."""
    for contract in options.contracts:
        if contract.kind != REQUIRE or not is_concerned(system, contract):
            continue
        external = any(options.is_external(glob) for glob in contract.patterns)
        if contract.through:
            yield from _around(system, contract, external)
        elif not external:
            missing = _missing_link(system, contract) if contract.source else _missing_end(system, contract)
            if missing is not None:
                yield _finding(contract, f"{missing}, which the contract '{contract.name}' requires")


def _finding(contract: Contract, message: str, *related: Related, identity: tuple[str, ...] = ()) -> Finding:
    return finding(
        "ARC003",
        contract.place,
        message,
        help="add the connection, change the contract, or list a node that is not in this workspace under `external`",
        related=related,
        identity=(contract.name, *identity),
    )


# ------------------------------------------------------------------------------ which systems a contract is about


def is_concerned(system: System, contract: Contract) -> bool:
    """Whether a contract is held against this system.

    One of a launch file may be a part of the robot, and is held to the contract if it has the nodes of each group;
    a closed one, which is all there is, as soon as it has one of them.  The system of all nodes is asked where no
    launch file is, and must have them too where it is only a part of what the configuration is for.
    """
    if system.name is not None or (system.workspace is not None and system.workspace.is_subset):
        return _has_nodes(system, contract)
    return not any(_has_nodes(other, contract) for other in launched(system))


def _has_nodes(system: System, contract: Contract) -> bool:
    groups = [globs for globs in (contract.source, contract.target, contract.provider, contract.user) if globs]
    special = [globs for globs in groups if not any_node(globs)]
    if contract.through:
        return bool(named(system, contract)) and (system.closed or has(system, contract.through))
    if not special:
        return bool(named(system, contract))
    there = [has(system, globs) for globs in special]
    return any(there) or bool(named(system, contract)) if system.closed else all(there)


# ------------------------------------------------------------------------------------------------ what is missing


def _missing_link(system: System, contract: Contract) -> str | None:
    """What is missing between nodes, in words: each ``from`` is to be connected to some ``to``."""
    source, target = " or ".join(contract.source), " or ".join(contract.target)
    starts = [node for node in system.nodes if is_meant(contract.source, node)]
    existing = links(system, contract.source, contract.target)
    reached = {id(link.source.node) for link in existing if link.goes(contract)}
    if not starts:
        return f"there is no node {source} to connect to {target}"
    lost = [node for node in starts if id(node) not in reached and _followed(node)]
    if not lost or not all(_followed(node) for node in system.nodes if is_meant(contract.target, node)):
        return None
    if any(_is_named(contract, end) for end in _of_unknown_nodes(system)):
        return None
    over = f" over {' or '.join(contract.names)}" if contract.names else ""
    return f"there is no connection from {_listed(lost)} to {target}{over}"


def _missing_end(system: System, contract: Contract) -> str | None:
    """What is missing at a topic, service or action, in words: each node that is meant is to be at one that is
    meant, and each of these is to have such a node."""
    if contract.connection is None:
        return None
    for globs, (kind, does) in zip((contract.provider, contract.user), _ENDS[contract.connection], strict=True):
        if globs:
            missing = _end_of_no_node(system, contract, globs, kind, does)
            if missing is not None:
                return missing
    return None


def _end_of_no_node(system: System, contract: Contract, globs: Globs, kind: EntityKind, does: str) -> str | None:
    name = " or ".join(contract.names)
    there = named(system, contract)
    nodes = [node for node in system.nodes if is_meant(globs, node)]
    if any(end.kind == kind and _is_named(contract, end) for end in _of_unknown_nodes(system)):
        return None
    if not any_node(globs):
        if not nodes:
            return f"there is no node {' or '.join(globs)} to {does} {name}"
        doing = {id(end.node) for connection in there for end in _ends(connection, kind)}
        lost = [node for node in nodes if id(node) not in doing and _followed(node, kind)]
        if lost:
            return f"{_listed(lost)} {'does' if len(lost) == 1 else 'do'} not {does} {name}"
    if not all(_followed(node, kind) for node in nodes):
        return None
    if not there:
        return f"there is no node to {does} {name}"
    bare = [connection for connection in there if not any(is_meant(globs, end.node) for end in _ends(connection, kind))]
    return f"there is no node {' or '.join(globs)} to {does} {bare[0].name}" if bare else None


def _listed(nodes: list[Node]) -> str:
    names = sorted({node.shown for node in nodes})
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _ends(connection: Connection, kind: EntityKind) -> list[Endpoint]:
    return [end for end in (*connection.providers, *connection.users) if end.kind == kind and counts(end)]


def _around(system: System, contract: Contract, external: bool) -> Iterator[Finding]:
    """Publishers of a topic whose messages reach somebody else than the node that they must pass, or nobody.

    ``external`` is True where that node is not in this workspace, and nobody knows what it listens to.
    """
    candidates = [link for link in links(system, contract.through) if is_named(contract, link.connection)]
    passing = {id(link.source) for link in candidates if is_meant(contract.through, link.target.node)}
    for topic in named(system, contract):
        for end in in_source_order(end for end in topic.providers if counts(end)):
            if is_meant(contract.through, end.node):
                continue
            past = [
                link for link in candidates if link.source is end and not is_meant(contract.through, link.target.node)
            ]
            if past or not (external or id(end) in passing or not _all_followed(system, contract.through)):
                yield _passes_by(contract, topic, end, past)


def _passes_by(contract: Contract, topic: Connection, end: Endpoint, past: list[Link]) -> Finding:
    through = " or ".join(contract.through)
    reaches = f"and {past[0].target.node.shown} receives it" if past else "which no node there subscribes to"
    return _finding(
        contract,
        f"{end.node.shown} publishes '{topic.name}' {reaches} without passing {through}, which the contract "
        f"'{contract.name}' requires",
        Related(end.place, f"{end.node.shown} publishes it here"),
        *(Related(link.target.place, f"{link.target.node.shown} receives it here") for link in past),
        identity=(topic.name, end.node.name or ""),
    )


def _all_followed(system: System, globs: Globs) -> bool:
    unknown = any(end.kind == EntityKind.SUBSCRIBER for end in _of_unknown_nodes(system))
    return not unknown and all(_followed(node, EntityKind.SUBSCRIBER) for node in system.nodes if is_meant(globs, node))


def _of_unknown_nodes(system: System) -> Iterator[Endpoint]:
    """The endpoints of what is used by an unknown node: any node may be the one."""
    return (end for entry in system.unowned if not entry.test for end in entry.endpoints)


def _is_named(contract: Contract, end: Endpoint) -> bool:
    """Whether an endpoint has, or may have, a name that the contract is about."""
    return not contract.names or end.name is None or not end.resolved or matches(contract.names, end.name)


def _followed(node: Node, kind: EntityKind | None = None) -> bool:
    """Whether everything that a node has is known, so that what is missing is missing."""
    return not node.is_stranger and all(end.resolved for end in node.endpoints if kind in (None, end.kind))
