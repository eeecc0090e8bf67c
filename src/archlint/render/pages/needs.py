"""What a node needs of others to do its work: servers and publishers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.model import EntityKind
from archlint.render.markdown import code, table

if TYPE_CHECKING:
    from archlint.render.pages.site import Site
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

_NEEDED = (EntityKind.CLIENT, EntityKind.ACTION_CLIENT, EntityKind.SUBSCRIBER)
_WORDS = {EntityKind.CLIENT: "service", EntityKind.ACTION_CLIENT: "action", EntityKind.SUBSCRIBER: "topic"}


def section(node: Node, system: System | None, site: Site, page: str) -> Iterator[str]:
    """What others have to offer, and who does so in this workspace."""
    rows: list[tuple[str, str]] = []
    seen: set[tuple[EntityKind, str]] = set()
    for kind in _NEEDED:
        for end in sorted(node.of_kind(kind), key=lambda end: end.name or ""):
            if end.name is not None and end.error is None and (kind, end.name) not in seen:
                seen.add((kind, end.name))
                rows.append(_row(end, end.name, system, site, page))
    if rows:
        yield "## Needs"
        yield "\n".join(table(("What", "From"), rows))


def _row(end: Endpoint, name: str, system: System | None, site: Site, page: str) -> tuple[str, str]:
    what = f"{_WORDS[end.kind]} {code(name)}"
    if not end.resolved:
        return what, "not known: the name is known only at run time"
    providers = [] if system is None else _providers(end, name, system)
    if providers:
        return what, site.node_links(providers, page)
    return what, "" if system is None else "no node of this workspace, under this name"


def _providers(end: Endpoint, name: str, system: System) -> list[Node]:
    """The nodes that run together with the one of an end and offer its other end; test code offers nothing."""
    connection = _connections(end, system).get(name)
    nodes = [] if connection is None else [provider.node for provider in connection.providers]
    return [node for node in nodes if not node.test and (node is end.node or system.may_coexist(node, end.node))]


def _connections(end: Endpoint, system: System) -> dict[str, Connection]:
    match end.kind:
        case EntityKind.CLIENT:
            return system.services
        case EntityKind.ACTION_CLIENT:
            return system.actions
    return system.topics


__all__ = ["section"]
