"""The page of a node: what it is, what it offers and what it needs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from archlint.model import ExecutorKind
from archlint.render.markdown import code, paragraphs, table, text
from archlint.render.pages import ends, needs, parameters
from archlint.render.pages.site import called

if TYPE_CHECKING:
    from archlint.model import Blueprint
    from archlint.render.pages.site import Site
    from archlint.systems.model import System
    from archlint.systems.nodes import Node

_EXECUTORS = {
    ExecutorKind.SINGLE_THREADED: "one thread",
    ExecutorKind.MULTI_THREADED: "several threads",
}
_MOST_GAPS = 20


def node_page(node: Node, system: System | None, rates: Mapping[int, float], site: Site, page: str) -> str:
    """The page about a node as its code makes it.

    ``system`` is the one that it is in; ``rates`` are messages a second by ``id`` of the creation of a publisher.
    """
    blueprint = node.blueprint
    assert blueprint is not None
    blocks = [
        f"# {text(node.name) if node.name is not None else called(node)}",
        *paragraphs(blueprint.docstring),
        "\n".join(_facts(node, blueprint, site, page)),
        *ends.sections(node, rates, site, page),
        *parameters.section(node, site, page),
        *_timers(node, site, page),
        *needs.section(node, system, site, page),
        *_started(node, site, page),
        *_unknown(node, site, page),
    ]
    return "\n\n".join(blocks)


def _facts(node: Node, blueprint: Blueprint, site: Site, page: str) -> Iterator[str]:
    if node.name is None:
        yield f"- Name: not known: {text(blueprint.name.reason or 'no reason is recorded')}"
    elif blueprint.name.parameter is not None:
        yield f"- Name: from parameter {code(blueprint.name.parameter)}"
    kind = "Lifecycle node" if blueprint.lifecycle else "Node"
    yield f"- {kind}: {code(blueprint.class_name)}, {site.source_link(blueprint.place, page)}"
    if node.package is not None:
        yield f"- Package: {code(node.package)}"
    for executable in node.executables:
        yield f"- Run alone: {code(f'ros2 run {node.package} {executable}')}"
    if node.executor in _EXECUTORS:
        yield f"- Callbacks run in {_EXECUTORS[node.executor]}"


def _started(node: Node, site: Site, page: str) -> Iterator[str]:
    """The launch files that start the node, with the names that it gets there."""
    rows = []
    for target, system in site.systems.items():
        here = [other for other in system.nodes if site.page_of(other) == page]
        others = sorted({code(other.name) for other in here if other.name not in (None, node.name)})
        if here:
            rows.append(f"- {site.system_link(target, page)}" + (f" as {' and '.join(others)}" if others else ""))
    if rows:
        yield "## Started by"
        yield "\n".join(rows)


def _timers(node: Node, site: Site, page: str) -> Iterator[str]:
    rows = []
    for timer in node.timers:
        period = "not known" if timer.period is None else f"{timer.period:.4g} s"
        note = f" (parameter {code(timer.period_parameter)})" if timer.period_parameter is not None else ""
        callback = next(iter(timer.callbacks.values()), None)
        name = "" if callback is None else ends.callback_name(callback)
        purpose = "" if callback is None else ends.summary(callback.docstring)
        rows.append((f"{period}{note}", name, purpose, site.source_link(timer.place, page)))
    if rows:
        yield "## Timers"
        yield "\n".join(table(("Period", "Callback", "What for", "Source"), rows))


def _unknown(node: Node, site: Site, page: str) -> Iterator[str]:
    """What of the node's code could not be followed: the page may lack something."""
    gaps = sorted({gap for blueprint in node.blueprints for gap in blueprint.gaps})
    if not gaps:
        return
    yield "## Not known"
    yield "This page may lack something, because not all of the code could be followed."
    rows = [f"- {text(reason)}: {site.source_link(place, page)}" for place, reason in gaps[:_MOST_GAPS]]
    more = [f"- … and {len(gaps) - _MOST_GAPS} more"] if len(gaps) > _MOST_GAPS else []
    yield "\n".join([*rows, *more])


__all__ = ["node_page"]
