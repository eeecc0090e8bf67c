"""Ends of one name between which nothing ever gets through: incompatible QoS, or different types."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import (
    are_alternatives,
    are_both_external,
    certain,
    coexist,
    first_in_source,
    in_source_order,
    launched_separately,
)
from archlint.analysis.kept import once
from archlint.connections.own_types import is_defined
from archlint.model import EntityKind
from archlint.records import dataclass
from archlint.ros.qos import Verdict, compatible

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint, Node


@dataclass(frozen=True)
class Undelivered:
    """A publisher (``offer``) and a subscription (``request``) that never connect, and the policies that say so."""

    offer: Endpoint
    request: Endpoint
    verdicts: tuple[Verdict, ...]

    @property
    def reason(self) -> str:
        """``best effort offered, reliable requested``, for each policy."""
        return "; ".join(
            f"{policy_words(verdict, verdict.offered)} offered, {policy_words(verdict, verdict.requested)} requested"
            for verdict in self.verdicts
        )


@dataclass(frozen=True)
class Mistyped:
    """A provider (``offer``) and a user (``request``) of one name with different types, which never connect."""

    offer: Endpoint
    request: Endpoint

    @property
    def reason(self) -> str:
        """``String published, Int32 subscribed``, with full types where the short ones are the same."""
        provided, used = _DONE[self.offer.kind == EntityKind.PUBLISHER]
        types = [self.offer.type or "?", self.request.type or "?"]
        short = [type_.rpartition("/")[2] for type_ in types]
        offered, requested = short if short[0] != short[1] else types
        return f"{offered} {provided}, {requested} {used}"


_DONE = {True: ("published", "subscribed"), False: ("served", "called")}


def mistyped_on(system: System, connection: Connection) -> Iterator[Mistyped]:
    """The pairs of one topic, service or action that exist at the same time and whose types are known and differ, of as
    many as in :func:`undelivered_on`."""
    if len(connection.types) < 2:
        return
    offers = first_in_source(end for end in connection.providers if certain(end) and end.type is not None)
    for request in first_in_source(end for end in connection.users if certain(end) and end.type is not None):
        for offer in offers:
            if offer.type != request.type and not are_both_external(offer, request) and _meet(system, offer, request):
                yield Mistyped(offer, request)


def _meet(system: System, offer: Endpoint, request: Endpoint) -> bool:
    any_package = _are_for_each_other(system, offer, request)
    return coexist(system, offer, request, any_package) and not _never_both(system, offer.node, request.node)


def _are_for_each_other(system: System, offer: Endpoint, request: Endpoint) -> bool:
    """Whether two ends of one name have types that the workspace itself defines: in whichever of its packages they are,
    nobody else is likely to have the other end."""
    workspace = system.workspace
    types = {end.type for end in (offer, request)}
    return workspace is not None and all(type_ is not None and is_defined(workspace, type_) for type_ in types)


@once
def undelivered(system: System) -> Sequence[Undelivered]:
    """All such pairs of a system, by topic and in source order."""
    return [pair for topic in system.topics.values() for pair in undelivered_on(system, topic)]


def undelivered_on(system: System, topic: Connection) -> Iterator[Undelivered]:
    """The pairs of one topic that exist at the same time and whose profiles are known, of the first
    :data:`~archlint.analysis.coexistence.MOST_ENDS` on each side."""
    offers = first_in_source(end for end in topic.providers if _judged(end))
    for request in first_in_source(end for end in topic.users if _judged(end)):
        for offer in offers:
            errors = tuple(_errors(offer, request))
            if errors and not are_both_external(offer, request) and _meet(system, offer, request):
                yield Undelivered(offer, request, errors)


def _never_both(system: System, node: Node, other: Node) -> bool:
    """Whether two nodes are only seen as alternatives: by what they publish, or by the launch files that start them."""
    return node is not other and (launched_separately(system, node, other) or are_alternatives(system, node, other))


def fitting(system: System, request: Endpoint) -> list[Endpoint]:
    """The publishers of a subscription's topic that can run along with it and whose messages it gets."""
    topic = system.topics.get(request.name or "")
    return [
        offer
        for offer in in_source_order(end for end in (topic.providers if topic is not None else ()) if _judged(end))
        if not _errors(offer, request) and coexist(system, offer, request)
    ]


def fits_any(system: System, request: Endpoint) -> bool:
    """Whether any publisher of a subscription's topic suits it, be it one that is not known to run along with it."""
    topic = system.topics.get(request.name or "")
    offers = [] if topic is None else topic.providers
    return any(_judged(offer) and not _errors(offer, request) for offer in offers)


def policy_words(verdict: Verdict, value: str | float | None) -> str:
    """What one side says of a policy: ``best effort``, ``a deadline of 0.1 s``."""
    policy = verdict.policy.replace("_", " ")
    if isinstance(value, str):
        return f"{value.replace('_', ' ')} {policy}" if verdict.policy == "liveliness" else value.replace("_", " ")
    return f"a {policy} of {value:g} s" if value else f"no {policy}"


def _judged(end: Endpoint) -> bool:
    return certain(end) and end.qos is not None and not end.qos.overridable and end.qos.parameter is None


def _errors(offer: Endpoint, request: Endpoint) -> list[Verdict]:
    assert offer.qos is not None and request.qos is not None
    return [verdict for verdict in compatible(offer.qos, request.qos) if verdict.level == "error"]
