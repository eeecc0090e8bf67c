"""OWN002: services and actions that more than one node serves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.owner_findings import all_of, finding_for_owners
from archlint.checks.registry import Options, rule
from archlint.checks.scope import Scope
from archlint.connections.owners import several_owners, some_coexist
from archlint.finding import Finding

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("OWN002", scope=Scope.SYSTEM)
def multiple_servers(system: System, options: Options) -> Iterator[Finding]:
    """Services and actions with servers in several nodes that run together: what nothing starts so are variants."""
    for connection in (*system.services.values(), *system.actions.values()):
        for owners in several_owners(system, connection):
            if not some_coexist(system, owners):
                continue
            yield finding_for_owners(
                "OWN002",
                owners,
                f"{all_of(owners)} serve the {connection.kind} '{connection.name}': every request reaches all of them",
                "serves it here",
                "give each server its own name, such as a private one ('~/…')",
            )


@folds("OWN002")
def _of_the_same_nodes(findings: Sequence[Finding]) -> Finding:
    """One finding for all that the same nodes serve."""
    return with_others(findings, "another name is", "more names are", "served by all of them, too")
