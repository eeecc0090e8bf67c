"""OWN003 and ARC001 to ARC003: the system against the architecture that the configuration declares."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.architecture import FORBID, INDEPENDENT, REQUIRE, TYPES, Contract, Globs, matches
from archlint.checks.conflicts import in_source_order
from archlint.checks.registry import Options, finding, rule
from archlint.finding import Finding, Related
from archlint.program.model import PUBLISHER, SUBSCRIBER
from archlint.system.model import exclusive

if TYPE_CHECKING:
    from archlint.system.model import Connection, Endpoint, Node, System

_DOES = {
    "topic": ("publishes", "subscribes to it"),
    "service": ("calls", "serves it"),
    "action": ("calls", "serves it"),
}


@dataclass(frozen=True)
class Link:
    """A connection in the direction of the data or the request: from ``source`` to ``target``."""

    connection: Connection
    source: Endpoint
    target: Endpoint

    def words(self) -> str:
        does, answers = _DOES[self.connection.kind]
        kind = "" if self.connection.kind == "topic" else f"the {self.connection.kind} "
        return f"{self.source.node.name} {does} {kind}'{self.connection.name}' and {self.target.node.name} {answers}"


def links(system: System) -> Iterator[Link]:
    """Every connection of two nodes of the system that can run together."""
    for connection in (*system.topics.values(), *system.services.values(), *system.actions.values()):
        topic = connection.kind == "topic"
        sources = connection.providers if topic else connection.users
        targets = connection.users if topic else connection.providers
        for source in in_source_order(end for end in sources if _counts(end)):
            for target in in_source_order(end for end in targets if _counts(end)):
                if source.node is not target.node and _meet(system, source, target):
                    yield Link(connection, source, target)


def _counts(end: Endpoint) -> bool:
    return end.node.name is not None and not end.node.test and not end.creation.destroyed


def _meet(system: System, one: Endpoint, other: Endpoint) -> bool:
    return (
        not exclusive(one.node.alternatives, other.node.alternatives)
        and not exclusive(one.creation.arms, other.creation.arms)
        and one.node.name != other.node.name
        and _judged_here(system, one.node, other.node)
    )


def _judged_here(system: System, one: Node, other: Node) -> bool:
    """False in the system of all nodes where a launch file's own system has the two under their final names."""
    return system.name is not None or system.together(one, other) or not system.apart


# ---------------------------------------------------------------------------------------------- the rules


@rule("OWN003")
def not_the_declared_owner(system: System, options: Options) -> Iterator[Finding]:
    """Publishers and servers of names that the configuration gives to another node."""
    for connection in (*system.topics.values(), *system.services.values(), *system.actions.values()):
        declared = [name for name in options.owners if fnmatchcase(connection.name, name)]
        # The more specific declaration counts: the name itself before a glob.
        declared.sort(key=lambda name: (name != connection.name, -len(name), name))
        if not declared:
            continue
        owners = options.owners[declared[0]]
        for end in in_source_order(end for end in connection.providers if _counts(end)):
            if not _is(owners, end.node):
                yield _not_the_owner(connection, end, owners)


def _not_the_owner(connection: Connection, end: Endpoint, owners: Globs) -> Finding:
    does = "publishes" if end.kind == PUBLISHER else "serves"
    others = [other for other in connection.providers if _counts(other) and _is(owners, other.node)]
    return finding(
        "OWN003",
        end.place,
        f"{end.node.name} {does} '{connection.name}', which belongs to {' or '.join(owners)}",
        help=f"let the owner {does.removesuffix('es')} it and send it what this node has to say, or name this node "
        "under [owners]"
        if does == "publishes"
        else "let the owner serve it, or name this node under [owners]",
        related=[Related(other.place, f"{other.node.name}, the owner, {does} it here") for other in others],
        node=end.node.name,
        identity=(end.kind, connection.name, end.node.name or ""),
    )


@rule("ARC001")
def forbidden_connection(system: System, options: Options) -> Iterator[Finding]:
    """Connections that a contract rules out, one finding for each end and contract."""
    for contract in options.contracts:
        if contract.kind == FORBID:
            chosen = [one for one in links(system) if _goes(contract.source, contract.target, one)]
            yield from _broken(contract, chosen)
        elif contract.kind == INDEPENDENT:
            yield from _broken(contract, [one for one in links(system) if _ties(contract.nodes, one)])
        elif contract.kind == TYPES:
            yield from _other_types(system, contract)


def _goes(source: Globs, target: Globs, link: Link) -> bool:
    return _is(source, link.source.node) and _is(target, link.target.node)


def _ties(groups: Globs, link: Link) -> bool:
    """Whether a connection leads from one of the groups into another."""
    mine = {glob for glob in groups if _is((glob,), link.source.node)}
    yours = {glob for glob in groups if _is((glob,), link.target.node)}
    return bool(mine) and bool(yours) and mine.isdisjoint(yours)


def _broken(contract: Contract, chosen: Iterable[Link]) -> Iterator[Finding]:
    by_source: dict[int, list[Link]] = {}
    for link in chosen:
        by_source.setdefault(id(link.source), []).append(link)
    for found in by_source.values():
        source = found[0].source
        yield finding(
            "ARC001",
            source.place,
            f"{found[0].words()}, which the contract '{contract.name}' forbids",
            help="take the way that the architecture means: through a node in between, or change the contract",
            related=[
                *(Related(link.target.place, f"{link.target.node.name} is at the other end") for link in found),
                Related(contract.place, "the contract is here"),
            ],
            node=source.node.name,
            identity=(contract.name, source.name or "", source.node.name or ""),
        )


