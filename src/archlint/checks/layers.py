"""ARC002: connections between layers that are not neighbours."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.links import by_source, links
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


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
    for outgoing in by_source(skipping):
        source, target = outgoing[0].source, outgoing[0].target
        high = layers.order[layers.of(source.node.name or "", source.node.package)[0]]
        low = layers.order[layers.of(target.node.name or "", target.node.package)[0]]
        yield finding(
            "ARC002",
            source.place,
            f"{outgoing[0].words()}: the layers '{high}' and '{low}' are not adjacent",
            help="connect them through a node of the layer in between",
            related=[Related(link.target.place, f"{link.target.node.shown} is at the other end") for link in outgoing],
            node=source.node.name,
            identity=(high, low, source.name or "", source.node.name or ""),
        )
