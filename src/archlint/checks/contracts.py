"""ARC001: connections that a contract of the configuration rules out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.architecture import FORBID, INDEPENDENT, QOS, TYPES, Contract, Globs
from archlint.checks.contract_terms import other_qos, other_types
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.links import Link, by_source, is_meant, links
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


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
            yield from other_types(system, contract)
        elif contract.kind == QOS:
            yield from other_qos(system, contract)


def _ties(groups: Iterable[Globs], link: Link) -> bool:
    """Whether a connection leads from one of the groups into another."""
    mine = {globs for globs in groups if is_meant(globs, link.source.node)}
    yours = {globs for globs in groups if is_meant(globs, link.target.node)}
    return bool(mine) and bool(yours) and mine.isdisjoint(yours)


def _broken(contract: Contract, chosen: Iterable[Link]) -> Iterator[Finding]:
    for outgoing in by_source(chosen):
        source = outgoing[0].source
        yield finding(
            "ARC001",
            source.place,
            f"{outgoing[0].words()}, which the contract '{contract.name}' forbids",
            help="connect them through a node in between, or change the contract",
            related=[
                *(Related(link.target.place, f"{link.target.node.shown} is at the other end") for link in outgoing),
                Related(contract.place, "the contract is here"),
            ],
            node=source.node.name,
            identity=(contract.name, source.name or "", source.node.name or ""),
        )
