"""The page of a system: what a launch file starts, and who talks to whom there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.connections.delivery import undelivered_on
from archlint.counted import counted
from archlint.render import render
from archlint.render.definitions import launch_arguments
from archlint.render.markdown import code, table, text
from archlint.render.pages.parameters import value_words

if TYPE_CHECKING:
    from archlint.render.pages.site import Site
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Node


def system_page(system: System, site: Site, page: str) -> str:
    """The page about what one launch file starts."""
    name = system.name or ""
    blocks = [
        f"# {text(name.rpartition('/')[2])}",
        "\n".join(_facts(system, name, site, page)),
        *_arguments(system),
        *_picture(system),
        *_nodes(system, site, page),
        *_connections("Topics", ("Topic", "Published by", "Subscribed by"), system, system.topics, site, page),
        *_connections("Services", ("Service", "Served by", "Called by"), system, system.services, site, page),
        *_connections("Actions", ("Action", "Performed by", "Asked by"), system, system.actions, site, page),
        *_unknown(system, site, page),
    ]
    return "\n\n".join(blocks)


def _facts(system: System, name: str, site: Site, page: str) -> Iterator[str]:
    launched = counted(len(system.nodes), "node")
    yield f"- Launch file: {site.file_link(name, page)}, which starts {launched}"
    package = None if system.workspace is None else system.workspace.package_of(name)
    if package is not None:
        yield f"- Start: {code(f'ros2 launch {package} ' + name.rpartition('/')[2])}"
    if system.is_included:
        yield "- Other launch files include it, perhaps in a namespace and with other arguments"
    for arguments, other in system.alternatives:
        words = " ".join(f"{key}:={value}" for key, value in arguments.items())
        yield f"- With {code(words)}: {counted(len(other.nodes), 'node')}"


def _arguments(system: System) -> Iterator[str]:
    rows = [
        (
            code(argument["name"]),
            "required" if argument["required"] else _default(argument["default"]),
            ", ".join(map(code, argument["choices"])),
        )
        for argument in launch_arguments(system)
    ]
    if rows:
        yield "## Launch arguments"
        yield "\n".join(table(("Name", "Default", "Choices"), rows))


def _default(words: str | None) -> str:
    return "not known" if words is None else value_words(words)


def _picture(system: System) -> Iterator[str]:
    """Who talks to whom; several pictures where one would be more than Mermaid takes."""
    if any(node.creations for node in system.nodes):
        picture = render("markdown", system)
        assert isinstance(picture, str)
        yield "## Picture"
        yield picture.rstrip()


def _nodes(system: System, site: Site, page: str) -> Iterator[str]:
    rows = [
        (
            site.node_link(node, page),
            _program(node),
            _condition(node),
            _settings(node),
            _remappings(node),
        )
        for node in sorted(system.nodes, key=lambda node: (node.name is None, node.name or "", node.package or ""))
    ]
    if rows:
        yield "## Nodes"
        yield "\n".join(table(("Node", "Program", "Started", "Parameters set", "Remappings"), rows))


def _program(node: Node) -> str:
    program = code("/".join(filter(None, (node.package, node.executable))))
    if node.blueprint is not None:
        return program
    return f"{program}, {'not followed' if node.unfollowed else 'not in this workspace'}"


def _condition(node: Node) -> str:
    return f"only with {code(node.condition)}" if node.condition else ""


def _settings(node: Node) -> str:
    values = dict(node.overrides) or {setting.name: setting.value for setting in node.settings}
    return "<br>".join(f"{code(name)} = {value_words(value)}" for name, value in sorted(values.items()))


def _remappings(node: Node) -> str:
    remaps = node.started.remaps if node.started is not None else ()
    known = ((remap.source.text or "?", remap.target.text or "?") for remap in remaps)
    return "<br>".join(f"{code(source)} → {code(target)}" for source, target in known)


def _connections(
    title: str,
    columns: tuple[str, str, str],
    system: System,
    connections: dict[str, Connection],
    site: Site,
    page: str,
) -> Iterator[str]:
    name, providers, users = columns
    rows = [_connection(system, connection, site, page) for connection in connections.values()]
    if rows:
        yield f"## {title}"
        yield "\n".join(table((name, "Type", providers, users, "Note"), rows))


def _connection(system: System, connection: Connection, site: Site, page: str) -> Sequence[str]:
    notes: list[str] = []
    if connection.kind == "topic":
        notes = [_lost(pair.offer.node, pair.request.node, pair.reason) for pair in undelivered_on(system, connection)]
    return (
        code(connection.name),
        " or ".join(map(code, connection.types)) or "not known",
        site.node_links((end.node for end in connection.providers), page),
        site.node_links((end.node for end in connection.users), page),
        "<br>".join(_once(notes)),
    )


def _lost(offers: Node, requests: Node, reason: str) -> str:
    pair = " to ".join(code(node.name or "?") for node in (offers, requests))
    return f"**no message gets from** {pair}: {text(reason)}"


def _unknown(system: System, site: Site, page: str) -> Iterator[str]:
    gaps = [] if system.launched is None else sorted(system.launched.not_followed(), key=lambda gap: gap.place)
    rows = [f"- {text(gap.reason)}: {site.source_link(gap.place, page)}" for gap in gaps]
    if rows:
        yield "## Not known"
        yield "\n".join(_once(rows))


def _once(rows: Iterable[str]) -> list[str]:
    return list(dict.fromkeys(rows))


__all__ = ["system_page"]
