"""The page that leads to all others: launch files, nodes by package, and what connects them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.render.markdown import code, table, text
from archlint.render.pages.ends import summary
from archlint.render.pages.site import INDEX

if TYPE_CHECKING:
    from archlint.architecture import ConnectionKind
    from archlint.render.pages.site import Site
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node

_COLUMNS: dict[ConnectionKind, tuple[str, str, str, str]] = {
    "topic": ("Topics", "Topic", "Published by", "Subscribed by"),
    "service": ("Services", "Service", "Served by", "Called by"),
    "action": ("Actions", "Action", "Performed by", "Asked by"),
}


def index_page(site: Site) -> str:
    """What there is, and where to read on."""
    blocks = ["# Nodes and systems", *_systems(site), *_packages(site)]
    for kind in _COLUMNS:
        blocks += _connections(site, kind)
    return "\n\n".join(blocks)


def _systems(site: Site) -> Iterator[str]:
    rows = [
        (
            site.system_link(page, INDEX),
            str(len(system.nodes)),
            "included by others" if system.is_included else "",
        )
        for page, system in site.systems.items()
    ]
    if rows:
        yield "## Launch files"
        yield "\n".join(table(("Launch file", "Nodes", "Note"), rows))


def _packages(site: Site) -> Iterator[str]:
    by_package: dict[str, list[Node]] = {}
    for node in site.nodes.values():
        by_package.setdefault(node.package or "", []).append(node)
    if by_package:
        yield "## Nodes"
    for package, nodes in sorted(by_package.items()):
        yield f"### {text(package) or 'In no package'} ({counted(len(nodes), 'node')})"
        titles = ("Node", "Executable", "What it is", "Topics", "Services", "Actions", "Parameters")
        yield "\n".join(table(titles, [_row(node, site) for node in nodes]))


def _row(node: Node, site: Site) -> tuple[str, ...]:
    assert node.blueprint is not None
    return (
        site.node_link(node, INDEX),
        ", ".join(map(code, node.executables)),
        summary(node.blueprint.docstring),
        _sides(node, "publisher", "out", "subscriber", "in"),
        _sides(node, "service", "offered", "client", "called"),
        _sides(node, "action_server", "offered", "action_client", "called"),
        str(len(node.parameters) or ""),
    )


def _sides(node: Node, first: str, first_word: str, second: str, second_word: str) -> str:
    """How many ends of two kinds the node has."""
    words = ((first, first_word), (second, second_word))
    counts = [(sum(end.kind == kind for end in node.endpoints), word) for kind, word in words]
    return ", ".join(f"{count} {word}" for count, word in counts if count)


def _connections(site: Site, kind: ConnectionKind) -> Iterator[str]:
    rows = [
        (
            code(name),
            " or ".join(map(code, connection.types)),
            site.node_links(_shown(connection.providers, site), INDEX),
            site.node_links(_shown(connection.users, site), INDEX),
        )
        for system in site.opened
        for name, connection in _of_kind(system, kind).items()
        if _shown((*connection.providers, *connection.users), site)
    ]
    if rows:
        title, name, providers, users = _COLUMNS[kind]
        yield f"## {title}"
        yield "Under the names that the code gives them; a launch file may change these."
        yield "\n".join(table((name, "Type", providers, users), sorted(rows)))


def _of_kind(system: System, kind: ConnectionKind) -> dict[str, Connection]:
    match kind:
        case "topic":
            return system.topics
        case "service":
            return system.services
        case "action":
            return system.actions


def _shown(ends: Iterable[Endpoint], site: Site) -> list[Node]:
    """The nodes of some ends that have a page."""
    return [end.node for end in ends if site.page_of(end.node) is not None]


__all__ = ["index_page"]
