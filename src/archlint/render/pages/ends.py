"""Tables of what a node has: topics, services, actions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.model import EntityKind, Role
from archlint.render.look import qos_words
from archlint.render.markdown import code, table, text

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.render.pages.site import Site
    from archlint.systems.nodes import Endpoint, Node

_OF_MESSAGES = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)
_TITLES: Mapping[EntityKind, tuple[str, str]] = {
    EntityKind.PUBLISHER: ("Publishes", "Topic"),
    EntityKind.SUBSCRIBER: ("Subscribes to", "Topic"),
    EntityKind.SERVICE: ("Serves", "Service"),
    EntityKind.CLIENT: ("Calls", "Service"),
    EntityKind.ACTION_SERVER: ("Performs actions", "Action"),
    EntityKind.ACTION_CLIENT: ("Sends goals", "Action"),
}
_HANDLERS = {
    EntityKind.SUBSCRIBER: Role.SUBSCRIPTION,
    EntityKind.SERVICE: Role.SERVICE,
    EntityKind.ACTION_SERVER: Role.EXECUTE,
}
"""The callback whose docstring says what an endpoint is for."""


def sections(node: Node, rates: Mapping[int, float], site: Site, page: str) -> Iterator[str]:
    """A section for each kind of endpoints that the node has.  ``rates`` are messages a second by ``id`` of the
    creation of a publisher."""
    for kind, (title, column) in _TITLES.items():
        ends = sorted(node.of_kind(kind), key=lambda end: (end.name is None, end.name or "", end.place))
        if ends:
            titles = (column, "Type", "QoS", "Rate", "What for", "Source")
            yield f"## {title}"
            yield "\n".join(table(titles, [_row(end, rates, site, page) for end in ends]))


def _row(end: Endpoint, rates: Mapping[int, float], site: Site, page: str) -> Sequence[str]:
    return (
        name_cell(end),
        code(end.type) if end.type is not None else "not known",
        text(qos_words(end.qos)) if end.qos is not None and end.kind in _OF_MESSAGES else "",
        rate_words(rates.get(id(end.creation))),
        _purpose(end),
        site.source_link(end.place, page),
    )


def name_cell(end: Endpoint) -> str:
    """The name of an endpoint, with what decides it and whether it is always there."""
    notes = []
    if end.error is not None:
        notes.append(f"refused by ROS: {text(end.error)}")
    if end.parameter is not None:
        notes.append(f"from parameter {code(end.parameter)}")
    if end.resolution == "partial":
        notes.append(f"`*` is known only at run time: {text(end.reason or '')}".removesuffix(": "))
    if end.conditional:
        notes.append("only under a condition")
    if end.name is None:
        return "; ".join([f"not known: {text(end.reason or 'no reason is recorded')}", *notes])
    return "; ".join([code(end.name), *notes])


def rate_words(rate: float | None) -> str:
    """Messages a second, where timers decide it."""
    return "" if rate is None else f"{rate:.4g} Hz"


def _purpose(end: Endpoint) -> str:
    """The first sentence of the callback's docstring, or the name of the callback."""
    callback = end.creation.callbacks.get(_HANDLERS[end.kind]) if end.kind in _HANDLERS else None
    if callback is None:
        return ""
    return summary(callback.docstring) or callback_name(callback)


def callback_name(callback: Callback) -> str:
    """The function that is called; nothing where it is not known."""
    return "" if callback.name == "?" else code(callback.name)


def summary(docstring: str) -> str:
    """The first paragraph of a docstring, on one line."""
    return text(" ".join(docstring.split("\n\n")[0].split()))


__all__ = ["callback_name", "name_cell", "rate_words", "sections", "summary"]
