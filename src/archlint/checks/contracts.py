"""OWN003, ARC001 and ARC002: what the system has, against the architecture that the configuration declares."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import in_source_order
from archlint.analysis.links import Link, by_source, connections, counts, is_meant, links, named
from archlint.architecture import FORBID, INDEPENDENT, QOS, TYPES, Contract, Globs, matches
from archlint.checks.launched_names import is_renamed
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
)
from archlint.ros.qos import allowed

if TYPE_CHECKING:
    from archlint.systems.model import Connection, Endpoint, System


@rule("OWN003", scope=Scope.SYSTEM)
def not_the_declared_owner(system: System, options: Options) -> Iterator[Finding]:
    """Publishers and servers of names that the configuration gives to another node."""
    for connection in connections(system):
        declared = [name for name in options.owners if matches((name,), connection.name)]
        # The more specific declaration counts: the name itself before a pattern.
        declared.sort(key=lambda name: (name != connection.name, -len(name), name))
        if not declared:
            continue
        owners = options.owners[declared[0]]
        for end in in_source_order(end for end in connection.providers if counts(end)):
            if not is_meant(owners, end.node) and not is_renamed(system, end.node):
                yield _not_the_owner(connection, end, owners)


def _not_the_owner(connection: Connection, end: Endpoint, owners: Globs) -> Finding:
    does = "publishes" if end.kind == EntityKind.PUBLISHER else "serves"
    others = [other for other in connection.providers if counts(other) and is_meant(owners, other.node)]
    return finding(
        "OWN003",
        end.place,
        f"{end.node.name} {does} '{connection.name}', which belongs to {' or '.join(owners)}",
        help=f"let the owner {'publish' if does == 'publishes' else 'serve'} it, or list this node under [owners]",
        related=[Related(other.place, f"{other.node.name}, the owner, {does} it here") for other in others],
        node=end.node.name,
        identity=(end.kind, connection.name, end.node.name or ""),
    )


@rule("ARC001", scope=Scope.SYSTEM)
def forbidden_connection(system: System, options: Options) -> Iterator[Finding]:
    """Connections that a contract rules out, one finding for each end and contract."""
    for contract in options.contracts:
        if contract.kind == FORBID:
            chosen = [link for link in links(system, contract.source, contract.target) if link.goes(contract)]
            yield from _broken(contract, chosen)
        elif contract.kind == INDEPENDENT:
            groups = [(glob,) for glob in contract.nodes]
            yield from _broken(contract, [link for link in links(system, *groups) if _ties(groups, link)])
        elif contract.kind == TYPES:
            yield from _other_types(system, contract)
        elif contract.kind == QOS:
            yield from _other_qos(system, contract)


def _ties(groups: Iterable[Globs], link: Link) -> bool:
    """Whether a connection leads from one of the groups into another."""
    mine = {globs for globs in groups if is_meant(globs, link.source.node)}
    yours = {globs for globs in groups if is_meant(globs, link.target.node)}
    return bool(mine) and bool(yours) and mine.isdisjoint(yours)


def _broken(contract: Contract, chosen: Iterable[Link]) -> Iterator[Finding]:
    for found in by_source(chosen):
        source = found[0].source
        yield finding(
            "ARC001",
            source.place,
            f"{found[0].words()}, which the contract '{contract.name}' forbids",
            help="connect them through a node in between, or change the contract",
            related=[
                *(Related(link.target.place, f"{link.target.node.name} is at the other end") for link in found),
                Related(contract.place, "the contract is here"),
            ],
            node=source.node.name,
            identity=(contract.name, source.name or "", source.node.name or ""),
        )


def _other_types(system: System, contract: Contract) -> Iterator[Finding]:
    for connection in named(system, contract):
        for end in in_source_order((*connection.providers, *connection.users)):
            if end.type is None or not counts(end) or any(fnmatchcase(end.type, glob) for glob in contract.types):
                continue
            yield _differs(
                contract,
                connection,
                end,
                f"uses '{connection.name}' as {end.type}",
                " or ".join(contract.types),
                "use a type that the contract allows, or change the contract",
            )


def _other_qos(system: System, contract: Contract) -> Iterator[Finding]:
    for topic in named(system, contract):
        for end in in_source_order((*topic.providers, *topic.users)):
            if end.qos is None or not counts(end) or not _is_an_end_of(contract, end):
                continue
            if end.qos.overridable or end.qos.parameter is not None:
                continue
            for policy, values in contract.policies:
                if allowed(end.qos, policy.replace("-", "_"), values) is False:
                    yield _wrong_policy(contract, topic, end, policy, values)


def _is_an_end_of(contract: Contract, end: Endpoint) -> bool:
    """Whether a contract about QoS asks for this end: for all of them where it names no node."""
    if not contract.provider and not contract.user:
        return True
    return is_meant(contract.provider if end.kind == EntityKind.PUBLISHER else contract.user, end.node)


def _wrong_policy(
    contract: Contract, topic: Connection, end: Endpoint, policy: str, values: tuple[str | float, ...]
) -> Finding:
    does = "publishes" if end.kind == EntityKind.PUBLISHER else "subscribes to"
    given = getattr(end.qos, policy.replace("-", "_"))
    unit = "" if isinstance(given, str) or policy == "depth" else " s"
    words = f"no {policy}" if given is None else f"{policy} {given}{unit}"
    return _differs(
        contract,
        topic,
        end,
        f"{does} '{topic.name}' with {words}",
        " or ".join(str(value) + unit for value in values) if given is not None else f"{policy} {values[0]} s",
        f"set the {policy} that the contract allows, or change the contract",
        (policy,),
    )


def _differs(
    contract: Contract,
    connection: Connection,
    end: Endpoint,
    does: str,
    wanted: str,
    help: str,
    more: tuple[str, ...] = (),
) -> Finding:
    return finding(
        "ARC001",
        end.place,
        f"{end.node.name} {does}; the contract '{contract.name}' allows {wanted}",
        help=help,
        related=[Related(contract.place, "the contract is here")],
        node=end.node.name,
        identity=(contract.name, connection.name, end.node.name or "", *more),
    )


@rule("ARC002", scope=Scope.SYSTEM)
def layer_violation(system: System, options: Options) -> Iterator[Finding]:
    """Connections between nodes of layers that are not neighbours."""
    layers = options.layers
    if layers is None:
        return
    skipping = []
    for link in links(system, *(layers.members[name] for name in layers.order)):
        mine = layers.of(link.source.node.name or "", link.source.node.package)
        yours = layers.of(link.target.node.name or "", link.target.node.package)
        if mine and yours and all(abs(here - there) > 1 for here in mine for there in yours):
            skipping.append(link)
    for found in by_source(skipping):
        source, target = found[0].source, found[0].target
        high = layers.order[layers.of(source.node.name or "", source.node.package)[0]]
        low = layers.order[layers.of(target.node.name or "", target.node.package)[0]]
        yield finding(
            "ARC002",
            source.place,
            f"{found[0].words()}: the layers '{high}' and '{low}' are not adjacent",
            help="connect them through a node of the layer in between",
            related=[Related(link.target.place, f"{link.target.node.name} is at the other end") for link in found],
            node=source.node.name,
            identity=(high, low, source.name or "", source.node.name or ""),
        )
