"""OWN003: names that the configuration gives to another node."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import in_source_order
from archlint.architecture import Globs, matches
from archlint.checks.launched_names import is_renamed
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.links import connections, counts, is_meant
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
)

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint


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
        f"{end.node.shown} {does} '{connection.name}', which belongs to {' or '.join(owners)}",
        help=f"let the owner {'publish' if does == 'publishes' else 'serve'} it, or list this node under [owners]",
        related=[Related(other.place, f"{other.node.shown}, the owner, {does} it here") for other in others],
        node=end.node.name,
        identity=(end.kind, connection.name, end.node.name or ""),
    )
