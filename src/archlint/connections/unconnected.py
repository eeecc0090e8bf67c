"""Ends of one name between which nothing ever gets through, by QoS or by type, in whichever system they run."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.architecture import TOPIC
from archlint.connections.delivery import mistyped_on, undelivered_on
from archlint.records import dataclass
from archlint.systems.nodes import key_of
from archlint.systems.shape import connections

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint

_End = tuple[object, object]
"""The node class and the place of an end: the same in the system of all code and in a launched one."""


@dataclass(frozen=True)
class Unconnected:
    """A provider (``offer``) and a user (``request``) of one name, and why they never connect."""

    offer: Endpoint
    request: Endpoint
    reason: str


def unconnected_on(system: System, connection: Connection) -> Iterator[Unconnected]:
    """The pairs of one topic, service or action, each once.

    In the system of all code, those that a launch file starts together are judged as that starts them, under the names
    that they have then.
    """
    seen: set[tuple[int, int]] = set()
    for pair in (*_own(system, connection), *_of_launches(system, connection)):
        ends = (id(pair.offer), id(pair.request))
        if ends not in seen:
            seen.add(ends)
            yield pair


def _own(system: System, connection: Connection) -> Iterator[Unconnected]:
    for mistyped in mistyped_on(system, connection):
        yield Unconnected(mistyped.offer, mistyped.request, mistyped.reason)
    for lost in undelivered_on(system, connection) if connection.kind == TOPIC else ():
        yield Unconnected(lost.offer, lost.request, lost.reason)


def _of_launches(system: System, connection: Connection) -> Iterator[Unconnected]:
    if not system.launched_pairs:
        return
    reasons = _when_launched(system)
    for offer in connection.providers if reasons else ():
        for request in connection.users:
            reason = reasons.get((_end(offer), _end(request)))
            if reason is not None and system.in_same_launch(offer.node, request.node):
                yield Unconnected(offer, request, reason)


@once
def _when_launched(system: System) -> dict[tuple[_End, _End], str]:
    """The pairs that do not connect in what a launch file starts."""
    launched = [other for other in (system.workspace.systems if system.workspace else ()) if other.launched is not None]
    pairs: dict[tuple[_End, _End], str] = {}
    for other in launched:
        for pair in (pair for connection in connections(other) for pair in _own(other, connection)):
            pairs.setdefault((_end(pair.offer), _end(pair.request)), pair.reason)
    return pairs


def _end(end: Endpoint) -> _End:
    return (key_of(end.node.blueprint) if end.node.blueprint is not None else None, end.place)


__all__ = ["Unconnected", "unconnected_on"]