def _other_types(system: System, contract: Contract) -> Iterator[Finding]:
    for topic in system.topics.values():
        if not matches(contract.topic, topic.name):
            continue
        for end in in_source_order((*topic.providers, *topic.users)):
            if end.type is None or not _counts(end) or any(fnmatchcase(end.type, glob) for glob in contract.types):
                continue
            yield finding(
                "ARC001",
                end.place,
                f"{end.node.name} uses '{topic.name}' as {end.type}; the contract '{contract.name}' allows "
                f"{' or '.join(contract.types)}",
                help="use the type that the contract allows, or change the contract",
                related=[Related(contract.place, "the contract is here")],
                node=end.node.name,
                identity=(contract.name, topic.name, end.node.name or ""),
            )


@rule("ARC002")
def layer_violation(system: System, options: Options) -> Iterator[Finding]:
    """Connections between nodes of layers that are not neighbours."""
    layers = options.layers
    if layers is None:
        return
    by_source: dict[int, list[Link]] = {}
    for link in links(system):
        mine = layers.of(link.source.node.name or "", link.source.node.package)
        yours = layers.of(link.target.node.name or "", link.target.node.package)
        if mine and yours and all(abs(here - there) > 1 for here in mine for there in yours):
            by_source.setdefault(id(link.source), []).append(link)
    for found in by_source.values():
        source, target = found[0].source, found[0].target
        high = layers.order[layers.of(source.node.name or "", source.node.package)[0]]
        low = layers.order[layers.of(target.node.name or "", target.node.package)[0]]
        yield finding(
            "ARC002",
            source.place,
            f"{found[0].words()}: the layers '{high}' and '{low}' are not neighbours",
            help="go through a node of the layer in between",
            related=[Related(link.target.place, f"{link.target.node.name} is at the other end") for link in found],
            node=source.node.name,
            identity=(high, low, source.name or "", source.node.name or ""),
        )


@rule("ARC003")
def missing_connection(system: System, options: Options) -> Iterator[Finding]:
    """Contracts whose connection is not there."""
    for contract in options.contracts:
        if contract.kind != REQUIRE or not _concerned(system, contract):
            continue
        missing = _missing_link(system, contract) if contract.source else _missing_end(system, contract)
        if missing is not None:
            yield finding(
                "ARC003",
                contract.place,
                f"{missing}, which the contract '{contract.name}' requires",
                help="make the connection, or change the contract",
                identity=(contract.name,),
            )


def _concerned(system: System, contract: Contract) -> bool:
    """Whether a contract is to be held against this system: it has a node or topic of each name in it; the
    system of all nodes is asked where no launch file starts them."""
    if system.name is not None:
        return _has_all(system, contract)
    others = [] if system.world is None else system.world.systems
    return not any(other.name is not None and _has_all(other, contract) for other in others)


def _has_all(system: System, contract: Contract) -> bool:
    wanted = (contract.source, contract.target, contract.publisher, contract.subscriber)
    return all(any(_is(globs, node) for node in system.nodes) for globs in wanted if globs) and (
        not contract.topic or any(matches(contract.topic, name) for name in system.topics)
    )


def _missing_link(system: System, contract: Contract) -> str | None:
    """What is missing between nodes, in words: each ``from`` is to be connected to some ``to``."""
    source, target = " or ".join(contract.source), " or ".join(contract.target)
    starts = [node for node in system.nodes if _is(contract.source, node)]
    reached = {id(link.source.node) for link in links(system) if _goes(contract.source, contract.target, link)}
    if not starts:
        return f"there is no node {source} to connect to {target}"
    lost = [node for node in starts if id(node) not in reached and _followed(node)]
    if not lost or not all(_followed(node) for node in system.nodes if _is(contract.target, node)):
        return None
    return f"nothing goes from {lost[0].name} to {target}"


def _missing_end(system: System, contract: Contract) -> str | None:
    topics = [topic for name, topic in system.topics.items() if matches(contract.topic, name)]
    for globs, kind, does in (
        (contract.publisher, PUBLISHER, "publish"),
        (contract.subscriber, SUBSCRIBER, "subscribe to"),
    ):
        if not globs:
            continue
        name = " or ".join(contract.topic)
        nodes = [node for node in system.nodes if _is(globs, node)]
        if not nodes:
            return f"there is no node {' or '.join(globs)} to {does} {name}"
        there = {id(end.node) for topic in topics for end in (*topic.providers, *topic.users) if end.kind == kind}
        lost = [node for node in nodes if id(node) not in there and _followed(node, kind)]
        if lost:
            return f"{lost[0].name} does not {does} {name}"
    return None


def _followed(node: Node, kind: str | None = None) -> bool:
    """Whether everything that a node has is known, so that what is missing is missing."""
    return not node.external and all(end.resolved for end in node.endpoints if kind in (None, end.kind))


def _is(globs: Globs, node: Node) -> bool:
    return node.name is not None and not node.test and matches(globs, node.name, node.package)
