"""Subscriptions to topics of the workspace's own that nothing in it sends: their callbacks do not run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.analysis.left_over import is_left_over
from archlint.model import EntityKind, Role

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import Callback
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint

_FOR_ANYTHING = "std_msgs"
"""The package of types that say nothing of who sends them: no driver has a topic of them under everybody's name."""

_NAMESPACE = 2
"""How many parts of a name come with its namespace: the empty one before its '/', and that."""


def is_sent_by_nobody(system: System, callback: Callback) -> bool:
    """Whether a callback is one for messages of the workspace's own that no code of it publishes.  What a driver or a
    simulator may send, and what arrives under a name that is not known, may come all the same."""
    subscription = callback.creation
    if callback.role is not Role.SUBSCRIPTION or subscription is None:
        return False
    ends = _subscriptions(system).get(subscription.place, [])
    return bool(ends) and all(_is_own(system, end) and not _may_be_sent(system, end) for end in ends)


@once
def _subscriptions(system: System) -> dict[Place, list[Endpoint]]:
    """The subscriptions of all nodes, by the place where they are made."""
    ends: dict[Place, list[Endpoint]] = {}
    for end in system.all_endpoints:
        if end.kind == EntityKind.SUBSCRIBER:
            ends.setdefault(end.place, []).append(end)
    return ends


def _is_own(system: System, end: Endpoint) -> bool:
    """Whether it is for the workspace to send what a subscription is for: its type is one of its own or one for
    anything, or it sends the same to another robot."""
    package = (end.type or "").partition("/")[0]
    if package == _FOR_ANYTHING or (system.workspace is not None and package in system.workspace.packages):
        return True
    words = _last_words(end)
    return words is not None and any(
        other.type == end.type and _last_words(other) == words for other in _publishers(system)
    )


def _last_words(end: Endpoint) -> tuple[str, ...] | None:
    """What follows the namespace in front: ``state/battery`` of ``/left/state/battery``."""
    words = (end.name or "").split("/")
    return tuple(words[_NAMESPACE:]) or None


def _may_be_sent(system: System, end: Endpoint) -> bool:
    if end.name is None or not end.resolved or end.type is None or end.node.blueprint is None:
        return True
    if system.workspace is not None:
        launched = system.workspace.launched_names(end.node.blueprint, end.kind, end.place)
        if not launched <= {end.name}:
            return True
    return any(
        other.type in (None, end.type) and (not other.resolved or other.name == end.name)
        for other in _publishers(system)
        if not is_left_over(system.workspace, other)
    )


@once
def _publishers(system: System) -> list[Endpoint]:
    return [end for end in system.all_endpoints if end.kind == EntityKind.PUBLISHER]


__all__ = ["is_sent_by_nobody"]
