"""How ends, nodes and quality of service are put into Markdown."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, zip_longest
from typing import TYPE_CHECKING

from archlint.model import EntityKind
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.ros.qos import Qos
    from archlint.systems.nodes import Endpoint, Node

_VERBS = {
    EntityKind.PUBLISHER: "publishes",
    EntityKind.SUBSCRIBER: "subscribes to",
    EntityKind.SERVICE: "serves",
    EntityKind.CLIENT: "calls",
    EntityKind.ACTION_SERVER: "serves the action",
    EntityKind.ACTION_CLIENT: "sends goals to",
}
MOST = 10
"""How many ends of one side are listed."""
_OF_TOPICS = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)


def code(text: str) -> str:
    """A text of the user's as code in Markdown."""
    shown = visible(text)
    return f"`` {shown} ``" if "`" in shown else f"`{shown}`"


def where(place: Place) -> str:
    return f"{visible(place.file)}:{place.line}"


def qos_words(qos: Qos) -> str:
    """``reliable, volatile, keep last 10``; what is not known is left out."""
    words = [
        policy.replace("_", " ") for policy in (qos.reliability, qos.durability, qos.history) if policy is not None
    ]
    if qos.history == "keep_last" and qos.depth is not None:
        words[-1] = f"keep last {qos.depth}"
    return ", ".join(words)


def ends_list(words: str, ends: Sequence[Endpoint], rates: Sequence[float | None]) -> str:
    """The ends on one side of a connection, each with its node, place and, if known, messages a second."""
    if not ends:
        return f"{words} nothing in this workspace"
    told = [f"- {_end_words(end, rate)}" for end, rate in islice(zip_longest(ends, rates), MOST)]
    more = [f"- and {len(ends) - MOST} more"] if len(ends) > MOST else []
    return "\n".join([words, *told, *more])


def _end_words(end: Endpoint, rate: float | None) -> str:
    node = code(end.node.name) if end.node.name else "a node that is not known"
    notes = [qos_words(end.qos)] if end.qos is not None and end.kind in _OF_TOPICS else []
    notes += [f"{rate:g} Hz"] if rate is not None else []
    notes += ["under a condition"] if end.conditional else []
    launched = f" ({visible(end.node.launched_by)})" if end.node.launched_by else ""
    return f"{node}: {', '.join([*notes, where(end.place)])}{launched}"


def node_words(node: Node) -> Iterator[str]:
    """A node with what it creates."""
    name = code(node.name) if node.name else "a node whose name is not known"
    blueprint = node.blueprint
    if blueprint is None:
        yield f"node {name}, whose source is not {'followed' if node.unfollowed else 'in this workspace'}"
        return
    yield f"node {name}: class {code(blueprint.class_name)}, {where(blueprint.place)}"
    rows = [
        f"- {_VERBS[end.kind]} {code(end.name)}" + (f" ({code(end.type)})" if end.type else "")
        for end in node.endpoints
        if end.name is not None and not end.error
    ]
    rows += [f"- timer every {timer.period:g} s" for timer in node.timers if timer.period]
    rows += [f"- parameter {code(p.name.text)}" for p in node.parameters if p.name.text is not None]
    if rows:
        yield "\n".join(dict.fromkeys(rows))


__all__ = ["code", "ends_list", "node_words", "qos_words", "where"]
