"""Nodes that tell each other whose turn it is, by topics of flags and words between them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.systems.nodes import Endpoint, Node

_SIGNALS = frozenset(
    f"std_msgs/msg/{name}"
    for name in ("Bool", "Empty", "Int8", "Int16", "Int32", "String", "UInt8", "UInt16", "UInt32")
)
"""Messages that say one thing, such as which of two nodes is to work."""
_OF_TURNS = frozenset(
    {"activate", "active", "busy", "complete", "completed", "control", "done", "enable", "enabled", "finished", "go"}
    | {"handover", "mode", "ready", "release", "start", "started", "state", "status", "stop", "stopped", "takeover"}
    | {"trigger", "turn"}
)
"""Words for who is to work, and whether it does: a display, a measurement or the result of a test is none of them."""


def hand_over(owners: Sequence[Endpoint]) -> bool:
    """Whether each of several nodes that publish a topic tells another of them something on a topic of its own, and is
    told something in turn: ``local_planner_trigger`` one way, ``planner_state`` the other."""
    shared, nodes = owners[0].name, list({id(end.node): end.node for end in owners}.values())
    pairs = [(node, other) for node in nodes for other in nodes if node is not other and _tells(node, other, shared)]
    tell, hear = ({id(pair[side]) for pair in pairs} for side in (0, 1))
    return all(id(node) in tell and id(node) in hear for node in nodes)


def _tells(node: Node, other: Node, shared: str | None) -> bool:
    """Whether a node publishes signals to which another one subscribes, and whose names speak of turns."""
    said, heard = (
        {end.name for end in each.of_kind(kind) if end.resolved and end.type in _SIGNALS}
        for each, kind in ((node, EntityKind.PUBLISHER), (other, EntityKind.SUBSCRIBER))
    )
    return any(_speaks_of_turns(name) for name in said & heard if name is not None and name != shared)


def _speaks_of_turns(topic: str) -> bool:
    return not _OF_TURNS.isdisjoint(topic.rpartition("/")[2].lower().split("_"))


__all__ = ["hand_over"]
